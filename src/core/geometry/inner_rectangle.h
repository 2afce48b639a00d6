#pragma once

#include "core/geometry/overlay.h"

// The largest rectangle in a polygon (CGA reference: op_innerRectangle).
namespace pcg {

// With sides along x and y, counter-clockwise from its least corner; of equal ones that nearest to the polygon's centre of gravity. Empty: the
// polygon has no inside. Cuts the polygon into trapezoids by its corners' x and searches each run of them, in which the area has one maximum.
Loop2 largest_rectangle(const Loops2 &polygon);

// The same in any direction of an edge; of each loop only edges longer than a quarter of its longest are tried.
Loop2 largest_rectangle_along_edges(const Loops2 &polygon);

// The loop from its side nearest to the middle of this edge on.
Loop2 begun_near(const Loop2 &loop, glm::dvec2 edge_from, glm::dvec2 edge_to);

} // namespace pcg
