#include "core/cga/clip.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/geometry/polygon.h"

namespace pcg::cga {

namespace {

// `enter`: the last corner of the outline that is out; `inside`: how many are in.
bool comes_in_once(std::span<const double> distances, uint32_t &enter, uint32_t &inside) {
	const uint32_t count = uint32_t(distances.size());
	uint32_t enters = 0;
	bool was_in = distances[count - 1] > 0.0;
	for (uint32_t i = 0; i < count; ++i) {
		const bool is_in = distances[i] > 0.0;
		inside += is_in;
		if (!was_in && is_in) {
			enter = i > 0 ? i - 1 : count - 1;
			++enters;
		}
		was_in = is_in;
	}
	return enters == 1;
}

} // namespace

const Geometry *Clipper::clip(const Geometry &geometry, const Plane &plane, Arena &arena, Cuts cuts) {
	_uvs = nullptr;
	_normal = plane.normal;
	_has_flush_edges = false;
	measure(geometry, plane);
	const Sides all = sides_of(0, geometry.point_count);
	if (!all.are_cut()) {
		return all.most > 0.0 ? &geometry : nullptr;
	}
	clip_faces(geometry, all);
	const bool is_hollow = geometry.is_closed || geometry.face_count > 2;
	const size_t rest = _builder.face_count();
	const bool is_capped = cuts == Cuts::Closed && is_hollow && add_caps(plane);
	const Geometry *result = _builder.finish(arena, geometry.is_closed && is_capped);
	const GeometryFace &first = geometry.faces[0];
	const bool is_first_gone = !(sides_of(geometry.first_point(first.first_loop), geometry.face_point_count(first)).most > 0.0);
	return is_first_gone && rest > 0 && rest < _builder.face_count() ? with_caps_first(*result, rest, arena) : result;
}

// Where the first face is cut away, what closes the cut takes its place (CGA changelog 2025.1), as the bottom of the upper half of a building does.
const Geometry *Clipper::with_caps_first(const Geometry &geometry, size_t caps, Arena &arena) {
	_builder.begin(geometry);
	for (size_t i = 0; i < geometry.face_count; ++i) {
		_builder.add_face(geometry, geometry.faces[(caps + i) % geometry.face_count]);
	}
	return _builder.finish(arena, geometry.is_closed);
}

const Geometry *Clipper::clip_uv(const Geometry &geometry, size_t set, int axis, double at, bool keeps_above, Arena &arena) {
	_uvs = geometry.uvs(set);
	_uv_axis = axis;
	measure_uv(geometry, at, keeps_above);
	const Sides all = sides_of(0, geometry.point_count);
	if (!all.are_cut()) {
		return all.most > 0.0 ? &geometry : nullptr;
	}
	clip_faces(geometry, all);
	return _builder.finish(arena, false);
}

void Clipper::clip_faces(const Geometry &geometry, const Sides &all) {
	_builder.begin(geometry);
	_cuts.clear();
	for (uint32_t i = 0; i < geometry.face_count; ++i) {
		const GeometryFace &face = geometry.faces[i];
		clip_face(geometry, face, geometry.face_count == 1 ? all : sides_of(geometry.first_point(face.first_loop), geometry.face_point_count(face)));
	}
}

Clipper::Sides Clipper::sides_of(uint32_t first, uint32_t count) const {
	Sides sides;
	for (uint32_t i = first; i < first + count; ++i) {
		const double distance = _distances[i];
		sides.least = distance < sides.least ? distance : sides.least;
		sides.most = sides.most < distance ? distance : sides.most;
		sides.zeros += distance == 0.0;
	}
	return sides;
}

void Clipper::measure_uv(const Geometry &geometry, double at, bool keeps_above) {
	double size = std::abs(at);
	for (uint32_t i = 0; i < geometry.point_count; ++i) {
		size = has_uv(_uvs[i]) ? std::max(size, std::abs(_uvs[i][_uv_axis])) : size;
	}
	const double margin = 1e-10 * size;
	_distances.resize(geometry.point_count);
	for (uint32_t i = 0; i < geometry.point_count; ++i) {
		const double distance = keeps_above ? _uvs[i][_uv_axis] - at : at - _uvs[i][_uv_axis];
		_distances[i] = !has_uv(_uvs[i]) ? -1.0 : std::abs(distance) <= margin ? 0.0 : distance;
	}
}

// Points closer to the plane than rounding can tell lie on it, and count as cut away: then a face in the plane never stays behind, and the
// cap, made from the faces beside it, takes its place.
void Clipper::measure(const Geometry &geometry, const Plane &plane) {
	const glm::dvec3 size = glm::max(glm::abs(geometry.low), glm::abs(geometry.high));
	const double margin = 1e-10 * (size.x + size.y + size.z + std::abs(plane.offset));
	_margin = 10.0 * margin;
	_distances.resize(geometry.point_count);
	for (uint32_t i = 0; i < geometry.point_count; ++i) {
		const double distance = glm::dot(plane.normal, geometry.points[i]) - plane.offset;
		_distances[i] = std::abs(distance) <= margin ? 0.0 : distance;
	}
}

void Clipper::clip_face(const Geometry &geometry, const GeometryFace &face, const Sides &sides) {
	if (sides.most <= 0.0) {
		return;
	}
	if (sides.least > 0.0) {
		_builder.add_face(geometry, face);
		return;
	}
	_has_flush_edges |= sides.least == 0.0;
	const bool may_be_flush = sides.least < 0.0 && sides.zeros > 1 && _uvs == nullptr;
	if (clip_edge(geometry, face) || (!may_be_flush && clip_simple(geometry, face))) {
		return;
	}
	const glm::dvec3 normal = face_normal(geometry, face);
	_along = _uvs == nullptr ? glm::cross(_normal, normal) : glm::dvec3(0.0);
	_is_square = std::abs(glm::dot(_normal, normal)) < 1e-9;
	_flush_corners.clear();
	if (may_be_flush) {
		collect_flush_corners(geometry, face);
	}
	if (!may_be_flush || !_flush_corners.empty() || !clip_simple(geometry, face)) {
		clip_any(geometry, face, normal);
	}
}

void Clipper::clip_any(const Geometry &geometry, const GeometryFace &face, glm::dvec3 normal) {
	_chains.clear();
	_chain_points.clear();
	_chain_origins.clear();
	_whole_holes.clear();
	for (uint32_t i = 0; i < face.loop_count; ++i) {
		collect_chains(geometry, face.first_loop + i, i == 0);
	}
	pair_chains();
	emit_pieces(geometry, face, normal);
}

// An outline that comes in once, as convex ones do, is one piece: from where it comes in to where it goes out. False: this is another.
bool Clipper::clip_simple(const Geometry &geometry, const GeometryFace &face) {
	const uint32_t first = geometry.first_point(face.first_loop), count = geometry.loop_ends[face.first_loop] - first;
	const auto at = [&](uint32_t i) { return first + (i < count ? i : i - count); };
	const auto is_in = [&](uint32_t i) { return _distances[at(i)] > 0.0; };
	uint32_t enter = 0, inside = 0;
	if (face.loop_count != 1 || !comes_in_once(std::span(_distances).subspan(first, count), enter, inside)) {
		return false;
	}
	CornerOrigin enter_origin, leave_origin;
	const glm::dvec3 enter_point = cut_point(geometry, at(enter), at(enter + 1), enter_origin);
	const glm::dvec3 leave_point = cut_point(geometry, at(enter + inside), at(enter + inside + 1), leave_origin);
	// Place 0 is where the outline comes in, the last one where it goes out. It begins with the first edge, or with the cut in its place.
	const uint32_t places = inside + 2;
	const uint32_t start = is_in(0) ? count - enter : is_in(1) ? 0 : places - 1;
	_outline.resize(places);
	_outline_origins.resize(_builder.keeps_origins() ? places : 0);
	for (uint32_t i = 0; i < places; ++i) {
		const uint32_t place = start + i < places ? start + i : start + i - places;
		const bool is_enter = place == 0, is_leave = place + 1 == places;
		const uint32_t corner = at(enter + place);
		const glm::dvec3 *point = is_enter ? &enter_point : is_leave ? &leave_point : &geometry.points[corner];
		_outline[i] = *point;
		if (_builder.keeps_origins()) {
			_outline_origins[i] = is_enter ? enter_origin : is_leave ? leave_origin : CornerOrigin{ corner };
		}
	}
	_cuts.push_back({ leave_point, enter_point });
	const glm::dvec3 area = area_vector(geometry.outline(face)); // its direction is enough
	if (glm::dot(area_vector(_outline), area) > 0.0 && _builder.add_loop(_outline, _outline_origins)) {
		_builder.end_face(face.tag, face.material);
	}
	return true;
}

// Always from the point that stays to the other one, so that both faces at an edge get the same bits.
glm::dvec3 Clipper::cut_point(const Geometry &geometry, uint32_t a, uint32_t b, CornerOrigin &origin) const {
	const uint32_t in = _distances[a] > 0.0 ? a : b;
	const uint32_t out = in == a ? b : a;
	if (_distances[out] == 0.0) {
		origin = { out };
		return geometry.points[out];
	}
	const double share = _distances[in] / (_distances[in] - _distances[out]);
	origin = { in, out, share };
	return geometry.points[in] + (geometry.points[out] - geometry.points[in]) * share;
}

void Clipper::add_chain_point(glm::dvec3 point, CornerOrigin origin) {
	_chain_points.push_back(point);
	if (_builder.keeps_origins()) {
		_chain_origins.push_back(origin);
	}
}

// In the texture the cut runs along the other coordinate.
double Clipper::place_on_cut(glm::dvec3 point, const CornerOrigin &origin) const {
	if (_uvs == nullptr) {
		return glm::dot(_along, point);
	}
	const double from = _uvs[origin.a][1 - _uv_axis];
	return origin.b == CornerOrigin::none ? from : from + (_uvs[origin.b][1 - _uv_axis] - from) * origin.share;
}

void Clipper::collect_chains(const Geometry &geometry, uint32_t loop, bool is_outline) {
	const uint32_t first = geometry.first_point(loop);
	const uint32_t count = geometry.loop_ends[loop] - first;
	const auto at = [&](uint32_t i) { return first + i % count; };
	const auto is_in = [&](uint32_t i) { return _distances[at(i)] > 0.0; };
	uint32_t start = 0;
	while (start < count && (is_in(start) || !is_in(start + 1))) {
		++start;
	}
	if (start == count) { // never comes in
		if (is_in(0)) {
			_whole_holes.push_back(loop);
		}
		return;
	}
	for (uint32_t i = start; i < start + count; ++i) {
		if (is_in(i) == is_in(i + 1)) {
			if (is_in(i)) {
				add_chain_point(geometry.points[at(i + 1)], { at(i + 1) });
			}
		} else {
			CornerOrigin origin;
			const glm::dvec3 point = cut_point(geometry, at(i), at(i + 1), origin);
			if (is_in(i + 1)) {
				_chains.push_back({ .first = uint32_t(_chain_points.size()), .enter = place_on_cut(point, origin) });
				add_chain_point(point, origin);
				add_chain_point(geometry.points[at(i + 1)], { at(i + 1) });
			} else {
				add_chain_point(point, origin);
				_chains.back().leave = place_on_cut(point, origin);
				_chains.back().end = uint32_t(_chain_points.size());
			}
		}
		const bool begins_first_edge = is_outline && i % count == 0 && (is_in(i) || is_in(i + 1));
		if (begins_first_edge) { // the piece of the first edge ends at the point added last
			_chains.back().has_first_edge = true;
			_chains.back().first_edge = uint32_t(_chain_points.size()) - 2;
		}
	}
}

// Along the cut, outlines come in and go out in turns; between the two lies the inside of the polygon.
void Clipper::pair_chains() {
	_crossings.clear();
	for (uint32_t i = 0; i < _chains.size(); ++i) {
		_crossings.push_back({ _chains[i].enter, i, true });
		_crossings.push_back({ _chains[i].leave, i, false });
	}
	std::ranges::stable_sort(_crossings, {}, &Crossing::at);
	for (size_t i = 0; i + 1 < _crossings.size(); i += 2) {
		if (_crossings[i].is_enter == _crossings[i + 1].is_enter) { // only where several lie in one place, or in a broken outline
			const auto other = std::find_if(_crossings.begin() + std::ptrdiff_t(i) + 1, _crossings.end(),
					[&](const Crossing &c) { return c.is_enter != _crossings[i].is_enter; });
			std::swap(_crossings[i + 1], *other);
		}
		const auto [enter, leave] = _crossings[i].is_enter ? std::pair(i, i + 1) : std::pair(i + 1, i);
		_chains[_crossings[leave].chain].next = _crossings[enter].chain;
	}
}

void Clipper::emit_pieces(const Geometry &geometry, const GeometryFace &face, glm::dvec3 normal) {
	if (_chains.empty()) { // touched by the plane, not cut
		_builder.add_face(geometry, face);
		return;
	}
	for (uint32_t i = 0; i < _chains.size(); ++i) {
		if (_chains[i].is_used) {
			continue;
		}
		emit_outline(i);
		if (glm::dot(area_vector(_outline), normal) > 0.0 && _builder.add_loop(_outline, _outline_origins)) {
			add_holes(geometry, _outline, normal);
			_builder.end_face(face.tag, face.material);
		}
	}
}

void Clipper::emit_outline(uint32_t chain) {
	_order.clear();
	for (uint32_t at = chain; !_chains[at].is_used; at = _chains[at].next) {
		_chains[at].is_used = true;
		_order.push_back(at);
	}
	_outline.clear();
	_outline_origins.clear();
	size_t start = 0, last_cut = 0;
	bool has_start = false;
	for (size_t i = 0; i < _order.size(); ++i) {
		const Chain &piece = _chains[_order[i]];
		const Chain &following = _chains[_order[(i + 1) % _order.size()]];
		if (piece.has_first_edge) {
			start = _outline.size() + (piece.first_edge - piece.first);
			has_start = true;
		}
		_outline.insert(_outline.end(), _chain_points.begin() + piece.first, _chain_points.begin() + piece.end);
		if (!_chain_origins.empty()) {
			_outline_origins.insert(_outline_origins.end(), _chain_origins.begin() + piece.first, _chain_origins.begin() + piece.end);
		}
		last_cut = _outline.size() - 1;
		add_cut(piece, following);
	}
	const std::ptrdiff_t first = std::ptrdiff_t(has_start ? start : last_cut);
	std::rotate(_outline.begin(), _outline.begin() + first, _outline.end());
	if (!_outline_origins.empty()) {
		std::rotate(_outline_origins.begin(), _outline_origins.begin() + first, _outline_origins.end());
	}
}

} // namespace pcg::cga
