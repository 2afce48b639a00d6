#include "core/cga/append.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace pcg::cga {

Appender::Appender(Arena &arena, std::span<const Geometry *const> parts) : _arena(arena) {
	for (const Geometry *part : parts) {
		if (part != nullptr) {
			_result.point_count += part->point_count;
			_result.loop_count += part->loop_count;
			_result.face_count += part->face_count;
			_has_corners |= part->corners != nullptr;
			_is_closed &= part->is_closed;
		}
	}
	_points = arena.allocate<glm::dvec3>(_result.point_count);
	_loop_ends = arena.allocate<uint32_t>(_result.loop_count);
	_faces = arena.allocate<GeometryFace>(_result.face_count);
	if (_has_corners) {
		_corners = arena.make(CornerData{});
	}
}

void Appender::add(const Geometry &source, const Frame &to_target) {
	for (uint32_t i = 0; i < source.point_count; ++i) {
		_points[_point + i] = to_target.to_parent(source.points[i]);
	}
	add_corners(source, to_target);
	for (uint32_t i = 0; i < source.loop_count; ++i) {
		_loop_ends[_loop + i] = _point + source.loop_ends[i];
	}
	for (uint32_t i = 0; i < source.face_count; ++i) {
		GeometryFace face = source.faces[i];
		face.first_loop += _loop;
		_faces[_face + i] = face;
	}
	_point += source.point_count;
	_loop += source.loop_count;
	_face += source.face_count;
}

const Geometry *Appender::finish() {
	_result.points = _points;
	_result.loop_ends = _loop_ends;
	_result.faces = _faces;
	_result.corners = _corners;
	_result.is_closed = _is_closed;
	_result.low = glm::dvec3(INFINITY);
	_result.high = glm::dvec3(-INFINITY);
	for (uint32_t i = 0; i < _result.point_count; ++i) {
		_result.low = glm::min(_result.low, _points[i]);
		_result.high = glm::max(_result.high, _points[i]);
	}
	return _result.face_count > 0 ? _arena.make(_result) : nullptr;
}

void Appender::add_corners(const Geometry &source, const Frame &to_target) {
	for (size_t set = 0; set < uv_set_count && source.corners != nullptr; ++set) {
		if (source.corners->uvs[set] != nullptr) {
			std::copy_n(source.corners->uvs[set], source.point_count, const_cast<glm::dvec2 *>(uvs(set)) + _point);
		}
	}
	if (source.corners != nullptr && source.corners->normals != nullptr) {
		for (uint32_t i = 0; i < source.point_count; ++i) {
			const_cast<glm::dvec3 *>(normals())[_point + i] = to_target.axes * source.corners->normals[i];
		}
	}
}

const glm::dvec2 *Appender::uvs(size_t set) {
	if (_corners->uvs[set] == nullptr) {
		glm::dvec2 *all = _arena.allocate<glm::dvec2>(_result.point_count);
		std::fill_n(all, _result.point_count, no_uv());
		_corners->put(set, all);
	}
	return _corners->uvs[set];
}

const glm::dvec3 *Appender::normals() {
	if (_corners->normals == nullptr) {
		glm::dvec3 *all = _arena.allocate<glm::dvec3>(_result.point_count);
		std::fill_n(all, _result.point_count, glm::dvec3(0.0));
		_corners->normals = all;
	}
	return _corners->normals;
}

} // namespace pcg::cga
