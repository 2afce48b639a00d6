#include "core/cga/geometry.h"

#include <algorithm>
#include <limits>

#include "core/cga/corner_data.h"
#include "core/geometry/polygon.h"

namespace pcg::cga {

namespace {

bool is_at_bounds(glm::dvec3 point, const Geometry &geometry, glm::dvec3 margin) {
	const auto is_at_end = [](double at, double low, double high, double off) { return at - low <= off || high - at <= off; };
	return is_at_end(point.x, geometry.low.x, geometry.high.x, margin.x) && is_at_end(point.y, geometry.low.y, geometry.high.y, margin.y) &&
			is_at_end(point.z, geometry.low.z, geometry.high.z, margin.z);
}

bool detect_block(const Geometry &geometry) {
	const bool is_box = geometry.face_count == 6 && geometry.is_closed && geometry.point_count == 24;
	const bool is_rectangle = geometry.face_count == 1 && geometry.point_count == 4;
	const bool is_smooth = geometry.corners != nullptr && geometry.corners->normals != nullptr;
	if (is_smooth || geometry.loop_count != geometry.face_count || (!is_box && !is_rectangle)) {
		return false;
	}
	const glm::dvec3 margin = 1e-9 * (geometry.high - geometry.low);
	for (uint32_t i = 0; i < geometry.point_count; ++i) {
		if (!is_at_bounds(geometry.points[i], geometry, margin)) {
			return false;
		}
	}
	return true;
}

void widen(double &low, double &high, double value) {
	low = value < low ? value : low;
	high = high < value ? value : high;
}

// In variables of their own, which the compiler keeps in registers.
void set_bounds(Geometry &geometry) {
	const std::span<const glm::dvec3> points(geometry.points, geometry.point_count);
	glm::dvec3 low = points[0], high = points[0];
	for (const glm::dvec3 &point : points.subspan(1)) {
		widen(low.x, high.x, point.x);
		widen(low.y, high.y, point.y);
		widen(low.z, high.z, point.z);
	}
	geometry.low = low;
	geometry.high = high;
}

} // namespace

glm::dvec2 no_uv() {
	return glm::dvec2(std::numeric_limits<double>::quiet_NaN());
}

void GeometryBuilder::clear() {
	_source = nullptr;
	_origins.clear();
	_points.clear();
	_loop_ends.clear();
	_faces.clear();
	_face_first_loop = 0;
}

void GeometryBuilder::begin(const Geometry &source) {
	clear();
	_source = source.corners != nullptr ? &source : nullptr;
	_turn = glm::dmat3(1.0);
}

void GeometryBuilder::begin(const Geometry &source, const glm::dmat3 &turn) {
	begin(source);
	_turn = turn;
}

bool GeometryBuilder::add_loop(std::span<const glm::dvec3> loop, std::span<const CornerOrigin> origins) {
	if (_source != nullptr && !origins.empty()) {
		_origins.resize(_points.size());
		_origins.insert(_origins.end(), origins.begin(), origins.end());
	}
	return add_loop(loop);
}

bool GeometryBuilder::add_loop(const Geometry &source, uint32_t loop) {
	add_points(source, source.first_point(loop), source.loop_ends[loop] - source.first_point(loop));
	return end_loop();
}

void GeometryBuilder::note_origin(CornerOrigin origin) {
	_origins.resize(_points.size());
	_origins.back() = origin;
}

void GeometryBuilder::add_points(const Geometry &source, uint32_t first, uint32_t count) {
	if (_source == &source) {
		_origins.resize(_points.size());
		for (uint32_t i = 0; i < count; ++i) {
			_origins.push_back({ first + i });
		}
	}
	_points.insert(_points.end(), source.points + first, source.points + first + count);
}

bool GeometryBuilder::has_doubles(size_t first) const {
	const glm::dvec3 *last = &_points.back();
	for (size_t i = first; i < _points.size(); last = &_points[i++]) {
		if (*last == _points[i]) {
			return true;
		}
	}
	return false;
}

// The same corners stay as in merge_doubles(), which goes by the points alone.
void GeometryBuilder::merge_origins(size_t first) {
	_origins.resize(_points.size());
	size_t kept = first;
	for (size_t i = first; i < _points.size(); ++i) {
		if (i == first || _points[i] != _points[i - 1]) {
			_origins[kept++] = _origins[i];
		}
	}
}

bool GeometryBuilder::end_loop(size_t least) {
	const size_t first = _loop_ends.empty() ? 0 : _loop_ends.back(), count = _points.size() - first;
	if (count < least || (count > 1 && has_doubles(first))) {
		return merge_doubles(first, least);
	}
	_loop_ends.push_back(uint32_t(_points.size()));
	return true;
}

bool GeometryBuilder::merge_doubles(size_t first, size_t least) {
	if (_origins.size() > first) {
		merge_origins(first);
	}
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
	if (_origins.size() > _points.size()) {
		_origins.resize(_points.size());
	}
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
		const uint32_t first = source.first_point(face.first_loop + i);
		add_points(source, first, source.loop_ends[face.first_loop + i] - first);
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
	Geometry &geometry = *arena.make<Geometry>();
	geometry.points = arena.copy(_points.data(), _points.size());
	geometry.loop_ends = arena.copy(_loop_ends.data(), _loop_ends.size());
	geometry.faces = arena.copy(_faces.data(), _faces.size());
	geometry.point_count = uint32_t(_points.size());
	geometry.loop_count = uint32_t(_loop_ends.size());
	geometry.face_count = uint32_t(_faces.size());
	geometry.is_closed = is_closed;
	set_bounds(geometry);
	if (!_origins.empty()) {
		geometry.corners = carry_corner_data(*_source, _points, _origins, _turn, arena);
	}
	geometry.is_block = detect_block(geometry);
	return &geometry;
}

Geometry *make_polygon(std::span<const glm::dvec3> points, FaceTag tag, uint16_t material, Arena &arena) {
	Geometry &geometry = *arena.make<Geometry>();
	geometry.points = points.data();
	geometry.point_count = uint32_t(points.size());
	geometry.loop_ends = arena.make(geometry.point_count);
	geometry.faces = arena.make(GeometryFace{ 0, 1, tag, material });
	geometry.loop_count = geometry.face_count = 1;
	set_bounds(geometry);
	geometry.is_block = detect_block(geometry);
	return &geometry;
}

glm::dvec3 face_normal(const Geometry &geometry, const GeometryFace &face) {
	return loop_normal(geometry.outline(face));
}

const Geometry *with_uvs(const Geometry &geometry, size_t set, const glm::dvec2 *uvs, Arena &arena) {
	CornerData *corners = geometry.corners != nullptr ? arena.make(*geometry.corners) : arena.make<CornerData>();
	corners->put(set, uvs);
	const auto has_set = [](const glm::dvec2 *other) { return other != nullptr; };
	const bool has_any = uvs != nullptr || corners->normals != nullptr || std::ranges::any_of(corners->uvs, has_set);
	Geometry *result = arena.make(geometry);
	result->corners = has_any ? corners : nullptr;
	result->is_block = geometry.is_block || detect_block(*result);
	return result;
}

} // namespace pcg::cga
