#include "core/cga/extrude.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/cga/edges.h"
#include "core/cga/frames.h"

namespace pcg::cga {

namespace {

using enum ExtrudeDirection;

// Where a corner of a loop that was reversed so that its first edge stays first stood before.
uint32_t reversed_index(size_t index, size_t count) {
	return uint32_t((count + 1 - index) % count);
}

// Of edges what comp() has noted with them, else z of their scope.
glm::dvec3 normal_of(const Geometry &geometry, const GeometryFace &face) {
	if (geometry.outline(face).size() >= 3) {
		return face_normal(geometry, face);
	}
	const uint32_t corner = geometry.first_point(face.first_loop);
	const bool is_noted = geometry.corners != nullptr && geometry.corners->normals != nullptr;
	return is_noted ? geometry.corners->normals[corner] : glm::dvec3(0.0, 0.0, 1.0);
}

class Extruder {
public:
	Extruder(const Geometry &geometry, ExtrudeDirection direction, double height, glm::dvec3 axis, bool is_hollow, GeometryBuilder &builder)
			: _geometry(geometry), _direction(direction), _height(height), _axis(axis), _is_hollow(is_hollow), _builder(builder) {
		_builder.begin(geometry, glm::dmat3(0.0)); // flat shaded
	}

	// nullptr: there is nothing to raise.
	const Geometry *run(Arena &arena) {
		if (_direction == WorldUpFlatTop && !find_level()) {
			return nullptr;
		}
		if (_direction == VertexNormal) {
			find_vertex_normals();
		}
		if (_geometry.face_count > 1) {
			find_inner_walls();
		}
		bool is_closed = true;
		for (uint32_t i = 0; i < _geometry.face_count; ++i) {
			is_closed &= add_prism(_geometry.faces[i]);
		}
		return _builder.finish(arena, is_closed);
	}

	// Where the first face or the first vertex goes.
	glm::dvec3 first_direction() const {
		return _direction == FaceNormal ? normal_of(_geometry, _geometry.faces[0]) : _direction == VertexNormal ? _vertex_normals[0] : _axis;
	}

private:
	// Where a flat top lies: over the lowest point of the shape, but not below the highest; downwards the other way around. False: it is there.
	bool find_level() {
		double low = glm::dot(_geometry.points[0], _axis), high = low;
		for (uint32_t i = 1; i < _geometry.point_count; ++i) {
			low = std::min(low, glm::dot(_geometry.points[i], _axis));
			high = std::max(high, glm::dot(_geometry.points[i], _axis));
		}
		_level = _height >= 0.0 ? std::max(low + _height, high) : std::min(high + _height, low);
		return std::max(std::abs(_level - low), std::abs(_level - high)) > 1e-9;
	}

	// Mean of the normals of the faces that meet at each corner.
	void find_vertex_normals() {
		std::vector<uint32_t> order(_geometry.point_count);
		std::iota(order.begin(), order.end(), 0);
		std::ranges::stable_sort(order, {}, [&](uint32_t corner) { return FaceEdge::key_of(_geometry.points[corner]); });
		std::vector<glm::dvec3> normals(_geometry.point_count);
		for (uint32_t f = 0; f < _geometry.face_count; ++f) {
			const GeometryFace &face = _geometry.faces[f];
			const uint32_t first = _geometry.first_point(face.first_loop);
			std::fill_n(normals.begin() + first, _geometry.face_point_count(face), normal_of(_geometry, face));
		}
		_vertex_normals.resize(normals.size());
		for (size_t i = 0; i < order.size();) {
			size_t end = i;
			glm::dvec3 sum(0.0);
			for (; end < order.size() && _geometry.points[order[end]] == _geometry.points[order[i]]; ++end) {
				sum += normals[order[end]];
			}
			const bool is_clear = glm::length(sum) > 1e-9;
			for (; i < end; ++i) {
				_vertex_normals[order[i]] = is_clear ? glm::normalize(sum) : normals[order[i]];
			}
		}
	}

	// Faces that are raised alike share no wall along their common edge.
	void find_inner_walls() {
		_is_inner.assign(_geometry.point_count, false);
		const bool is_alike = _direction != FaceNormal;
		for_each_edge_group(grouped_edges(_geometry), [&](std::span<const FaceEdge> group) {
			for (size_t i = 0; i < group.size() && group.size() > 1; ++i) {
				for (size_t k = 0; k < group.size(); ++k) {
					const bool is_same = i == k || is_edge(group[i].face) || is_edge(group[k].face);
					if (!is_same && (is_alike || are_coplanar(group[i].face, group[k].face))) {
						_is_inner[group[i].corner] = true;
					}
				}
			}
		});
	}
	bool is_edge(uint32_t face) const { return _geometry.outline(_geometry.faces[face]).size() < 3; }
	bool are_coplanar(uint32_t a, uint32_t b) const {
		return glm::dot(face_normal(_geometry, _geometry.faces[a]), face_normal(_geometry, _geometry.faces[b])) > 1.0 - 1e-9;
	}

