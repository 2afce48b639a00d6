#include "core/city/lot_overlaps.h"

#include <algorithm>
#include <numeric>

#include <glm/common.hpp>

#include "core/geometry/box2.h"

namespace pcg {

namespace {

// What the boxes share bounds what the polygons share: neighbours that touch need no more than this.
double shared_area(const Box2 &a, const Box2 &b) {
	const glm::dvec2 size = glm::min(a.max, b.max) - glm::max(a.min, b.min);
	return std::max(0.0, size.x) * std::max(0.0, size.y);
}

} // namespace

double shared_area(const Loops2 &a, const Loops2 &b) {
	double area = 0.0;
	for (const Loops2 &polygon : overlay(a, b, OverlayKind::Intersection)) {
		for (const Loop2 &loop : polygon) {
			area += signed_area(loop) / 2.0;
		}
	}
	return area;
}

bool stands_in_hole(const Loop2 &inner, const Loops2 &outer) {
	const double area = signed_area(inner);
	if (outer.size() < 2 || area >= signed_area(outer[0]) || !is_within(box_of(inner), box_of(outer[0]))) {
		return false;
	}
	return std::any_of(outer.begin() + 1, outer.end(), [&](const Loop2 &hole) {
		return shared_area({ Loop2(hole.rbegin(), hole.rend()) }, { inner }) > area / 4.0; // half of it: `area` is doubled
	});
}

// From west to east: a list of those whose boxes reach as far as the next one's western side.
std::vector<OutlineOverlap> find_overlaps(std::span<const Loops2> polygons, const std::vector<bool> &is_moved, double tolerance) {
	std::vector<Box2> boxes;
	for (const Loops2 &polygon : polygons) {
		boxes.push_back(box_of(polygon[0]));
	}
	std::vector<uint32_t> order(polygons.size()), open;
	std::iota(order.begin(), order.end(), 0u);
	std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return boxes[a].min.x < boxes[b].min.x; });
	std::vector<OutlineOverlap> found;
	for (const uint32_t next : order) {
		std::erase_if(open, [&](uint32_t i) { return boxes[i].max.x <= boxes[next].min.x; });
		for (const uint32_t i : open) {
			const bool is_asked = is_moved.empty() || is_moved[i] || is_moved[next];
			if (!is_asked || shared_area(boxes[i], boxes[next]) <= tolerance) {
				continue;
			}
			if (const double area = shared_area(polygons[i], polygons[next]); area > tolerance) {
				found.push_back({ std::min(i, next), std::max(i, next), area });
			}
		}
		open.push_back(next);
	}
	std::sort(found.begin(), found.end(), [](const OutlineOverlap &x, const OutlineOverlap &y) { return std::pair(x.a, x.b) < std::pair(y.a, y.b); });
	return found;
}

} // namespace pcg
