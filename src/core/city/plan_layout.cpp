#include "core/city/plan_layout.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/base/random.h"
#include "core/city/lot_division.h"
#include "core/city/street_edges.h"
#include "core/geometry/convex_parts.h"
#include "core/geometry/polygon.h"
#include "core/geometry/straight_skeleton.h"

namespace pcg {

namespace {

// Zebra crossings at both ends of a stretch of street; narrower where a short one leaves less.
constexpr double crossing_width = 3.0;
constexpr float tile_size = 80.0f; // metres, about
constexpr double same_place = 1e-6; // metres

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

Loop2 without_doubles(const Loop2 &loop) {
	Loop2 kept;
	for (const glm::dvec2 &point : loop) {
		if (kept.empty() || glm::distance(kept.back(), point) > same_place) {
			kept.push_back(point);
		}
	}
	while (kept.size() > 1 && glm::distance(kept.back(), kept.front()) <= same_place) {
		kept.pop_back();
	}
	return kept;
}

class PlanBuilder {
public:
	PlanBuilder(const StreetPlan &plan, const LayoutParameters &p) : _plan(plan), _p(p), _edges(plan) {}

	bool has_room() const { return _edges.bad_nodes().empty(); }
	Layout build() {
		for (const glm::dvec2 &node : _plan.nodes) {
			_layout.junctions.push_back(to_ground(node));
		}
		for (uint32_t i = 0; i < _plan.streets.size(); ++i) {
			add_street(i);
		}
		for (uint32_t node = 0; node < _plan.nodes.size(); ++node) {
			add_junction(node);
		}
		for (const StreetPlan::Block &block : _plan.blocks) {
			add_block(block);
		}
		_layout.outline = to_ground(_edges.outline());
		std::reverse(_layout.outline.begin(), _layout.outline.end());
		_layout.seed = _p.seed;
		frame_layout(_layout);
		return std::move(_layout);
	}

private:
	void add_ground(GroundKind kind, const Loop2 &loop, BlockId block, uint32_t street) {
		const Loop2 clean = without_doubles(loop);
		if (clean.size() < 3 || signed_area(clean) < 1e-4) {
			return;
		}
		Polygons2 parts{ { clean } };
		if (!is_convex(clean)) {
			parts = convex_parts({ without_straight_points(clean, same_place) }, INFINITY);
		}
		for (const Loops2 &part : parts) {
			if (is_valid(block)) {
				_layout.blocks[index_of(block)].pavements.push_back(uint32_t(_layout.ground.size()));
			}
			_layout.ground.push_back({ kind, to_ground(part[0]), block, street });
		}
	}

	// A rectangle between its junctions; at each that joins more than two streets it begins with a crossing.
	void add_street(uint32_t id) {
		const StreetPlan::Street &street = _plan.streets[id];
		_layout.streets.push_back({ street.from, street.to, street.width });
		const StreetEdges::Arm &arm = _edges.arm(street.from, street.to);
		const glm::dvec2 side = glm::dvec2(-arm.direction.y, arm.direction.x) * arm.half_width;
		const glm::dvec2 start = _plan.nodes[street.from] + arm.direction * arm.cut;
		const double length = _edges.free_length(id), zebra = std::min(crossing_width, length / 4.0);
		const double first = _edges.arms(street.from).size() > 2 ? zebra : 0.0;
		const double last = length - (_edges.arms(street.to).size() > 2 ? zebra : 0.0);
		const auto add = [&](GroundKind kind, double from, double to) {
			const glm::dvec2 a = start + arm.direction * from, b = start + arm.direction * to;
			add_ground(kind, { a - side, b - side, b + side, a + side }, BlockId::Invalid, id);
		};
		add(GroundKind::Crossing, 0.0, first);
		add(GroundKind::Street, first, last);
		add(GroundKind::Crossing, last, length);
	}

	void add_junction(uint32_t node) {
		Loop2 loop;
		for (const StreetEdges::Arm &arm : _edges.arms(node)) {
			const glm::dvec2 side = glm::dvec2(-arm.direction.y, arm.direction.x) * arm.half_width;
			const glm::dvec2 end = _plan.nodes[node] + arm.direction * arm.cut;
			for (const glm::dvec2 corner : { end - side, end + side, arm.corner }) {
				loop.push_back(corner);
			}
		}
		add_ground(GroundKind::Junction, loop, BlockId::Invalid, no_street);
	}

	// Where a block meets its streets, and which street lies at each side. Streets that go straight on make one side.
	struct Border {
		Loop2 outline;
		std::vector<uint32_t> streets;
	};

