#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/polygon.h"

// Polygons laid over each other: union, difference, intersection. Points of the input that lie in the result keep their coordinates to the last bit.
namespace pcg {

enum class OverlayKind : uint8_t { Union, Difference, Intersection };

// What lies inside of `first` or `second`, of `first` only, or of both, as polygons that do not cross themselves, largest first. Loops may run in
// any number of polygons: inside is where they wind around a point more than zero times, so those of a polygon that overlaps itself count as one
// area. Points closer than 1e-7 of the extent are one. Cost grows with the square of the edges.
Polygons2 overlay(const Loops2 &first, const Loops2 &second, OverlayKind kind);

// Sorts loops to polygons: each clockwise one goes to the smallest counter-clockwise one around it. Order is kept.
Polygons2 group_loops(const Loops2 &loops);

// Leaves out points within `tolerance` metres of the line between their neighbours.
Loop2 without_straight_points(const Loop2 &loop, double tolerance);

} // namespace pcg
