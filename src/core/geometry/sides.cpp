#include "core/geometry/sides.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace pcg {

namespace {

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

} // namespace

double distance_to(glm::dvec2 a, glm::dvec2 b, glm::dvec2 point) {
	const glm::dvec2 along = b - a;
	const double t = std::clamp(glm::dot(point - a, along) / std::max(glm::dot(along, along), 1e-12), 0.0, 1.0);
	return glm::distance(point, a + along * t);
}

double way_to(const Loop2 &loop, glm::dvec2 from, glm::dvec2 direction) {
	double nearest = INFINITY;
	for (size_t side = 0; side < loop.size(); ++side) {
		const glm::dvec2 a = loop[side] - from, b = loop[(side + 1) % loop.size()] - from;
		const double below = cross(direction, a), above = cross(direction, b);
		if ((below < 0.0) != (above < 0.0)) {
			const double metres = glm::dot(a + (b - a) * (below / (below - above)), direction);
			nearest = metres >= 0.0 ? std::min(nearest, metres) : nearest;
		}
	}
	return nearest;
}

} // namespace pcg