	Border border_of(const StreetPlan::Block &block) const {
		const size_t count = block.nodes.size();
		Loop2 corners;
		std::vector<uint32_t> streets;
		for (size_t i = 0; i < count; ++i) {
			const StreetEdges::Arm &arm = _edges.arm(block.nodes[i], block.nodes[(i + 1) % count]);
			corners.push_back(arm.corner);
			streets.push_back(arm.street);
		}
		Border border;
		for (size_t i = 0; i < count; ++i) {
			const size_t before = (i + count - 1) % count;
			const glm::dvec2 in = glm::normalize(corners[i] - corners[before]), out = glm::normalize(corners[(i + 1) % count] - corners[i]);
			if (std::abs(cross(in, out)) > 1e-8 || _plan.streets[streets[before]].width != _plan.streets[streets[i]].width) {
				border.outline.push_back(corners[i]);
				border.streets.push_back(streets[i]);
			}
		}
		return border;
	}

	void add_block(const StreetPlan::Block &block) {
		const Border border = border_of(block);
		const BlockId id = BlockId(_layout.blocks.size());
		_layout.blocks.emplace_back();
		_layout.blocks.back().outline = to_ground(border.outline);
		const StraightSkeleton skeleton = straight_skeleton({ border.outline }, {}, double(_p.pavement_width));
		if (!skeleton.is_complete) {
			add_ground(GroundKind::Pavement, border.outline, id, no_street);
			return;
		}
		for (const SkeletonFace &face : skeleton.faces) {
			Loop2 strip;
			for (const SkeletonVertex &vertex : face.outline) {
				strip.push_back(vertex.position);
			}
			add_ground(GroundKind::Pavement, strip, id, border.streets[face.edge]);
		}
		for (const SkeletonFront &front : skeleton.fronts) {
			add_land(block, border, front, id);
		}
	}

	void add_land(const StreetPlan::Block &block, const Border &border, const SkeletonFront &front, BlockId id) {
		Parcel land;
		const auto lowest = std::min_element(front.edges.begin(), front.edges.end()) - front.edges.begin();
		for (size_t i = 0; i < front.points.size(); ++i) {
			const size_t from = (i + size_t(lowest)) % front.points.size();
			land.outline.push_back(front.points[from]);
			land.street_widths.push_back(_plan.streets[border.streets[front.edges[from]]].width);
		}
		const bool is_plain = _p.kind == LayoutKind::Grid && block.cells == 1 && land.outline.size() == 4 && is_convex(land.outline);
		const LotSize size{ double(_p.lot_front), double(_p.lot_front) * double(_p.lot_aspect), 0.5 * double(_p.jitter) };
		const Random random(derive_seed(_p.seed, hash_text("lots")), index_of(id));
		const std::vector<Parcel> lots = is_plain ? divide_rows(land, _p.lots_along, _p.lots_deep) : divide_land(land, size, random);
		if (lots.empty()) {
			add_ground(GroundKind::Pavement, land.outline, id, no_street);
		}
		for (const Parcel &parcel : lots) {
			const LotId lot = LotId(_layout.lots.size());
			_layout.blocks.back().lots.push_back(lot);
			_layout.lots.push_back({ id, {}, to_ground(parcel.outline), parcel.street_widths, derive_seed(_p.seed, index_of(lot)), 0.0f });
		}
	}

	const StreetPlan &_plan;
	const LayoutParameters &_p;
	StreetEdges _edges;
	Layout _layout;
};

} // namespace

glm::vec3 to_ground(glm::dvec2 point) { return { float(point.x), 0.0f, float(-point.y) }; }

std::vector<glm::vec3> to_ground(std::span<const glm::dvec2> points) {
	std::vector<glm::vec3> result;
	for (const glm::dvec2 &point : points) {
		result.push_back(to_ground(point));
	}
	return result;
}

void frame_layout(Layout &layout) {
	layout.min = layout.max = layout.outline[0];
	for (const glm::vec3 &corner : layout.outline) {
		layout.min = { std::min(layout.min.x, corner.x), 0.0f, std::min(layout.min.z, corner.z) };
		layout.max = { std::max(layout.max.x, corner.x), 0.0f, std::max(layout.max.z, corner.z) };
	}
	const glm::vec3 size = layout.max - layout.min;
	const auto count = [](float metres) { return uint32_t(std::max(1.0f, std::round(metres / tile_size))); };
	const uint32_t columns = count(size.x), rows = count(size.z);
	const auto line = [&](uint32_t column, uint32_t row) {
		return layout.min + glm::vec3(size.x * float(column) / float(columns), 0.0f, size.z * float(row) / float(rows));
	};
	for (uint32_t row = 0; row < rows; ++row) {
		for (uint32_t column = 0; column < columns; ++column) {
			layout.tiles.push_back({ line(column, row), line(column + 1, row + 1) });
		}
	}
}

std::optional<Layout> layout_of_plan(const StreetPlan &plan, const LayoutParameters &parameters, Diagnostics &diagnostics) {
	PlanBuilder builder(plan, parameters);
	if (!builder.has_room()) {
		diagnostics.error("bad-layout", "layout: the streets are too wide for its blocks: between two junctions less than 1 m would be left",
				"make street_width or main_street_width smaller, or lot_front, lots_along or lot_aspect larger");
		return std::nullopt;
	}
	return builder.build();
}

} // namespace pcg
