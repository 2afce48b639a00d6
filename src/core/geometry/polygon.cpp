#include "core/geometry/polygon.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace pcg {

namespace {

double cross(glm::dvec2 a, glm::dvec2 b) {
	return a.x * b.y - a.y * b.x;
}

glm::dvec3 any_perpendicular(glm::dvec3 axis) {
	const glm::dvec3 other = std::abs(axis.x) < 0.9 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0);
	return glm::normalize(other - glm::dot(other, axis) * axis);
}

glm::dvec3 perpendicular_part(glm::dvec3 direction, glm::dvec3 axis) {
	const glm::dvec3 part = direction - glm::dot(direction, axis) * axis;
	const double length = glm::length(part);
	return length > 1e-9 * glm::length(direction) && length > 0.0 ? part / length : any_perpendicular(axis);
}

double extent(glm::dvec2 v) {
	return std::abs(v.x) + std::abs(v.y);
}

// On which side of a-b the point lies; 0 where the rounding of coordinates alone could have put it there, as with edges of one line.
double side_of(glm::dvec2 a, glm::dvec2 b, glm::dvec2 point) {
	const double side = cross(b - a, point - a);
	const double rounding = 1e-15 * (extent(a) + extent(b) + extent(point));
	return std::abs(side) <= rounding * (extent(b - a) + extent(point - a)) ? 0.0 : side;
}

bool do_segments_meet(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 d) {
	const double abc = side_of(a, b, c);
	const double abd = side_of(a, b, d);
	const double cda = side_of(c, d, a);
	const double cdb = side_of(c, d, b);
	return abc * abd < 0.0 && cda * cdb < 0.0;
}

} // namespace

glm::dvec3 area_vector(std::span<const glm::dvec3> loop) {
	glm::dvec3 sum(0.0);
	for (size_t i = 1; i + 1 < loop.size(); ++i) {
		sum += glm::cross(loop[i] - loop[0], loop[i + 1] - loop[0]);
	}
	return sum;
}

glm::dvec3 loop_normal(std::span<const glm::dvec3> loop, glm::dvec3 fallback) {
	const glm::dvec3 sum = area_vector(loop);
	const double length = glm::length(sum);
	return length > 1e-14 ? sum / length : fallback;
}

double signed_area(std::span<const glm::dvec2> loop) {
	double sum = 0.0;
	for (size_t i = 1; i + 1 < loop.size(); ++i) {
		sum += cross(loop[i] - loop[0], loop[i + 1] - loop[0]);
	}
	return sum;
}

bool is_convex(std::span<const glm::dvec2> loop, double straight) {
	const size_t count = loop.size();
	double turning = 0.0;
	for (size_t i = 0; i < count; ++i) {
		const glm::dvec2 incoming = loop[(i + 1) % count] - loop[i];
		const glm::dvec2 outgoing = loop[(i + 2) % count] - loop[(i + 1) % count];
		const double turn = cross(incoming, outgoing);
		if (turn < -straight * glm::length(incoming) * glm::length(outgoing)) {
			return false;
		}
		turning += std::atan2(turn, glm::dot(incoming, outgoing));
	}
	return turning < 6.3; // once around: star polygons that only turn left go around twice
}

bool contains(std::span<const glm::dvec2> loop, glm::dvec2 point) {
	bool is_inside = false;
	for (size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
		if ((loop[i].y > point.y) != (loop[j].y > point.y)) {
			const double x = (loop[j].x - loop[i].x) * (point.y - loop[i].y) / (loop[j].y - loop[i].y) + loop[i].x;
			is_inside ^= point.x < x;
		}
	}
	return is_inside;
}

glm::dvec2 flatten(glm::dvec3 point, glm::dvec3 normal) {
	const glm::dvec3 size(std::abs(normal.x), std::abs(normal.y), std::abs(normal.z));
	if (size.x >= size.y && size.x >= size.z) {
		return normal.x > 0.0 ? glm::dvec2(point.y, point.z) : glm::dvec2(point.z, point.y);
	}
	if (size.y >= size.z) {
		return normal.y > 0.0 ? glm::dvec2(point.z, point.x) : glm::dvec2(point.x, point.z);
	}
	return normal.z > 0.0 ? glm::dvec2(point.x, point.y) : glm::dvec2(point.y, point.x);
}

glm::dmat3 axes_from_y(glm::dvec3 up, glm::dvec3 direction) {
	const glm::dvec3 x = perpendicular_part(direction, up);
	return glm::dmat3(x, up, glm::cross(x, up));
}

glm::dmat3 axes_from_z(glm::dvec3 normal, glm::dvec3 direction) {
	const glm::dvec3 x = perpendicular_part(direction, normal);
	return glm::dmat3(x, glm::cross(normal, x), normal);
}

bool is_self_intersecting(std::span<const glm::dvec2> loop) {
	const size_t count = loop.size();
	for (size_t i = 0; i < count; ++i) {
		for (size_t j = i + 2; j < count; ++j) {
			const bool are_neighbours = i == 0 && j + 1 == count;
			if (!are_neighbours && do_segments_meet(loop[i], loop[i + 1], loop[j], loop[(j + 1) % count])) {
				return true;
			}
		}
	}
	return false;
}

} // namespace pcg
