#include "core/cga/clip.h"

namespace pcg::cga {

// An edge without a face, as comp(e) makes them, keeps its end on this side. False: it is a face.
bool Clipper::clip_edge(const Geometry &geometry, const GeometryFace &face) {
	const uint32_t first = geometry.first_point(face.first_loop);
	if (face.loop_count != 1 || geometry.loop_ends[face.first_loop] - first != 2) {
		return false;
	}
	CornerOrigin origin;
	const glm::dvec3 cut = cut_point(geometry, first, first + 1, origin);
	for (uint32_t corner = first; corner < first + 2; ++corner) {
		const bool stays = _distances[corner] > 0.0;
		_builder.add_point(stays ? geometry.points[corner] : cut, stays ? CornerOrigin{ corner } : origin);
	}
	if (_builder.end_loop(2)) {
		_builder.end_face(face.tag, face.material);
	}
	return true;
}

} // namespace pcg::cga
