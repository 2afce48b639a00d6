#include "core/geometry/bounding_rectangle.h"

#include <algorithm>
#include <limits>
#include <vector>

#include <glm/geometric.hpp>

namespace pcg {

namespace {

double cross(glm::dvec2 a, glm::dvec2 b) {
	return a.x * b.y - a.y * b.x;
}

// Counter-clockwise, without points on its sides (Andrew's monotone chain).
std::vector<glm::dvec2> convex_hull(std::span<const glm::dvec2> points) {
	std::vector<glm::dvec2> sorted(points.begin(), points.end());
	if (sorted.size() < 2) {
		return sorted;
	}
	const auto is_before = [](glm::dvec2 a, glm::dvec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
	std::ranges::sort(sorted, is_before);
	std::vector<glm::dvec2> hull;
	for (int half = 0; half < 2; ++half) {
		const size_t first = hull.size();
		for (const glm::dvec2 point : sorted) {
			while (hull.size() >= first + 2 && cross(hull.back() - hull[hull.size() - 2], point - hull.back()) <= 0.0) {
				hull.pop_back();
			}
			hull.push_back(point);
		}
		hull.pop_back(); // the next half begins with it
		std::ranges::reverse(sorted);
	}
	return hull;
}

double extent(std::span<const glm::dvec2> points, glm::dvec2 direction) {
	double low = std::numeric_limits<double>::infinity(), high = -low;
	for (const glm::dvec2 point : points) {
		low = std::min(low, glm::dot(point, direction));
		high = std::max(high, glm::dot(point, direction));
	}
	return high - low;
}

} // namespace

// One side of the smallest rectangle lies on a side of the hull (Freeman and Shapira 1975).
glm::dvec2 longer_side_of_least_rectangle(std::span<const glm::dvec2> points, glm::dvec2 preferred) {
	const std::vector<glm::dvec2> hull = convex_hull(points);
	glm::dvec2 best = preferred;
	double least = std::numeric_limits<double>::infinity();
	for (size_t i = 0; i < hull.size(); ++i) {
		const glm::dvec2 side = hull[(i + 1) % hull.size()] - hull[i];
		if (!(glm::length(side) > 0.0)) {
			continue;
		}
		const glm::dvec2 along = glm::normalize(side), across(-along.y, along.x);
		const double length = extent(hull, along), width = extent(hull, across);
		const double margin = 1e-9 * (length + width);
		for (const glm::dvec2 direction : { along, -along, across, -across }) {
			const bool is_along = direction == along || direction == -along;
			const bool is_longer = is_along ? length >= width - margin : width >= length - margin;
			const double area = length * width, slack = margin * (length + width);
			const bool is_smaller = area < least - slack;
			const bool is_nearer = area <= least + slack && glm::dot(direction, preferred) > glm::dot(best, preferred) + 1e-9;
			if (is_longer && (is_smaller || is_nearer)) {
				best = direction;
				least = std::min(least, area);
			}
		}
	}
	return best;
}

} // namespace pcg
