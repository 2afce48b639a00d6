#include "core/city/block_yards.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/city/lot_overlaps.h"
#include "core/geometry/convex_parts.h"
#include "core/geometry/sides.h"

namespace pcg {

namespace {

Loop2 passage_of(const Loop2 &yard, const Loop2 &land, double width) {
	Loop2 passage;
	double shortest = INFINITY;
	for (size_t side = 0; side < yard.size(); ++side) {
		const glm::dvec2 a = yard[side], b = yard[(side + 1) % yard.size()], middle = (a + b) / 2.0;
		const glm::dvec2 along = (b - a) / std::max(glm::distance(a, b), 1e-9), outwards{ along.y, -along.x };
		const double metres = way_to(land, middle, outwards);
		if (metres < shortest) {
			shortest = metres;
			// Farther on at both ends, for neither need lie square to it.
			const glm::dvec2 from = middle - outwards * width, to = middle + outwards * (metres + width), half = along * (width / 2.0);
			passage = { from - half, to - half, to + half, from + half };
		}
	}
	return passage;
}

} // namespace

LandAroundYards land_around_yards(const Loop2 &land, const Loops2 &yards, const Loops2 &inner, double passage) {
	Loops2 open = yards;
	for (const Loop2 &yard : yards) {
		Loop2 way = shared_area({ yard }, { land }) > 0.0 ? passage_of(yard, land, passage) : Loop2();
		if (!way.empty()) {
			open.push_back(std::move(way));
		}
	}
	LandAroundYards result;
	const auto add_open = [&](const Loops2 &polygon) {
		for (const Loops2 &part : convex_parts(polygon, INFINITY)) {
			result.open.push_back(part[0]);
		}
	};
	for (const Loops2 &polygon : overlay({ land }, open, OverlayKind::Difference)) {
		if (polygon.size() == 1) {
			result.land.push_back(polygon[0]);
		} else { // a yard within a yard that lies within another, or the like
			add_open(polygon);
		}
	}
	for (const Loops2 &polygon : overlay({ land }, open, OverlayKind::Intersection)) {
		for (const Loops2 &left : inner.empty() ? Polygons2{ polygon } : overlay(polygon, inner, OverlayKind::Difference)) {
			add_open(left);
		}
	}
	return result;
}

} // namespace pcg
