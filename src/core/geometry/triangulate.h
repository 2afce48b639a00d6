#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace pcg {

// Appends triangles (indices into `points`, counter-clockwise) that cover the polygon: loop i owns points [loop_ends[i - 1], loop_ends[i]), the
// first is the outline, the others are holes; which way they run does not matter. Never makes a point. Ear cutting: exact for simple
// polygons; for self-intersecting ones it still ends, and covers about what is meant. Cost grows with the square of the points that are
// not part of a convex outline.
void triangulate(std::span<const glm::dvec2> points, std::span<const uint32_t> loop_ends, std::vector<uint32_t> &triangles);

} // namespace pcg
