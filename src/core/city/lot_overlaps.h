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

// Square metres.
double shared_area(const Loops2 &a, const Loops2 &b);

// Whether most of an outline lies in a hole of a larger polygon.
bool stands_in_hole(const Loop2 &inner, const Loops2 &outer);

// All pairs that share more than `tolerance` square metres, in order of their indices. Polygons in plan, in metres.
// With `is_moved` (one for each polygon) only pairs of which at least one has moved are looked at.
std::vector<OutlineOverlap> find_overlaps(std::span<const Loops2> polygons, const std::vector<bool> &is_moved = {}, double tolerance = 1.0);

} // namespace pcg
