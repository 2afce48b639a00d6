#include "core/cga/extrude.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/geometry/polygon.h"

namespace pcg::cga {

namespace {

using Loop = std::vector<glm::dvec3>;

// The other way around with the same first edge: [0 1 2 3] becomes [1 0 3 2]. Doing it twice changes nothing.
void reverse_keeping_first_edge(Loop &loop) {
	std::ranges::reverse(loop);
	std::rotate(loop.begin(), loop.end() - 2, loop.end());
}

// Where a corner of a loop that was reversed so stood before.
uint32_t reversed_index(size_t index, size_t count) {
	return uint32_t((count + 1 - index) % count);
}

class Extruder {
public:
	Extruder(const Geometry &geometry, ExtrudeDirection direction, double height, glm::dvec3 up, bool is_hollow, GeometryBuilder &builder)
			: _geometry(geometry), _direction(direction), _height(height), _up(up), _is_hollow(is_hollow), _builder(builder) {
		_builder.begin(geometry, glm::dmat3(0.0)); // flat shaded
	}

	const Geometry *run(Arena &arena) {
		for (uint32_t i = 0; i < _geometry.face_count; ++i) {
			add_prism(_geometry.faces[i]);
		}
		return _builder.finish(arena, true);
	}

private:
	void add_prism(const GeometryFace &face) {
		const glm::dvec3 normal = face_normal(_geometry, face);
		const glm::dvec3 axis = _direction == ExtrudeDirection::FaceNormal ? normal : _up;
		const double along = glm::dot(axis, normal) * _height;
		const bool has_area = _geometry.outline(face).size() >= 3; // edges and points have none
		if (!has_area || std::abs(glm::dot(axis, normal)) < 1e-6) {
			return;
		}
		std::vector<Loop> bottom, top;
		for (uint32_t i = 0; i < face.loop_count; ++i) {
			const auto points = _geometry.loop(face.first_loop + i);
			bottom.emplace_back(points.begin(), points.end());
		}
		// Outwards means: the bottom looks away from the direction. A hollow is the same, seen from inside.
		_is_flipped = (along < 0.0) != (_is_hollow && _height < 0.0);
		if (_is_flipped) {
			for (Loop &loop : bottom) {
				reverse_keeping_first_edge(loop);
			}
		}
		const double flat_level = level(bottom[0], axis);
		for (const Loop &loop : bottom) {
			top.push_back(loop);
			for (glm::dvec3 &point : top.back()) {
				point += axis * (_direction == ExtrudeDirection::WorldUpFlatTop ? flat_level - glm::dot(point, axis) : _height);
			}
		}
		add_cap(bottom, true, face);
		add_walls(bottom, top, face, normal);
		add_cap(top, false, face);
	}

	// Where a flat top lies: over the lowest point, but not below the highest; downwards the other way around.
	double level(const Loop &loop, glm::dvec3 axis) const {
		double low = glm::dot(loop[0], axis), high = low;
		for (const glm::dvec3 &point : loop) {
			low = std::min(low, glm::dot(point, axis));
			high = std::max(high, glm::dot(point, axis));
		}
		return _height >= 0.0 ? std::max(low + _height, high) : std::min(high + _height, low);
	}

	// The corner of the source that a corner of a loop of the prism stands over.
	uint32_t corner_of(const GeometryFace &face, size_t loop, size_t index, size_t count) const {
		return _geometry.first_point(face.first_loop + uint32_t(loop)) + (_is_flipped ? reversed_index(index, count) : uint32_t(index));
	}

	void add_cap(const std::vector<Loop> &loops, bool is_reversed, const GeometryFace &face) {
		for (size_t l = 0; l < loops.size(); ++l) {
			const size_t count = loops[l].size();
			for (size_t i = 0; i < count; ++i) {
				const size_t index = is_reversed ? reversed_index(i, count) : i;
				_builder.add_corner(loops[l][index], corner_of(face, l, index, count));
			}
			_builder.end_loop();
		}
		_builder.end_face(FaceTag::None, face.material);
	}

	void add_wall(const Loop &bottom, const Loop &top, size_t from, size_t to, uint32_t from_corner, uint32_t to_corner) {
		_builder.add_corner(bottom[from], from_corner);
		_builder.add_corner(bottom[to], to_corner);
		_builder.add_corner(top[to], to_corner);
		_builder.add_corner(top[from], from_corner);
		_builder.end_loop();
		_builder.end_face();
	}

	void add_walls(const std::vector<Loop> &bottom, const std::vector<Loop> &top, const GeometryFace &face, glm::dvec3 normal) {
		for (size_t l = 0; l < bottom.size(); ++l) {
			const size_t count = bottom[l].size();
			for (size_t i = 0; i < count; ++i) {
				const size_t next = (i + 1) % count;
				if (_geometry.face_count == 1 || !has_flat_neighbour(bottom[l][i], bottom[l][next], normal)) {
					add_wall(bottom[l], top[l], i, next, corner_of(face, l, i, count), corner_of(face, l, next, count));
				}
			}
		}
	}

