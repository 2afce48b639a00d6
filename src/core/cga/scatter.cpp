#include "core/cga/scatter.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/geometry/polygon.h"
#include "core/geometry/triangulate.h"

namespace pcg::cga {

namespace {

constexpr int tries = 64; // of a draw that may miss
constexpr int tries_in_volume = 1000;

// Box and Muller: two draws for each number, so that the count of draws does not depend on what they were.
double normal_number(Random &random) {
	const double radius = std::sqrt(-2.0 * std::log(1.0 - random.uniform()));
	return radius * std::cos(6.283185307179586 * random.uniform());
}

glm::dvec3 draw(Random &random, const Bell &bell) {
	const double x = normal_number(random), y = normal_number(random), z = normal_number(random);
	return bell.mean + bell.deviation * glm::dvec3(x, y, z);
}

// Shares of a, b and c at the point of the triangle nearest to `point` (Ericson, Real-Time Collision Detection, 5.1.5).
glm::dvec3 nearest_shares(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::dvec3 point) {
	const glm::dvec3 ab = b - a, ac = c - a;
	const double d1 = glm::dot(ab, point - a), d2 = glm::dot(ac, point - a);
	const double d3 = glm::dot(ab, point - b), d4 = glm::dot(ac, point - b);
	const double d5 = glm::dot(ab, point - c), d6 = glm::dot(ac, point - c);
	if (d1 <= 0.0 && d2 <= 0.0) {
		return { 1.0, 0.0, 0.0 };
	}
	if (d3 >= 0.0 && d4 <= d3) {
		return { 0.0, 1.0, 0.0 };
	}
	if (d6 >= 0.0 && d5 <= d6) {
		return { 0.0, 0.0, 1.0 };
	}
	const double va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
	if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
		const double v = d1 / (d1 - d3);
		return { 1.0 - v, v, 0.0 };
	}
	if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
		const double w = d2 / (d2 - d6);
		return { 1.0 - w, 0.0, w };
	}
	if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
		const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
		return { 0.0, 1.0 - w, w };
	}
	const double sum = va + vb + vc;
	return { va / sum, vb / sum, vc / sum };
}

} // namespace

Scatter::Scatter(const Geometry &geometry) : _low(geometry.low), _high(geometry.high) {
	std::vector<glm::dvec2> flat;
	std::vector<uint32_t> ends, indices;
	for (uint32_t f = 0; f < geometry.face_count; ++f) {
		const GeometryFace &face = geometry.faces[f];
		const glm::dvec3 normal = face_normal(geometry, face);
		const uint32_t first = geometry.first_point(face.first_loop), count = geometry.face_point_count(face);
		flat.clear();
		ends.clear();
		indices.clear();
		for (uint32_t i = 0; i < count; ++i) {
			flat.push_back(flatten(geometry.points[first + i], normal));
		}
		for (uint32_t l = 0; l < face.loop_count; ++l) {
			ends.push_back(geometry.loop_ends[face.first_loop + l] - first);
		}
		triangulate(flat, ends, indices);
		for (size_t i = 0; i + 2 < indices.size(); i += 3) {
			const glm::dvec3 a = geometry.points[first + indices[i]], b = geometry.points[first + indices[i + 1]], c = geometry.points[first + indices[i + 2]];
			const double area = 0.5 * glm::length(glm::cross(b - a, c - a));
			if (area > 1e-12) {
				_triangles.push_back({ a, b, c, normal, _area });
				_area += area;
			}
		}
	}
}

ScatterPoint Scatter::on_surface(Random &random) const {
	const double at = random.uniform() * _area;
	const auto found = std::ranges::upper_bound(_triangles, at, {}, &Triangle::area_before);
	const Triangle &triangle = *(found == _triangles.begin() ? found : found - 1);
	const double root = std::sqrt(random.uniform()), share = random.uniform();
	return { (1.0 - root) * triangle.a + root * (1.0 - share) * triangle.b + root * share * triangle.c, triangle.normal };
}

ScatterPoint Scatter::on_surface(Random &random, const Bell &bell) const {
	ScatterPoint result;
	bool is_above = false;
	for (int i = 0; i < tries && !is_above; ++i) {
		result = nearest(draw(random, bell), is_above);
	}
	return result;
}

ScatterPoint Scatter::in_volume(Random &random) const {
	for (int i = 0; i < tries_in_volume; ++i) {
		const glm::dvec3 point = _low + in_box(random, _high - _low);
		if (is_inside(point)) {
			return { point };
		}
	}
	return on_surface(random);
}

ScatterPoint Scatter::in_volume(Random &random, const Bell &bell) const {
	for (int i = 0; i < tries_in_volume; ++i) {
		const glm::dvec3 point = draw(random, bell);
		if (is_inside(point)) {
			return { point };
		}
	}
	return on_surface(random);
}

glm::dvec3 Scatter::in_box(Random &random, glm::dvec3 size) {
	const double x = random.uniform(), y = random.uniform(), z = random.uniform();
	return size * glm::dvec3(x, y, z);
}

glm::dvec3 Scatter::in_box(Random &random, glm::dvec3 size, const Bell &bell) {
	const glm::dvec3 low = glm::min(size, glm::dvec3(0.0)), high = glm::max(size, glm::dvec3(0.0));
	glm::dvec3 point(0.0);
	for (int i = 0; i < tries; ++i) {
		point = draw(random, bell);
		if (glm::clamp(point, low, high) == point) {
			break;
		}
	}
	return glm::clamp(point, low, high);
}

// By the number of faces between the point and far away, in a direction that no wall has.
bool Scatter::is_inside(glm::dvec3 point) const {
	constexpr glm::dvec3 direction(0.5377, 0.8311, 0.1418);
	bool is_inside = false;
	for (const Triangle &t : _triangles) {
		const glm::dvec3 ab = t.b - t.a, ac = t.c - t.a, across = glm::cross(direction, ac);
		const double determinant = glm::dot(ab, across);
		if (determinant == 0.0) {
			continue;
		}
		const glm::dvec3 way = point - t.a, along = glm::cross(way, ab);
		const double u = glm::dot(way, across) / determinant, v = glm::dot(direction, along) / determinant;
		is_inside ^= u >= 0.0 && v >= 0.0 && u + v < 1.0 && glm::dot(ac, along) / determinant > 0.0;
	}
	return is_inside;
}

// `is_above`: the point lies straight above or below where it is nearest, not beyond the surface's border.
ScatterPoint Scatter::nearest(glm::dvec3 point, bool &is_above) const {
	ScatterPoint best;
	double least = INFINITY;
	for (const Triangle &t : _triangles) {
		const glm::dvec3 shares = nearest_shares(t.a, t.b, t.c, point);
		const glm::dvec3 place = shares.x * t.a + shares.y * t.b + shares.z * t.c, way = point - place;
		const double distance = glm::length(way);
		if (distance < least) {
			least = distance;
			best = { place, t.normal };
			is_above = distance <= 1e-9 || glm::length(glm::cross(way, t.normal)) <= 1e-6 * distance;
		}
	}
	return best;
}

} // namespace pcg::cga
