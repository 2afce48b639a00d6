#include "core/cga/along_uv.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace pcg::cga {

namespace {

constexpr double tolerance = 1e-9;
constexpr double max_tiles = 100'000.0; // along one axis of one face

double cross(glm::dvec2 a, glm::dvec2 b) {
	return a.x * b.y - a.y * b.x;
}

// A part of the ground over which places are linear in the coordinates. Three corners, or four if they agree.
struct Piece {
	std::vector<glm::dvec2> uvs;
	std::vector<glm::dvec3> points, ups;

	double turn() const { return cross(uvs[1] - uvs[0], uvs[2] - uvs[0]); }
	// Shares of the second and third corner.
	glm::dvec2 shares(glm::dvec2 uv) const {
		const glm::dvec2 d = uv - uvs[0];
		return glm::dvec2(cross(d, uvs[2] - uvs[0]), cross(uvs[1] - uvs[0], d)) / turn();
	}
	static glm::dvec3 mixed(const std::vector<glm::dvec3> &values, glm::dvec2 share) {
		return values[0] + share.x * (values[1] - values[0]) + share.y * (values[2] - values[0]);
	}
	glm::dvec3 place(glm::dvec3 uvh) const {
		const glm::dvec2 share = shares(glm::dvec2(uvh));
		const glm::dvec3 up = mixed(ups, share);
		const double length = glm::length(up);
		return mixed(points, share) + (length > tolerance ? uvh.z / length : 0.0) * up;
	}
	Piece corners(std::initializer_list<size_t> which) const {
		Piece part;
		for (size_t i : which) {
			part.uvs.push_back(uvs[i]);
			part.points.push_back(points[i]);
			part.ups.push_back(ups[i]);
		}
		return part;
	}
	// Whether the surface's coordinates run clockwise, seen from above: then what is bent along it is mirrored.
	bool is_mirrored() const {
		const glm::dvec3 du = mixed(points, shares(uvs[0] + glm::dvec2(1.0, 0.0))) - points[0];
		const glm::dvec3 dv = mixed(points, shares(uvs[0] + glm::dvec2(0.0, 1.0))) - points[0];
		return glm::dot(glm::cross(du, dv), ups[0]) < 0.0;
	}
};

// Geometry that comes from several sources, with the texture coordinates of all of them.
class Collector {
public:
	size_t face_count() const { return _faces.size(); }

	void add(const Geometry &source, const Piece &piece, glm::dvec2 tile, bool is_mirrored) {
		for (size_t set = 0; set < uv_set_count; ++set) {
			_has_set[set] = _has_set[set] || source.uvs(set) != nullptr;
		}
		for (uint32_t f = 0; f < source.face_count; ++f) {
			const GeometryFace &face = source.faces[f];
			_faces.push_back({ uint32_t(_loop_ends.size()), face.loop_count, face.tag, face.material });
			for (uint32_t i = face.first_loop; i < face.first_loop + face.loop_count; ++i) {
				const uint32_t first = source.first_point(i), count = source.loop_ends[i] - first;
				for (uint32_t k = 0; k < count; ++k) {
					const uint32_t corner = first + (is_mirrored ? (1 + count - k) % count : k); // the first edge stays the first
					_points.push_back(piece.place(source.points[corner] + glm::dvec3(tile, 0.0)));
					for (size_t set = 0; set < uv_set_count; ++set) {
						_uvs[set].push_back(source.uvs(set) != nullptr ? source.uvs(set)[corner] : no_uv());
					}
				}
				_loop_ends.push_back(uint32_t(_points.size()));
			}
		}
	}

