#include "core/cga/measure.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/cga/edges.h"
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
	if (!is_closed_surface(shape)) {
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

double face_count(const Shape &shape) {
	double count = 0.0;
	for_each_face(shape, [&](const GeometryFace &face) { count += shape.geometry->outline(face).size() >= 3 ? 1.0 : 0.0; });
	return count;
}

uint32_t vertex_count(const Geometry &geometry) {
	std::vector<PointKey> points(geometry.point_count);
	std::transform(geometry.points, geometry.points + geometry.point_count, points.begin(), FaceEdge::key_of);
	std::ranges::sort(points);
	return uint32_t(std::ranges::unique(points).begin() - points.begin());
}

double boundary_length(const Shape &shape) {
	double sum = 0.0;
	if (shape.geometry == nullptr || shape.geometry->is_closed) {
		return sum;
	}
	for_each_edge_group(grouped_edges(*shape.geometry), [&](std::span<const FaceEdge> group) {
		sum += group.size() == 1 ? glm::distance(shape.to_scope(group[0].from), shape.to_scope(group[0].to)) : 0.0;
	});
	return sum;
}

bool is_closed_surface(const Shape &shape) {
	return shape.geometry != nullptr && (shape.geometry->is_closed || has_paired_edges(*shape.geometry));
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
		result |= flat.size() >= 3 && !is_convex(flat, straight_sine);
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

bool is_planar(const Shape &shape, double tolerance_deg) {
	bool result = shape.geometry != nullptr;
	const double sine = std::sin(glm::clamp(tolerance_deg, 0.0, 90.0) * 0.017453292519943295) + 1e-7;
	for_each_face(shape, [&](const GeometryFace &face) {
		const auto loop = scaled_loop(shape, face.first_loop);
		const glm::dvec3 normal = loop_normal(loop);
		for (size_t i = 0; i < loop.size(); ++i) {
			const glm::dvec3 next = loop[(i + 1) % loop.size()], before = next - loop[i], behind = loop[(i + 2) % loop.size()] - next;
			const glm::dvec3 local = glm::cross(before, behind);
			const bool says_nothing = glm::length(local) < 1e-12 || glm::dot(before, before) < 1e-12 || glm::dot(behind, behind) < 1e-12;
			result &= says_nothing || glm::length(glm::cross(local, normal)) <= sine * glm::length(local);
		}
		result &= loop.size() >= 3;
	});
	return result;
}

std::pair<double, double> vertical_extent(const Shape &shape) {
	if (shape.geometry == nullptr) {
		return { 0.0, 0.0 };
	}
	const Frame frame = shape.frame();
	double low = INFINITY, high = -INFINITY;
	for (uint32_t i = 0; i < shape.geometry->point_count; ++i) {
		const double y = frame.to_parent(shape.to_scope(shape.geometry->points[i])).y;
		low = std::min(low, y);
		high = std::max(high, y);
	}
	return { low, high };
}

SlopeAngles steepest_slope(const Shape &shape) {
	constexpr double degrees = 57.29577951308232;
	SlopeAngles best{ -1.0, 0.0 };
	const glm::dmat3 axes = shape.frame().axes;
	for_each_face(shape, [&](const GeometryFace &face) {
		const auto loop = scaled_loop(shape, face.first_loop);
		const glm::dvec3 normal = axes * loop_normal(loop, { 0.0, 0.0, 1.0 }); // edges and points look along z
		const double level = std::sqrt(normal.x * normal.x + normal.z * normal.z);
		const double slope = std::atan2(level, std::abs(normal.y)) * degrees;
		if (slope > best.slope + 1e-6) {
			const double azimuth = level > 1e-9 ? std::atan2(normal.x, -normal.z) * degrees : 0.0;
			best = { slope, azimuth < 0.0 ? azimuth + 360.0 : azimuth };
		}
	});
	return { std::max(best.slope, 0.0), best.azimuth >= 360.0 ? 0.0 : best.azimuth };
}

} // namespace pcg::cga
