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
				for (const uint32_t corner : { i, next }) {
					_flush_corners.push_back({ glm::dot(_along, geometry.points[corner]), geometry.points[corner], corner });
				}
			}
		}
	}
	std::ranges::stable_sort(_flush_corners, {}, &FlushCorner::at);
	const auto doubles = std::ranges::unique(_flush_corners, [&](const FlushCorner &a, const FlushCorner &b) { return b.at - a.at <= _margin; });
	_flush_corners.erase(doubles.begin(), doubles.end());
	_has_flush_edges |= !_flush_corners.empty();
}

// From where one chain goes out to where another comes in. Faces square to the plane, such as the floor of a body or a lot, keep a straight side there:
// rule files count on rectangles that stay rectangles. Pieces of their cut are numbered 1 but for the first, see cancel_opposite_cuts().
void Clipper::add_cut(const Chain &from, const Chain &to) {
	glm::dvec3 last = _chain_points[from.end - 1];
	uint32_t number = 0;
	for (const FlushCorner &flush : _flush_corners) {
		if (flush.at > from.leave + _margin && flush.at < to.enter - _margin) {
			if (!_is_square) {
				_outline.push_back(flush.point);
			}
			if (!_is_square && !_chain_origins.empty()) {
				_outline_origins.push_back({ flush.corner });
			}
			_cuts.push_back({ last, flush.point, number });
			number = _is_square ? 1 : 0;
			last = flush.point;
		}
	}
	_cuts.push_back({ last, _chain_points[to.first], number });
}

} // namespace pcg::cga