	glm::dvec3 raised(uint32_t corner, glm::dvec3 normal) const {
		const glm::dvec3 point = _geometry.points[corner];
		switch (_direction) {
			case FaceNormal:
				return point + normal * _height;
			case VertexNormal:
				return point + _vertex_normals[corner] * _height;
			case WorldUpFlatTop:
				return point + _axis * (_level - glm::dot(point, _axis));
			default:
				return point + _axis * _height;
		}
	}

	// False: it was an edge, which makes no solid.
	bool add_prism(const GeometryFace &face) {
		const glm::dvec3 normal = normal_of(_geometry, face);
		if (_geometry.outline(face).size() < 3) {
			add_band(face, normal);
			return false;
		}
		const bool is_along_axis = _direction != FaceNormal && _direction != VertexNormal;
		const double rise = is_along_axis ? glm::dot(_axis, normal) : 1.0;
		if (std::abs(rise) < 1e-6) {
			return true;
		}
		// Outwards means: the bottom looks away from the direction. A hollow is the same, seen from inside.
		const double height = _direction == WorldUpFlatTop && _height == 0.0 ? 1.0 : _height;
		_is_flipped = (rise * height < 0.0) != (_is_hollow && _height < 0.0);
		add_cap(face, normal, true);
		add_cap(face, normal, false);
		add_walls(face, normal);
		return true;
	}

	// The corner of the source that corner `index` of a loop of the prism stands over.
	uint32_t corner_of(uint32_t loop, size_t index) const {
		return _geometry.first_point(loop) + (_is_flipped ? reversed_index(index, _geometry.loop(loop).size()) : uint32_t(index));
	}

	void add_cap(const GeometryFace &face, glm::dvec3 normal, bool is_bottom) {
		for (uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
			const size_t count = _geometry.loop(l).size();
			for (size_t i = 0; i < count; ++i) {
				const uint32_t corner = corner_of(l, is_bottom ? reversed_index(i, count) : i);
				_builder.add_corner(is_bottom ? _geometry.points[corner] : raised(corner, normal), corner);
			}
			_builder.end_loop();
		}
		_builder.end_face(FaceTag::None, face.material);
	}

	void add_walls(const GeometryFace &face, glm::dvec3 normal) {
		for (uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
			const size_t count = _geometry.loop(l).size();
			for (size_t i = 0; i < count; ++i) {
				const uint32_t from = corner_of(l, i), to = corner_of(l, (i + 1) % count);
				if (_is_inner.empty() || !_is_inner[_is_flipped ? to : from]) {
					add_wall(face, from, to, normal);
				}
			}
		}
	}

	void add_wall(const GeometryFace &face, uint32_t from, uint32_t to, glm::dvec3 normal) {
		_builder.add_corner(_geometry.points[from], from);
		_builder.add_corner(_geometry.points[to], to);
		_builder.add_corner(raised(to, normal), to);
		_builder.add_corner(raised(from, normal), from);
		_builder.end_loop();
		_builder.end_face(FaceTag::None, face.material);
	}

	void add_band(const GeometryFace &face, glm::dvec3 normal) {
		if (_geometry.outline(face).size() == 2) {
			const uint32_t from = _geometry.first_point(face.first_loop);
			add_wall(face, from, from + 1, normal);
		}
	}

	const Geometry &_geometry;
	ExtrudeDirection _direction;
	double _height;
	glm::dvec3 _axis; // of the directions that are the same for all faces
	bool _is_hollow;
	double _level = 0.0; // of a flat top, along the axis
	bool _is_flipped = false; // the prism's loops run against those of the face it stands on
	std::vector<glm::dvec3> _vertex_normals; // by corner
	std::vector<bool> _is_inner; // by the corner at which an edge begins; empty: none is
	GeometryBuilder &_builder;
};

// Of a direction that is the same for all faces, in scope coordinates.
glm::dvec3 axis_of(ExtrudeDirection direction, const Shape &shape) {
	const int axis = direction == WorldX || direction == ScopeX ? 0 : direction == WorldZ || direction == ScopeZ ? 2 : 1;
	glm::dvec3 result(0.0);
	result[axis] = 1.0;
	const bool is_scope = direction == ScopeX || direction == ScopeY || direction == ScopeZ;
	return is_scope ? result : glm::transpose(shape.frame().axes) * result;
}

} // namespace

bool extrude(Shape &shape, ExtrudeDirection direction, double height, bool keeps_axes, GeometryBuilder &builder, Arena &arena) {
	const Geometry *geometry = baked(shape, arena);
	if (geometry == nullptr) {
		return false;
	}
	if (std::abs(height) < 1e-9 && direction != WorldUpFlatTop) {
		return true;
	}
	Extruder extruder(*geometry, direction, height, axis_of(direction, shape), keeps_axes, builder);
	const Geometry *result = extruder.run(arena);
	if (result == nullptr) {
		return direction == WorldUpFlatTop;
	}
	set_geometry(shape, result);
	if (!keeps_axes) {
		turn_scope_to(shape, extruder.first_direction(), builder, arena);
		if (height < 0.0) {
			mirror_scope(shape, 1);
		}
	}
	return true;
}

} // namespace pcg::cga
