#include "core/cga/block_ends.h"

#include <algorithm>

namespace pcg::cga {

namespace {

constexpr uint32_t box_faces = 6;

bool is_at_end(const Geometry &block, uint32_t face, int axis, bool is_high) {
	const double middle = 0.5 * (block.low[axis] + block.high[axis]);
	return std::ranges::all_of(block.outline(block.faces[face]), [&](glm::dvec3 point) { return (point[axis] > middle) == is_high; });
}

bool has_corner(const Geometry &block, uint32_t face, glm::dvec3 point) {
	return std::ranges::find(block.outline(block.faces[face]), point) != block.outline(block.faces[face]).end();
}

} // namespace

// The faces of the part, as numbers of the box's faces, and the corner with which each begins.
struct BlockEnds::Order {
	uint32_t faces[box_faces] = { 0, 1, 2, 3, 4, 5 };
	uint32_t starts[box_faces] = {};
	bool is_changed = false;

	// The face at the end is cut away. What closes the cut begins with the edge that it shares with the first face that is cut; it comes last, or
	// first where the first face was cut away.
	void cut_end(const Geometry &block, int axis, bool is_high) {
		uint32_t *const end = std::ranges::find_if(faces, [&](uint32_t face) { return is_at_end(block, face, axis, is_high); });
		const uint32_t *const first_cut = std::ranges::find_if(
				faces, [&](uint32_t face) { return !is_at_end(block, face, axis, false) && !is_at_end(block, face, axis, true); });
		if (end == std::end(faces) || first_cut == std::end(faces)) {
			return;
		}
		const auto corners = block.outline(block.faces[*end]);
		for (uint32_t i = 0; i < corners.size(); ++i) {
			if (has_corner(block, *first_cut, corners[i]) && has_corner(block, *first_cut, corners[(i + 1) % corners.size()])) {
				is_changed |= i != starts[*end];
				starts[*end] = i;
				break;
			}
		}
		if (end != faces) {
			is_changed |= end + 1 != std::end(faces);
			std::rotate(end, end + 1, std::end(faces));
		}
	}

	const Geometry *apply(const Geometry &block, Arena &arena) const {
		GeometryBuilder builder;
		builder.begin(block);
		for (const uint32_t number : faces) {
			const GeometryFace &face = block.faces[number];
			const uint32_t first = block.first_point(face.first_loop), count = block.face_point_count(face);
			for (uint32_t i = 0; i < count; ++i) {
				const uint32_t corner = first + (starts[number] + i) % count;
				builder.add_corner(block.points[corner], corner);
			}
			builder.end_loop();
			builder.end_face(face.tag, face.material);
		}
		return builder.finish(arena, block.is_closed);
	}
};

const Geometry *BlockEnds::cut(const Geometry &block, int axis, bool is_low_cut, bool is_high_cut, bool is_low_first, Arena &arena) {
	if (block.face_count != box_faces || block.inserted != nullptr) {
		return &block;
	}
	const Geometry *&part = _parts[(is_low_cut ? 1 : 0) + (is_high_cut ? 2 : 0)];
	if (part == nullptr) {
		Order order;
		for (const bool is_high : { !is_low_first, is_low_first }) {
			if (is_high ? is_high_cut : is_low_cut) {
				order.cut_end(block, axis, is_high);
			}
		}
		part = order.is_changed ? order.apply(block, arena) : &block;
	}
	return part;
}

} // namespace pcg::cga