	const Geometry *finish(Arena &arena) const {
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
		geometry.low = geometry.high = _points.front();
		for (const glm::dvec3 &point : _points) {
			geometry.low = glm::min(geometry.low, point);
			geometry.high = glm::max(geometry.high, point);
		}
		CornerData corners;
		for (size_t set = 0; set < uv_set_count; ++set) {
			corners.put(set, _has_set[set] ? arena.copy(_uvs[set].data(), _uvs[set].size()) : nullptr);
		}
		geometry.corners = std::ranges::find(_has_set, true) != _has_set.end() ? arena.make(corners) : nullptr;
		return arena.make(geometry);
	}

private:
	std::vector<glm::dvec3> _points;
	std::vector<uint32_t> _loop_ends;
	std::vector<GeometryFace> _faces;
	std::array<std::vector<glm::dvec2>, uv_set_count> _uvs;
	std::array<bool, uv_set_count> _has_set = {};
};

// The asset in (u, v, height), filling one square; without normals, which would not fit what is bent.
const Geometry *unit_of(const Geometry &asset, const AlongUv &settings, Arena &arena) {
	const glm::dvec3 extent = asset.high - asset.low;
	const auto share = [&](double value, int axis) { return extent[axis] > 0.0 ? (value - asset.low[axis]) / extent[axis] : 0.0; };
	const double scale = extent.y > 0.0 ? settings.height / extent.y : 1.0;
	glm::dvec3 *points = arena.allocate<glm::dvec3>(asset.point_count);
	for (uint32_t i = 0; i < asset.point_count; ++i) {
		const glm::dvec3 point = asset.points[i];
		const double from = settings.keeps_position ? 0.0 : asset.low.y;
		points[i] = { share(point.x, 0), 1.0 - share(point.z, 2), (point.y - from) * scale };
	}
	Geometry *unit = arena.make(asset);
	unit->points = points;
	unit->is_block = false;
	if (asset.corners != nullptr) {
		CornerData corners = *asset.corners;
		corners.normals = nullptr;
		unit->corners = arena.make(corners);
	}
	unit->low = unit->high = points[0];
	for (uint32_t i = 0; i < asset.point_count; ++i) {
		unit->low = glm::min(unit->low, points[i]);
		unit->high = glm::max(unit->high, points[i]);
	}
	return unit;
}

class UvInserter {
public:
	UvInserter(const Geometry &ground, const Geometry &unit, const AlongUv &settings, Clipper &clipper) :
			_ground(ground), _unit(unit), _settings(settings), _clipper(clipper) {}

	AlongUvResult run(Arena &arena) {
		if (_settings.direction == AlongUv::Direction::VertexNormal) {
			collect_normals();
		}
		for (uint32_t i = 0; i < _ground.face_count && !_is_cut_short; ++i) {
			add_face(_ground.faces[i]);
		}
		return { _collector.finish(arena), _is_cut_short };
	}

private:
	using Key = std::array<double, 3>;
	static Key key_of(glm::dvec3 point) { return { point.x, point.y, point.z }; }

	void collect_normals() {
		for (uint32_t i = 0; i < _ground.face_count; ++i) {
			const glm::dvec3 normal = face_normal(_ground, _ground.faces[i]);
			for (const glm::dvec3 &point : _ground.outline(_ground.faces[i])) {
				_normals[key_of(point)] += normal;
			}
		}
	}

	void add_face(const GeometryFace &face) {
		const auto outline = _ground.outline(face);
		if (face.loop_count != 1 || outline.size() < 3 || outline.size() > 4) {
			return;
		}
		Piece whole;
		for (size_t i = 0; i < outline.size(); ++i) {
			whole.points.push_back(outline[i]);
			whole.uvs.push_back(_ground.uvs(_settings.uv_set)[_ground.first_point(face.first_loop) + i]);
			if (!has_uv(whole.uvs.back())) {
				return;
			}
			whole.ups.push_back(_normals.empty() ? glm::dvec3(0.0, 1.0, 0.0) : _normals[key_of(outline[i])]);
		}
		if (outline.size() == 3) {
			add_piece(whole);
		} else if (is_linear(whole)) {
			add_piece(whole);
		} else {
			// Along the diagonal that lies inside of the coordinates' quad.
			const bool is_first = whole.corners({ 0, 1, 2 }).turn() * whole.corners({ 0, 2, 3 }).turn() > 0.0;
			add_piece(is_first ? whole.corners({ 0, 1, 2 }) : whole.corners({ 1, 2, 3 }));
			add_piece(is_first ? whole.corners({ 0, 2, 3 }) : whole.corners({ 1, 3, 0 }));
		}
	}