	// Another face of the same plane has this edge.
	bool has_flat_neighbour(glm::dvec3 a, glm::dvec3 b, glm::dvec3 normal) const {
		uint32_t users = 0;
		for (uint32_t f = 0; f < _geometry.face_count; ++f) {
			if (glm::dot(face_normal(_geometry, _geometry.faces[f]), normal) < 1.0 - 1e-9) {
				continue;
			}
			const auto loop = _geometry.outline(_geometry.faces[f]);
			for (size_t i = 0; i < loop.size(); ++i) {
				const glm::dvec3 from = loop[i], to = loop[(i + 1) % loop.size()];
				users += (from == a && to == b) || (from == b && to == a);
			}
		}
		return users > 1;
	}

	const Geometry &_geometry;
	ExtrudeDirection _direction;
	double _height;
	glm::dvec3 _up;
	bool _is_hollow;
	bool _is_flipped = false; // the prism's loops run against those of the face it stands on
	GeometryBuilder &_builder;
};

// Of the triangles of the fan around the first point, weighted by their signed area. False: there is no area.
bool center_of_gravity(std::span<const glm::dvec3> loop, glm::dvec3 &center) {
	const glm::dvec3 normal = loop_normal(loop);
	glm::dvec3 sum(0.0);
	double weight = 0.0;
	for (size_t i = 1; i + 1 < loop.size(); ++i) {
		const double area = glm::dot(glm::cross(loop[i] - loop[0], loop[i + 1] - loop[0]), normal);
		sum += area * (loop[0] + loop[i] + loop[i + 1]) / 3.0;
		weight += area;
	}
	center = sum / weight;
	return std::abs(weight) > 1e-12;
}

// y to the direction of the extrusion, x as it was as far as it can.
void turn_to(Shape &shape, glm::dvec3 direction, GeometryBuilder &builder, Arena &arena) {
	const glm::dmat3 axes = axes_from_y(direction, glm::dvec3(1.0, 0.0, 0.0));
	const bool is_turned = glm::distance(axes[0], { 1.0, 0.0, 0.0 }) > 1e-12 || glm::distance(axes[1], { 0.0, 1.0, 0.0 }) > 1e-12;
	if (is_turned) {
		turn_scope(shape, axes, builder, arena);
	}
}

// The scope begins at the old surface and its size points the other way.
void make_negative(Shape &shape, int axis) {
	glm::dvec3 shift(0.0);
	shift[axis] = shape.size[axis];
	shape.position += shape.rotation * shift;
	shape.geometry_offset[axis] -= shape.size[axis];
	shape.size[axis] = -shape.size[axis];
}

} // namespace

bool extrude(Shape &shape, ExtrudeDirection direction, double height, bool keeps_axes, GeometryBuilder &builder, Arena &arena) {
	const Geometry *geometry = baked(shape, arena);
	if (geometry == nullptr) {
		return false;
	}
	if (std::abs(height) < 1e-9) {
		return true;
	}
	const glm::dvec3 up = glm::transpose(shape.frame().axes) * glm::dvec3(0.0, 1.0, 0.0);
	const Geometry *result = Extruder(*geometry, direction, height, up, keeps_axes, builder).run(arena);
	if (result == nullptr) {
		return false;
	}
	const glm::dvec3 axis = direction == ExtrudeDirection::FaceNormal ? face_normal(*geometry, geometry->faces[0]) : up;
	set_geometry(shape, result);
	if (!keeps_axes) {
		turn_to(shape, axis, builder, arena);
		if (height < 0.0) {
			make_negative(shape, 1);
		}
	}
	return true;
}

bool taper(Shape &shape, double height, GeometryBuilder &builder, Arena &arena) {
	const Geometry *geometry = baked(shape, arena);
	glm::dvec3 center;
	if (geometry == nullptr || geometry->point_count < 3 || !center_of_gravity(geometry->outline(geometry->faces[0]), center)) {
		return false;
	}
	const auto outline = geometry->outline(geometry->faces[0]);
	const glm::dvec3 normal = face_normal(*geometry, geometry->faces[0]);
	const glm::dvec3 apex = center + normal * height;
	Loop base(outline.begin(), outline.end());
	if (height < 0.0) {
		reverse_keeping_first_edge(base);
	}
	builder.clear();
	for (size_t i = 0; i < base.size(); ++i) {
		builder.add_loop(Loop{ base[i], base[(i + 1) % base.size()], apex });
		builder.end_face();
	}
	reverse_keeping_first_edge(base);
	builder.add_loop(base);
	builder.end_face();
	set_geometry(shape, builder.finish(arena, true));
	turn_to(shape, normal, builder, arena);
	if (height < 0.0) {
		make_negative(shape, 1);
	}
	return true;
}

void reverse_normals(Shape &shape, GeometryBuilder &builder, Arena &arena) {
	if (shape.geometry == nullptr) {
		return;
	}
	const Geometry &geometry = *shape.geometry;
	builder.begin(geometry, glm::dmat3(-1.0));
	for (uint32_t f = 0; f < geometry.face_count; ++f) {
		const GeometryFace &face = geometry.faces[f];
		for (uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
			const uint32_t first = geometry.first_point(l), count = geometry.loop_ends[l] - first;
			for (uint32_t i = 0; i < count; ++i) {
				const uint32_t corner = first + reversed_index(i, count);
				builder.add_corner(geometry.points[corner], corner);
			}
			builder.end_loop(1);
		}
		builder.end_face(face.tag, face.material);
	}
	shape.geometry = builder.finish(arena, false); // inside out: cuts of it have no caps
}

} // namespace pcg::cga
