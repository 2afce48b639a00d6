#include "core/cga/shape.h"

#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace pcg::cga {

namespace {

const CornerData *baked_corners(const Shape &shape, Arena &arena) {
	const Geometry &geometry = *shape.geometry;
	if (geometry.corners == nullptr || geometry.corners->normals == nullptr) {
		return geometry.corners;
	}
	CornerData *result = arena.make(*geometry.corners);
	const glm::dmat3 turn = normal_matrix(shape);
	glm::dvec3 *normals = arena.allocate<glm::dvec3>(geometry.point_count);
	for (uint32_t i = 0; i < geometry.point_count; ++i) {
		const glm::dvec3 normal = turn * result->normals[i];
		const double length = glm::length(normal);
		normals[i] = length > 0.0 ? normal / length : glm::dvec3(0.0);
	}
	result->normals = normals;
	return result;
}

// The scope begins at a point of its old coordinates. What is flat has the size 0, which i() asks for.
void put_scope(Shape &shape, glm::dvec3 origin, glm::dvec3 size) {
	const double thin = 1e-9 * (std::abs(size.x) + std::abs(size.y) + std::abs(size.z));
	const auto thick = [&](double length) { return std::abs(length) <= thin ? 0.0 : length; };
	shape.size = { thick(size.x), thick(size.y), thick(size.z) };
	shape.geometry_offset -= origin;
	shape.position += shape.rotation * origin;
}

} // namespace

glm::dmat3 normal_matrix(const Shape &shape) {
	const glm::dvec3 scale = shape.geometry_scale;
	const double volume = scale.x * scale.y * scale.z;
	glm::dmat3 result(0.0);
	for (int axis = 0; axis < 3 && volume != 0.0; ++axis) {
		result[axis][axis] = (volume > 0.0 ? 1.0 : -1.0) / scale[axis];
	}
	return result;
}

void refit(Shape &shape) {
	if (shape.geometry == nullptr) {
		return;
	}
	const glm::dvec3 a = shape.to_scope(shape.geometry->low);
	const glm::dvec3 b = shape.to_scope(shape.geometry->high);
	const glm::dvec3 low = glm::min(a, b);
	const glm::dvec3 high = glm::max(a, b);
	const auto pick = [](bool is_first, double first, double second) { return is_first ? first : second; };
	const glm::dvec3 old = shape.size;
	const glm::dvec3 origin(pick(old.x < 0.0, high.x, low.x), pick(old.y < 0.0, high.y, low.y), pick(old.z < 0.0, high.z, low.z));
	const glm::dvec3 far(pick(old.x < 0.0, low.x, high.x), pick(old.y < 0.0, low.y, high.y), pick(old.z < 0.0, low.z, high.z));
	put_scope(shape, origin, far - origin);
}

void set_geometry(Shape &shape, const Geometry *geometry) {
	shape.geometry = geometry;
	shape.geometry_offset = glm::dvec3(0.0);
	shape.geometry_scale = glm::dvec3(1.0);
	shape.size = glm::dvec3(0.0);
	if (geometry != nullptr) {
		const glm::dvec3 low = geometry->low + 0.0; // never -0
		put_scope(shape, low, geometry->high - low);
	}
}

const Geometry *baked(const Shape &shape, Arena &arena) {
	if (shape.geometry == nullptr) {
		return nullptr;
	}
	const bool is_plain = shape.geometry_offset == glm::dvec3(0.0) && shape.geometry_scale == glm::dvec3(1.0);
	if (is_plain) {
		return shape.geometry;
	}
	Geometry *result = arena.make(*shape.geometry);
	glm::dvec3 *points = arena.allocate<glm::dvec3>(result->point_count);
	for (uint32_t i = 0; i < result->point_count; ++i) {
		points[i] = shape.to_scope(shape.geometry->points[i]);
	}
	result->points = points;
	result->corners = baked_corners(shape, arena);
	const glm::dvec3 a = shape.to_scope(shape.geometry->low);
	const glm::dvec3 b = shape.to_scope(shape.geometry->high);
	result->low = glm::min(a, b);
	result->high = glm::max(a, b);
	return result;
}

void turn_scope(Shape &shape, const glm::dmat3 &axes, GeometryBuilder &builder, Arena &arena) {
	shape.rotation = shape.rotation * axes;
	if (shape.geometry == nullptr) {
		return;
	}
	const glm::dmat3 inverse = glm::transpose(axes);
	const Geometry &geometry = *shape.geometry;
	builder.begin(geometry, inverse * normal_matrix(shape));
	uint32_t corner = 0; // loops lie one behind the other
	for (uint32_t f = 0; f < geometry.face_count; ++f) {
		const GeometryFace &face = geometry.faces[f];
		for (uint32_t i = 0; i < face.loop_count; ++i) {
			for (; corner < geometry.loop_ends[face.first_loop + i]; ++corner) {
				builder.add_corner(inverse * shape.to_scope(geometry.points[corner]), corner);
			}
			builder.end_loop(1);
		}
		builder.end_face(face.tag, face.material);
	}
	set_geometry(shape, builder.finish(arena, shape.geometry->is_closed));
}

} // namespace pcg::cga
