#include "core/city/plan_layout.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/city/block_division.h"
#include "core/city/street_edges.h"

namespace pcg {

namespace {

// Zebra crossings at both ends of a stretch of street; narrower where a short one leaves less.
constexpr double crossing_width = 3.0;
constexpr float tile_size = 80.0f; // metres, about

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

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
			add_block(_layout, border_of(block), _p, _p.kind == LayoutKind::Grid && block.cells == 1);
		}
		_layout.outline = to_ground(_edges.outline());
		std::reverse(_layout.outline.begin(), _layout.outline.end());
		_layout.seed = _p.seed;
		frame_layout(_layout);
		return std::move(_layout);
	}

private:
	void add_ground(GroundKind kind, const Loop2 &loop, uint32_t street) { pcg::add_ground(_layout, kind, loop, BlockId::Invalid, street); }

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
			add_ground(kind, { a - side, b - side, b + side, a + side }, id);
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
		add_ground(GroundKind::Junction, loop, no_street);
	}

	// Streets that go straight on make one side.
	BlockBorder border_of(const StreetPlan::Block &block) const {
		const size_t count = block.nodes.size();
		Loop2 corners;
		std::vector<uint32_t> streets;
		for (size_t i = 0; i < count; ++i) {
			const StreetEdges::Arm &arm = _edges.arm(block.nodes[i], block.nodes[(i + 1) % count]);
			corners.push_back(arm.corner);
			streets.push_back(arm.street);
		}
		BlockBorder border;
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

Loop2 to_plan(std::span<const glm::vec3> points) {
	Loop2 result;
	for (const glm::vec3 &point : points) {
		result.push_back({ double(point.x), -double(point.z) });
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
