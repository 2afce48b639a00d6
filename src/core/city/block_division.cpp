#include "core/city/block_division.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/base/random.h"
#include "core/city/block_yards.h"
#include "core/city/lot_division.h"
#include "core/city/plan_layout.h"
#include "core/geometry/convex_parts.h"
#include "core/geometry/sides.h"
#include "core/geometry/straight_skeleton.h"

namespace pcg {

namespace {

constexpr double same_place = 1e-6; // metres
constexpr double same_line = 1e-4; // metres
constexpr double least_passage = 2.0; // metres

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

// What a block's pavements leave, or a part of that, before lots are cut from it.
Parcel land_of(const Layout &layout, const BlockBorder &border, const SkeletonFront &front) {
	Parcel land;
	const auto lowest = std::min_element(front.edges.begin(), front.edges.end()) - front.edges.begin();
	for (size_t i = 0; i < front.points.size(); ++i) {
		const size_t from = (i + size_t(lowest)) % front.points.size();
		land.outline.push_back(front.points[from]);
		land.street_widths.push_back(layout.streets[border.streets[front.edges[from]]].width);
	}
	return land;
}

// Edges that lie on one of the whole have its street.
Parcel part_of(const Parcel &whole, const Loop2 &outline) {
	Parcel part{ outline, std::vector<float>(outline.size(), 0.0f) };
	for (size_t i = 0; i < outline.size(); ++i) {
		const glm::dvec2 from = outline[i], to = outline[(i + 1) % outline.size()];
		for (size_t side = 0; side < whole.outline.size(); ++side) {
			const glm::dvec2 a = whole.outline[side], b = whole.outline[(side + 1) % whole.outline.size()];
			if (std::max(distance_to(a, b, from), distance_to(a, b, to)) < same_line) {
				part.street_widths[i] = whole.street_widths[side];
			}
		}
	}
	return part;
}

void add_lots(Layout &layout, const Parcel &land, const LayoutParameters &p, bool has_rows) {
	const BlockId id = BlockId(layout.blocks.size() - 1);
	const LotSize size{ double(p.lot_front), double(p.lot_front) * double(p.lot_aspect), 0.5 * double(p.jitter) };
	const Random random(derive_seed(p.seed, hash_text("lots")), index_of(id));
	const std::vector<Parcel> lots = has_rows && land.outline.size() == 4 && is_convex(land.outline) ? divide_rows(land, p.lots_along, p.lots_deep)
																									 : divide_land(land, size, random);
	if (lots.empty()) {
		add_ground(layout, GroundKind::Pavement, land.outline, id, no_street);
	}
	for (const Parcel &parcel : lots) {
		const LotId lot = LotId(layout.lots.size());
		layout.blocks.back().lots.push_back(lot);
		layout.lots.push_back({ id, {}, to_ground(parcel.outline), parcel.street_widths, derive_seed(p.seed, index_of(lot)), 0.0f });
	}
}

void add_land(Layout &layout, const BlockBorder &border, const SkeletonFront &front, const LayoutParameters &p, bool has_rows) {
	const Parcel land = land_of(layout, border, front);
	if (border.yards.empty()) {
		add_lots(layout, land, p, has_rows);
		return;
	}
	const LandAroundYards parts = land_around_yards(land.outline, border.yards, border.inner, std::max(least_passage, double(p.pavement_width)));
	for (const Loop2 &outline : parts.land) {
		add_lots(layout, part_of(land, outline), p, has_rows);
	}
	for (const Loop2 &piece : parts.open) {
		add_ground(layout, GroundKind::Pavement, piece, BlockId(layout.blocks.size() - 1), no_street);
	}
}

} // namespace

void add_ground(Layout &layout, GroundKind kind, const Loop2 &loop, BlockId block, uint32_t street) {
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
			layout.blocks[index_of(block)].pavements.push_back(uint32_t(layout.ground.size()));
		}
		layout.ground.push_back({ kind, to_ground(part[0]), block, street });
	}
}

void add_block(Layout &layout, const BlockBorder &border, const LayoutParameters &p, bool has_rows) {
	const BlockId id = BlockId(layout.blocks.size());
	layout.blocks.emplace_back();
	layout.blocks.back().outline = to_ground(border.outline);
	const StraightSkeleton skeleton = straight_skeleton({ border.outline }, {}, double(p.pavement_width));
	if (!skeleton.is_complete) {
		add_ground(layout, GroundKind::Pavement, border.outline, id, no_street);
		return;
	}
	for (const SkeletonFace &face : skeleton.faces) {
		Loop2 strip;
		for (const SkeletonVertex &vertex : face.outline) {
			strip.push_back(vertex.position);
		}
		add_ground(layout, GroundKind::Pavement, strip, id, border.streets[face.edge]);
	}
	for (const SkeletonFront &front : skeleton.fronts) {
		add_land(layout, border, front, p, has_rows);
	}
}

} // namespace pcg
