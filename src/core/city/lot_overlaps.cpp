#include "core/city/lot_overlaps.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/common.hpp>

#include "core/geometry/polygon.h"

namespace pcg {

namespace {

struct Box {
	glm::dvec2 min{ INFINITY }, max{ -INFINITY };
};

Box box_of(const Loop2 &loop) {
	Box box;
	for (const glm::dvec2 &point : loop) {
		box.min = glm::min(box.min, point);
		box.max = glm::max(box.max, point);
	}
	return box;
}

// What the boxes share bounds what the polygons share: neighbours that touch need no more than this.
double shared_area(const Box &a, const Box &b) {
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

// From west to east: a list of those whose boxes reach as far as the next one's western side.
std::vector<OutlineOverlap> find_overlaps(std::span<const Loops2> polygons, const std::vector<bool> &is_moved, double tolerance) {
	std::vector<Box> boxes;
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
