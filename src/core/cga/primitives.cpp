#include "core/cga/primitives.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <span>
#include <vector>

namespace pcg::cga {

namespace {

constexpr double tau = 6.283185307179586;

// Counter-clockwise seen from above, corners on the circle, the first one on +z: so a circle with a multiple of four sides has the size of its
// diameter along both axes.
std::vector<glm::dvec3> circle(uint32_t sides, double y, double radius) {
	std::vector<glm::dvec3> points;
	for (uint32_t i = 0; i < sides; ++i) {
		const double angle = tau * (0.75 + double(i) / double(sides));
		points.push_back({ 0.5 + radius * std::cos(angle), y, 0.5 - radius * std::sin(angle) });
	}
	return points;
}

// Faces and their texture coordinates.
class Body {
public:
	void add(std::initializer_list<glm::dvec3> points, std::initializer_list<glm::dvec2> uvs) {
		_builder.add_loop(std::span(points.begin(), points.size()));
		_builder.end_face();
		_uvs.insert(_uvs.end(), uvs.begin(), uvs.end());
	}
	// u along the first edge.
	void add_quad(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::dvec3 d) {
		add({ a, b, c, d }, { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 } });
	}
	// The picture as it would lie on the bounding square seen from above.
	void add_polygon(const std::vector<glm::dvec3> &points, bool looks_down) {
		const size_t count = points.size();
		for (size_t i = 0; i < count; ++i) { // downwards: the first edge stays first, turned around
			const glm::dvec3 point = points[looks_down ? (1 + count - i) % count : i];
			_builder.add_point(point);
			_uvs.push_back({ point.x, 1.0 - point.z });
		}
		_builder.end_loop();
		_builder.end_face();
	}
	// u once around.
	void add_ring(const std::vector<glm::dvec3> &bottom, const std::vector<glm::dvec3> &top, double low, double high) {
		const size_t count = bottom.size();
		for (size_t i = 0; i < count; ++i) {
			const size_t next = (i + 1) % count;
			const double left = double(i) / double(count), right = double(i + 1) / double(count);
			add({ bottom[i], bottom[next], top[next], top[i] }, { { left, low }, { right, low }, { right, high }, { left, high } });
		}
	}
	void add_fan(const std::vector<glm::dvec3> &ring, glm::dvec3 tip, double at_ring, double at_tip) {
		const size_t count = ring.size();
		for (size_t i = 0; i < count; ++i) {
			const size_t next = (i + 1) % count;
			const double left = double(i) / double(count), right = double(i + 1) / double(count), middle = 0.5 * (left + right);
			if (at_tip > at_ring) {
				add({ ring[i], ring[next], tip }, { { left, at_ring }, { right, at_ring }, { middle, at_tip } });
			} else {
				add({ ring[next], ring[i], tip }, { { right, at_ring }, { left, at_ring }, { middle, at_tip } });
			}
		}
	}
	const Geometry *finish(Arena &arena, bool is_closed, bool has_uvs = true) {
		const Geometry *geometry = _builder.finish(arena, is_closed);
		return has_uvs ? with_uvs(*geometry, 0, arena.copy(_uvs.data(), _uvs.size()), arena) : geometry;
	}

private:
	GeometryBuilder _builder;
	std::vector<glm::dvec2> _uvs;
};

uint32_t usable(uint32_t sides) {
	return std::clamp(sides, 3u, 1000u);
}

const Geometry *make_cube(bool has_uvs, Arena &arena) {
	const glm::dvec3 bottom[] = { { 0, 0, 1 }, { 1, 0, 1 }, { 1, 0, 0 }, { 0, 0, 0 } };
	const glm::dvec3 up(0.0, 1.0, 0.0);
	Body body;
	body.add_quad(bottom[3], bottom[2], bottom[1], bottom[0]);
	body.add_quad(bottom[0] + up, bottom[1] + up, bottom[2] + up, bottom[3] + up);
	for (size_t i = 0; i < 4; ++i) {
		const size_t next = (i + 1) % 4;
		body.add_quad(bottom[i], bottom[next], bottom[next] + up, bottom[i] + up);
	}
	return body.finish(arena, true, has_uvs);
}

const Geometry *make_quad(uint32_t axis, Arena &arena) {
	Body body;
	if (axis == 0) {
		body.add_quad({ 0, 0, 1 }, { 0, 0, 0 }, { 0, 1, 0 }, { 0, 1, 1 });
	} else if (axis == 1) {
		body.add_quad({ 0, 0, 1 }, { 1, 0, 1 }, { 1, 0, 0 }, { 0, 0, 0 });
	} else {
		body.add_quad({ 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 });
	}
	return body.finish(arena, false);
}

// The disk on the floor, turned: it begins at its lowest edge.
const Geometry *make_disk(uint32_t sides, uint32_t axis, Arena &arena) {
	const std::vector<glm::dvec3> points = circle(sides, 0.0, 0.5);
	GeometryBuilder builder;
	std::vector<glm::dvec2> uvs;
	for (const glm::dvec3 &point : points) {
		const glm::dvec2 uv(point.x, 1.0 - point.z);
		builder.add_point(axis == 0 ? glm::dvec3(0.0, uv.y, 1.0 - uv.x) : axis == 2 ? glm::dvec3(uv, 0.0) : point);
		uvs.push_back(uv);
	}
	builder.end_loop();
	builder.end_face();
	return with_uvs(*builder.finish(arena, false), 0, arena.copy(uvs.data(), uvs.size()), arena);
}

const Geometry *make_cylinder(uint32_t sides, Arena &arena) {
	const auto bottom = circle(sides, 0.0, 0.5), top = circle(sides, 1.0, 0.5);
	Body body;
	body.add_polygon(bottom, true);
	body.add_ring(bottom, top, 0.0, 1.0);
	body.add_polygon(top, false);
	return body.finish(arena, true);
}

const Geometry *make_cone(uint32_t sides, Arena &arena) {
	const auto bottom = circle(sides, 0.0, 0.5);
	Body body;
	body.add_polygon(bottom, true);
	body.add_fan(bottom, { 0.5, 1.0, 0.5 }, 0.0, 1.0);
	return body.finish(arena, true);
}

const Geometry *make_sphere(uint32_t sides, uint32_t divisions, Arena &arena) {
	const uint32_t rings = std::clamp(divisions, 2u, 1000u);
	std::vector<std::vector<glm::dvec3>> circles;
	for (uint32_t i = 1; i < rings; ++i) {
		const double angle = 0.5 * tau * double(i) / double(rings);
		circles.push_back(circle(sides, 0.5 - 0.5 * std::cos(angle), 0.5 * std::sin(angle)));
	}
	const double step = 1.0 / double(rings);
	Body body;
	body.add_fan(circles[0], { 0.5, 0.0, 0.5 }, step, 0.0);
	for (size_t i = 0; i + 1 < circles.size(); ++i) {
		body.add_ring(circles[i], circles[i + 1], double(i + 1) * step, double(i + 2) * step);
	}
	body.add_fan(circles.back(), { 0.5, 1.0, 0.5 }, 1.0 - step, 1.0);
	return body.finish(arena, true);
}

} // namespace

