#include "core/cga/clip.h"

#include <algorithm>

#include <glm/geometric.hpp>

// Edges that lie in the plane: the face above one and the face beyond it share its ends, so that the cut bends there although it runs straight on.
namespace pcg::cga {

void Clipper::collect_flush_corners(const Geometry &geometry, const GeometryFace &face) {
	for (uint32_t loop = face.first_loop; loop < face.first_loop + face.loop_count; ++loop) {
		const uint32_t first = geometry.first_point(loop), end = geometry.loop_ends[loop];
		for (uint32_t i = first; i < end; ++i) {
			const uint32_t next = i + 1 < end ? i + 1 : first;
			if (_distances[i] == 0.0 && _distances[next] == 0.0 && glm::dot(_along, geometry.points[next] - geometry.points[i]) > 0.0) {
				const bool is_kept = !_is_square || has_neighbor(geometry, geometry.points[i], geometry.points[next]);
				for (const uint32_t corner : { i, next }) {
					_flush_corners.push_back({ glm::dot(_along, geometry.points[corner]), geometry.points[corner], corner, is_kept });
				}
			}
		}
	}
	unite_flush_corners();
	_has_flush_edges |= !_flush_corners.empty();
}

// Those in one place are one, which is kept if one of them is.
void Clipper::unite_flush_corners() {
	std::ranges::stable_sort(_flush_corners, {}, &FlushCorner::at);
	size_t count = 0;
	for (const FlushCorner &flush : _flush_corners) {
		if (count > 0 && flush.at - _flush_corners[count - 1].at <= _margin) {
			_flush_corners[count - 1].is_kept |= flush.is_kept;
		} else {
			_flush_corners[count++] = flush;
		}
	}
	_flush_corners.erase(_flush_corners.begin() + std::ptrdiff_t(count), _flush_corners.end());
}

// Whether a face that stays has the edge from the other side.
bool Clipper::has_neighbor(const Geometry &geometry, glm::dvec3 from, glm::dvec3 to) const {
	for (uint32_t f = 0; f < geometry.face_count; ++f) {
		const GeometryFace &face = geometry.faces[f];
		bool has_edge = false;
		for (uint32_t loop = face.first_loop; loop < face.first_loop + face.loop_count; ++loop) {
			const auto points = geometry.loop(loop);
			for (size_t i = 0; i < points.size(); ++i) {
				has_edge |= points[i] == to && points[i + 1 < points.size() ? i + 1 : 0] == from;
			}
		}
		if (has_edge && sides_of(geometry.first_point(face.first_loop), geometry.face_point_count(face)).most > 0.0) {
			return true;
		}
	}
	return false;
}

// From where one chain goes out to where another comes in. Faces square to the plane, such as a lot or the floor of a body, keep a straight side there,
// for rule files count on rectangles that stay rectangles, unless a face that stays meets them at a part of it, as a roof above an eave does. Pieces of
// a straight side are numbered 1 but for the first, see cancel_opposite_cuts().
void Clipper::add_cut(const Chain &from, const Chain &to) {
	glm::dvec3 last = _chain_points[from.end - 1];
	uint32_t number = 0;
	for (const FlushCorner &flush : _flush_corners) {
		if (flush.at > from.leave + _margin && flush.at < to.enter - _margin) {
			if (flush.is_kept) {
				_outline.push_back(flush.point);
			}
			if (flush.is_kept && !_chain_origins.empty()) {
				_outline_origins.push_back({ flush.corner });
			}
			_cuts.push_back({ last, flush.point, number });
			number = flush.is_kept ? 0 : 1;
			last = flush.point;
		}
	}
	_cuts.push_back({ last, _chain_points[to.first], number });
}

} // namespace pcg::cga
