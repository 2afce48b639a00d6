#include "core/cga/primitives.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/cga/primitive_uvs.h"

namespace pcg::cga {

namespace {

constexpr double tau = 6.283185307179586;

// Counter-clockwise seen from above; the first edge looks to +z, as a lot's front does.
std::vector<glm::dvec3> circle(uint32_t sides, double y, double radius) {
	std::vector<glm::dvec3> points;
	for (uint32_t i = 0; i < sides; ++i) {
		const double angle = tau * (0.75 + (double(i) - 0.5) / double(sides));
		points.push_back({ 0.5 + radius * std::cos(angle), y, 0.5 - radius * std::sin(angle) });
	}
	return points;
}

uint32_t usable(uint32_t sides) {
	return std::clamp(sides, 3u, 1000u);
}

void add_polygon(GeometryBuilder &builder, const std::vector<glm::dvec3> &points, bool looks_down) {
	const size_t count = points.size();
	for (size_t i = 0; i < count; ++i) { // downwards: the first edge stays first, turned around
		builder.add_point(points[looks_down ? (1 + count - i) % count : i]);
	}
	builder.end_loop();
	builder.end_face();
}

void add_triangle(GeometryBuilder &builder, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
	for (const glm::dvec3 &point : { a, b, c }) {
		builder.add_point(point);
	}
	builder.end_loop();
	builder.end_face();
}

void add_walls(GeometryBuilder &builder, const std::vector<glm::dvec3> &bottom, const std::vector<glm::dvec3> &top) {
	for (size_t i = 0; i < bottom.size(); ++i) {
		const size_t next = (i + 1) % bottom.size();
		builder.add_quad(bottom[i], bottom[next], top[next], top[i]);
	}
}

} // namespace

const Geometry *make_cube(Arena &arena) {
	const std::vector<glm::dvec3> bottom = { { 0, 0, 1 }, { 1, 0, 1 }, { 1, 0, 0 }, { 0, 0, 0 } };
	const std::vector<glm::dvec3> top = { { 0, 1, 1 }, { 1, 1, 1 }, { 1, 1, 0 }, { 0, 1, 0 } };
	GeometryBuilder builder;
	add_polygon(builder, bottom, true);
	add_walls(builder, bottom, top);
	add_polygon(builder, top, false);
	return with_face_uvs(builder.finish(arena, true), arena);
}

const Geometry *make_quad(int normal_axis, Arena &arena) {
	GeometryBuilder builder;
	if (normal_axis == 0) {
		builder.add_quad({ 0, 0, 1 }, { 0, 0, 0 }, { 0, 1, 0 }, { 0, 1, 1 });
		return with_face_uvs(builder.finish(arena, false), arena);
	}
	if (normal_axis == 1) {
		builder.add_quad({ 0, 0, 1 }, { 1, 0, 1 }, { 1, 0, 0 }, { 0, 0, 0 });
	} else {
		builder.add_quad({ 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 });
	}
	return with_face_uvs(builder.finish(arena, false), arena);
}

const Geometry *make_disk(uint32_t sides, Arena &arena) {
	GeometryBuilder builder;
	add_polygon(builder, circle(usable(sides), 0.0, 0.5), false);
	return builder.finish(arena, false);
}

const Geometry *make_cylinder(uint32_t sides, Arena &arena) {
	const auto bottom = circle(usable(sides), 0.0, 0.5), top = circle(usable(sides), 1.0, 0.5);
	GeometryBuilder builder;
	add_polygon(builder, bottom, true);
	add_walls(builder, bottom, top);
	add_polygon(builder, top, false);
	return with_round_uvs(builder.finish(arena, true), usable(sides), arena);
}

const Geometry *make_cone(uint32_t sides, Arena &arena) {
	const auto bottom = circle(usable(sides), 0.0, 0.5);
	GeometryBuilder builder;
	add_polygon(builder, bottom, true);
	for (size_t i = 0; i < bottom.size(); ++i) {
		add_triangle(builder, bottom[i], bottom[(i + 1) % bottom.size()], { 0.5, 1.0, 0.5 });
	}
	return with_round_uvs(builder.finish(arena, true), usable(sides), arena);
}

const Geometry *make_sphere(uint32_t sides, uint32_t divisions, Arena &arena) {
	const uint32_t rings = std::clamp(divisions, 2u, 1000u);
	std::vector<std::vector<glm::dvec3>> circles;
	for (uint32_t i = 1; i < rings; ++i) {
		const double angle = 0.5 * tau * double(i) / double(rings);
		circles.push_back(circle(usable(sides), 0.5 - 0.5 * std::cos(angle), 0.5 * std::sin(angle)));
	}
	GeometryBuilder builder;
	const size_t count = circles[0].size();
	for (size_t i = 0; i < count; ++i) {
		add_triangle(builder, circles[0][(i + 1) % count], circles[0][i], { 0.5, 0.0, 0.5 });
	}
	for (size_t ring = 0; ring + 1 < circles.size(); ++ring) {
		add_walls(builder, circles[ring], circles[ring + 1]);
	}
	for (size_t i = 0; i < count; ++i) {
		add_triangle(builder, circles.back()[i], circles.back()[(i + 1) % count], { 0.5, 1.0, 0.5 });
	}
	return with_round_uvs(builder.finish(arena, true), usable(sides), arena);
}

void fit_to_scope(Shape &shape, const Geometry *geometry) {
	const glm::dvec3 extent = geometry->high - geometry->low;
	glm::dvec3 scale(1.0);
	int zeros = 0;
	double sum = 0.0;
	for (int axis = 0; axis < 3; ++axis) {
		if (shape.size[axis] == 0.0) {
			++zeros;
		} else {
			scale[axis] = extent[axis] > 0.0 ? shape.size[axis] / extent[axis] : 1.0;
			sum += std::abs(scale[axis]);
		}
	}
	glm::dvec3 shift(0.0);
	for (int axis = 0; axis < 3; ++axis) {
		if (shape.size[axis] == 0.0) {
			scale[axis] = zeros == 3 ? 1.0 : sum / double(3 - zeros);
			shape.size[axis] = scale[axis] * extent[axis];
			shift[axis] = zeros > 1 ? scale[axis] * geometry->low[axis] : 0.0;
		}
	}
	shape.position += shape.rotation * shift;
	shape.geometry = geometry;
	shape.geometry_scale = scale;
	shape.geometry_offset = -scale * geometry->low;
}

} // namespace pcg::cga
