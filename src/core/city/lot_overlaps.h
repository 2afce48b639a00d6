#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/overlay.h"

// Lots that lie on one another: drawn or measured so, or moved there by hand.
namespace pcg {

struct OutlineOverlap {
	uint32_t a = 0, b = 0; // indices; a < b
	double area = 0.0; // square metres that they share
};

// All pairs that share more than `tolerance` square metres, in order of their indices. Outlines in plan, counter-clockwise, in metres.
// With `is_moved` (one for each outline) only pairs of which at least one has moved are looked at.
std::vector<OutlineOverlap> find_overlaps(std::span<const Loop2> outlines, const std::vector<bool> &is_moved = {}, double tolerance = 1.0);

} // namespace pcg
