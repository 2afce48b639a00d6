#include "core/cga/measure.h"

#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "core/geometry/polygon.h"

namespace pcg::cga {

namespace {

// The loops of a face in metres.
std::vector<glm::dvec3> scaled_loop(const Shape &shape, uint32_t loop) {
	std::vector<glm::dvec3> points;
	for (const glm::dvec3 &point : shape.geometry->loop(loop)) {
		points.push_back(shape.to_scope(point));
	}
	return points;
}

template <typename Use> void for_each_face(const Shape &shape, Use use) {
	for (uint32_t i = 0; shape.geometry != nullptr && i < shape.geometry->face_count; ++i) {
		use(shape.geometry->faces[i]);
	}
}

bool has_right_angles(const std::vector<glm::dvec3> &loop, double tolerance_deg) {
	for (size_t i = 0; i < loop.size(); ++i) {
		const glm::dvec3 a = loop[(i + 1) % loop.size()] - loop[i];
		const glm::dvec3 b = loop[(i + 2) % loop.size()] - loop[(i + 1) % loop.size()];
		const double cosine = glm::dot(a, b) / (glm::length(a) * glm::length(b));
		if (!(std::abs(cosine) <= std::sin(tolerance_deg * 0.017453292519943295) + 1e-9)) {
			return false;
		}
	}
	return loop.size() == 4;
}

} // namespace

double face_area(const Shape &shape, const GeometryFace &face) {
	double sum = 0.0;
	for (uint32_t i = 0; i < face.loop_count; ++i) {
		const double size = 0.5 * glm::length(area_vector(scaled_loop(shape, face.first_loop + i)));
		sum += i == 0 ? size : -size;
	}
	return sum;
}

double surface_area(const Shape &shape) {
	double sum = 0.0;
	for_each_face(shape, [&](const GeometryFace &face) { sum += face_area(shape, face); });
	return sum;
}

double volume(const Shape &shape) {
	double sum = 0.0;
	if (shape.geometry == nullptr || !shape.geometry->is_closed) {
		return 0.0;
	}
	for_each_face(shape, [&](const GeometryFace &face) {
		for (uint32_t i = 0; i < face.loop_count; ++i) {
			const auto loop = scaled_loop(shape, face.first_loop + i);
			sum += glm::dot(loop[0], area_vector(loop)) / 6.0;
		}
	});
	return std::abs(sum);
}

double boundary_length(const Shape &shape) {
	double sum = 0.0;
	for (uint32_t i = 0; shape.geometry != nullptr && i < shape.geometry->loop_count; ++i) {
		const auto loop = scaled_loop(shape, i);
		for (size_t k = 0; k < loop.size(); ++k) {
			sum += glm::distance(loop[k], loop[(k + 1) % loop.size()]);
		}
	}
	return sum;
}

bool is_concave(const Shape &shape) {
	bool result = false;
	for_each_face(shape, [&](const GeometryFace &face) {
		const auto loop = scaled_loop(shape, face.first_loop);
		const glm::dvec3 normal = loop_normal(loop);
		std::vector<glm::dvec2> flat;
		for (const glm::dvec3 &point : loop) {
			flat.push_back(flatten(point, normal));
		}
		result |= flat.size() >= 3 && !is_convex(flat);
	});
	return result;
}

bool is_rectangular(const Shape &shape, double tolerance_deg) {
	bool result = shape.geometry != nullptr;
	for_each_face(shape, [&](const GeometryFace &face) {
		result &= face.loop_count == 1 && has_right_angles(scaled_loop(shape, face.first_loop), tolerance_deg);
	});
	return result;
}

bool is_planar(const Shape &shape, double tolerance) {
	bool result = shape.geometry != nullptr;
	for_each_face(shape, [&](const GeometryFace &face) {
		const auto loop = scaled_loop(shape, face.first_loop);
		const glm::dvec3 normal = loop_normal(loop);
		for (const glm::dvec3 &point : loop) {
			result &= std::abs(glm::dot(point - loop[0], normal)) <= tolerance + 1e-9;
		}
	});
	return result;
}

} // namespace pcg::cga
