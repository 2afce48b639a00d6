#pragma once

#include "core/cga/arena.h"
#include "core/cga/geometry.h"

// What closes the cuts of a box has its place among the faces and its first edge as on any body (core/cga/clip.h), although a cut of a box only
// scales it.
namespace pcg::cga {

// The parts of one box between planes across one of its axes. Parts that are cut at the same ends share their faces.
class BlockEnds {
public:
	// `is_low_first`: which end is cut first where both are. The box itself if nothing changes, or if it is a built-in body or no box but a rectangle:
	// parts of those stay copies of the whole.
	const Geometry *cut(const Geometry &block, int axis, bool is_low_cut, bool is_high_cut, bool is_low_first, Arena &arena);

private:
	struct Order;
	const Geometry *_parts[4] = {};
};

} // namespace pcg::cga
