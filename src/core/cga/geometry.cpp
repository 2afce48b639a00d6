#include "core/cga/geometry.h"

#include <glm/common.hpp>

#include "core/geometry/polygon.h"

namespace pcg::cga {

namespace {

bool is_at_bounds(glm::dvec3 point, const Geometry &geometry) {
	const glm::dvec3 margin = 1e-9 * (geometry.high - geometry.low);
	for (int axis = 0; axis < 3; ++axis) {
		const bool is_low = point[axis] - geometry.low[axis] <= margin[axis];
		const bool is_high = geometry.high[axis] - point[axis] <= margin[axis];
		if (!is_low && !is_high) {
			return false;
		}
	}
	return true;
}

bool detect_block(const Geometry &geometry) {
	const bool is_box = geometry.face_count == 6 && geometry.is_closed && geometry.point_count == 24;
	const bool is_rectangle = geometry.face_count == 1 && geometry.point_count == 4;
	if (geometry.loop_count != geometry.face_count || (!is_box && !is_rectangle)) {
		return false;
	}
	for (uint32_t i = 0; i < geometry.point_count; ++i) {
		if (!is_at_bounds(geometry.points[i], geometry)) {
			return false;
		}
	}
	return true;
}

} // namespace

void GeometryBuilder::clear() {
	_points.clear();
	_loop_ends.clear();
	_faces.clear();
	_face_first_loop = 0;
}

bool GeometryBuilder::end_loop(size_t least) {
	const size_t first = _loop_ends.empty() ? 0 : _loop_ends.back();
	size_t kept = first;
	for (size_t i = first; i < _points.size(); ++i) {
		if (kept == first || _points[i] != _points[kept - 1]) {
			_points[kept++] = _points[i];
		}
	}
	while (kept > first + 1 && _points[kept - 1] == _points[first]) {
		--kept;
	}
	const bool is_kept = kept - first >= least;
	_points.resize(is_kept ? kept : first);
	if (is_kept) {
		_loop_ends.push_back(uint32_t(kept));
	}
	return is_kept;
}

void GeometryBuilder::end_face(FaceTag tag, uint16_t material) {
	const uint32_t count = uint32_t(_loop_ends.size()) - _face_first_loop;
	if (count > 0) {
		_faces.push_back({ _face_first_loop, uint16_t(count), tag, material });
	}
	_face_first_loop = uint32_t(_loop_ends.size());
}

void GeometryBuilder::add_face(const Geometry &source, const GeometryFace &face) {
	for (uint32_t i = 0; i < face.loop_count; ++i) {
		const auto loop = source.loop(face.first_loop + i);
		_points.insert(_points.end(), loop.begin(), loop.end());
		_loop_ends.push_back(uint32_t(_points.size()));
	}
	end_face(face.tag, face.material);
}

void GeometryBuilder::add_quad(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::dvec3 d, FaceTag tag) {
	_points.insert(_points.end(), { a, b, c, d });
	end_loop();
	end_face(tag);
}

const Geometry *GeometryBuilder::finish(Arena &arena, bool is_closed) const {
	if (_faces.empty()) {
		return nullptr;
	}
	Geometry geometry;
	geometry.points = arena.copy(_points.data(), _points.size());
	geometry.loop_ends = arena.copy(_loop_ends.data(), _loop_ends.size());
	geometry.faces = arena.copy(_faces.data(), _faces.size());
	geometry.point_count = uint32_t(_points.size());
	geometry.loop_count = uint32_t(_loop_ends.size());
	geometry.face_count = uint32_t(_faces.size());
	geometry.is_closed = is_closed;
	geometry.low = geometry.high = _points.front();
	for (const glm::dvec3 &point : _points) {
		geometry.low = glm::min(geometry.low, point);
		geometry.high = glm::max(geometry.high, point);
	}
	geometry.is_block = detect_block(geometry);
	return arena.make(geometry);
}

glm::dvec3 face_normal(const Geometry &geometry, const GeometryFace &face) {
	return loop_normal(geometry.outline(face));
}

} // namespace pcg::cga
