#pragma once

#include "core/geometry/overlay.h"

// Concave polygons cut into convex ones along diagonals (CGA reference: op_convexify).
namespace pcg {

// The shortest diagonals that make an inner corner convex come first. With a `max_length` only shorter ones are cut, and parts may stay concave;
// a polygon whose hole cannot be reached by such a cut stays as it is. The part with the polygon's first edge is first and begins with it. Beyond
// 300 corners: triangles. Cost grows with the cube of the corners.
Polygons2 convex_parts(const Loops2 &polygon, double max_length);

} // namespace pcg