const Geometry *make_primitive(PrimitiveKind kind, uint32_t a, uint32_t b, Arena &arena) {
	switch (kind) {
		case PrimitiveKind::Quad:
			return make_quad(a, arena);
		case PrimitiveKind::Disk:
			return make_disk(usable(a), b, arena);
		case PrimitiveKind::Cube:
		case PrimitiveKind::PlainCube:
			return make_cube(kind == PrimitiveKind::Cube, arena);
		case PrimitiveKind::Sphere:
			return make_sphere(usable(a), b, arena);
		case PrimitiveKind::Cylinder:
			return make_cylinder(usable(a), arena);
		case PrimitiveKind::Cone:
			return make_cone(usable(a), arena);
	}
	return nullptr;
}

namespace {

void map_to_scope(Shape &shape, const Geometry *geometry, glm::dvec3 scale) {
	shape.geometry = geometry;
	shape.geometry_scale = scale;
	shape.geometry_offset = -scale * geometry->low;
}

} // namespace

void fit_to_scope(Shape &shape, const Geometry *geometry) {
	const glm::dvec3 extent = geometry->high - geometry->low;
	glm::dvec3 scale(1.0);
	int zeros = 0, known = 0;
	double sum = 0.0;
	for (int axis = 0; axis < 3; ++axis) {
		zeros += shape.size[axis] == 0.0 ? 1 : 0;
		if (shape.size[axis] != 0.0 && extent[axis] > 0.0) {
			scale[axis] = shape.size[axis] / extent[axis];
			sum += std::abs(scale[axis]);
			++known;
		}
	}
	glm::dvec3 shift(0.0);
	for (int axis = 0; axis < 3; ++axis) {
		if (shape.size[axis] == 0.0) {
			scale[axis] = known == 0 ? 1.0 : sum / double(known);
			shape.size[axis] = scale[axis] * extent[axis];
			shift[axis] = zeros > 1 ? scale[axis] * geometry->low[axis] : 0.0;
		}
	}
	shape.position += shape.rotation * shift;
	map_to_scope(shape, geometry, scale);
}

void place_in_plane(Shape &shape, const Geometry *geometry, glm::dvec3 size, int normal_axis) {
	const glm::dvec3 extent = geometry->high - geometry->low;
	glm::dvec3 shift = 0.5 * (shape.size - size), scale(1.0);
	shift[normal_axis] = 0.0;
	for (int axis = 0; axis < 3; ++axis) {
		scale[axis] = extent[axis] > 0.0 ? size[axis] / extent[axis] : 1.0;
	}
	shape.position += shape.rotation * shift;
	shape.size = size;
	map_to_scope(shape, geometry, scale);
}

void place_on_floor(Shape &shape, const Geometry *geometry, glm::dvec3 size) {
	place_in_plane(shape, geometry, size, 1);
}

} // namespace pcg::cga