	static bool is_linear(const Piece &quad) {
		const double turn = quad.turn();
		if (std::abs(turn) < tolerance * tolerance) {
			return false;
		}
		bool is_convex = true, is_even = true;
		for (size_t i = 0; i < 4; ++i) {
			const glm::dvec2 a = quad.uvs[i], b = quad.uvs[(i + 1) % 4], c = quad.uvs[(i + 2) % 4];
			is_convex = is_convex && cross(b - a, c - b) * turn > 0.0;
			is_even = is_even && glm::distance(glm::normalize(quad.ups[i]), glm::normalize(quad.ups[0])) < tolerance;
		}
		const double size = glm::distance(quad.points[0], quad.points[2]);
		return is_convex && is_even && glm::distance(Piece::mixed(quad.points, quad.shares(quad.uvs[3])), quad.points[3]) < 1e-7 * size;
	}

	void add_piece(const Piece &piece) {
		if (std::abs(piece.turn()) < tolerance * tolerance || _is_cut_short) {
			return;
		}
		std::vector<Plane> planes;
		const double side = piece.turn() > 0.0 ? 1.0 : -1.0;
		glm::dvec2 low = piece.uvs[0], high = low;
		for (size_t i = 0; i < piece.uvs.size(); ++i) {
			const glm::dvec2 a = piece.uvs[i], along = piece.uvs[(i + 1) % piece.uvs.size()] - a;
			const glm::dvec2 inwards = side * glm::dvec2(-along.y, along.x) / std::max(glm::length(along), tolerance);
			planes.push_back({ glm::dvec3(inwards, 0.0), glm::dot(inwards, a) });
			low = glm::min(low, a);
			high = glm::max(high, a);
		}
		low = glm::floor(low + 1e-6);
		high = glm::max(glm::ceil(high - 1e-6), low + 1.0);
		if (!(high.x - low.x < max_tiles && high.y - low.y < max_tiles)) {
			_is_cut_short = true;
			return;
		}
		const bool is_mirrored = piece.is_mirrored() != (_settings.height < 0.0);
		for (double v = low.y; v < high.y && !_is_cut_short; ++v) {
			for (double u = low.x; u < high.x && !_is_cut_short; ++u) {
				add_tile(piece, planes, { u, v }, is_mirrored);
			}
		}
	}

	void add_tile(const Piece &piece, const std::vector<Plane> &planes, glm::dvec2 tile, bool is_mirrored) {
		const Arena::Mark mark = _scratch.mark();
		const Geometry *rest = &_unit;
		for (const Plane &plane : planes) {
			const Plane shifted{ plane.normal, plane.offset - plane.normal.x * tile.x - plane.normal.y * tile.y };
			const double least = std::min(0.0, plane.normal.x) + std::min(0.0, plane.normal.y); // of the square's corners
			if (rest != nullptr && least < shifted.offset - 1e-6) {
				rest = _clipper.clip(*rest, shifted, _scratch, Clipper::Cuts::Open);
			}
		}
		if (rest != nullptr) {
			_collector.add(*rest, piece, tile, is_mirrored);
		}
		_is_cut_short = _collector.face_count() > _settings.max_faces || ++_tiles > _settings.max_faces;
		_scratch.release(mark);
	}

	const Geometry &_ground;
	const Geometry &_unit;
	const AlongUv &_settings;
	Clipper &_clipper;
	Arena _scratch;
	Collector _collector;
	std::map<Key, glm::dvec3> _normals; // sums, by place
	uint64_t _tiles = 0;
	bool _is_cut_short = false;
};

} // namespace

AlongUvResult insert_along_uv(const Geometry &ground, const Geometry &asset, const AlongUv &settings, Clipper &clipper, Arena &arena) {
	if (ground.uvs(settings.uv_set) == nullptr) {
		return {};
	}
	Arena unit_arena;
	const Geometry *unit = unit_of(asset, settings, unit_arena);
	return UvInserter(ground, *unit, settings, clipper).run(arena);
}

} // namespace pcg::cga
