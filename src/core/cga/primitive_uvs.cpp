#include "core/cga/primitive_uvs.h"

namespace pcg::cga {

const CornerData *cut_block_corners(const Geometry &block, int axis, double a, double b, Arena &arena) {
	const double middle = 0.5 * (block.low[axis] + block.high[axis]);
	const auto is_high = [&](uint32_t corner) { return block.points[corner][axis] > middle; };
	CornerData *result = arena.make(*block.corners);
	for (size_t set = 0; set < block.corners->set_end; ++set) {
		const glm::dvec2 *source = block.corners->uvs[set];
		if (source == nullptr) {
			continue;
		}
		glm::dvec2 *uvs = arena.allocate<glm::dvec2>(block.point_count);
		for (uint32_t i = 0; i < block.point_count; ++i) { // four corners for each face
			const uint32_t next = i / 4 * 4 + (i + 1) % 4, previous = i / 4 * 4 + (i + 3) % 4;
			const uint32_t other = is_high(next) != is_high(i) ? next : previous;
			const bool is_end = is_high(other) == is_high(i);
			const double share = is_high(i) ? 1.0 - b : a; // of the way to the other end
			uvs[i] = is_end ? (share > 0.0 ? no_uv() : source[i]) : source[i] + (source[other] - source[i]) * share;
		}
		result->put(set, uvs);
	}
	return result;
}

} // namespace pcg::cga
