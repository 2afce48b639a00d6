#pragma once

#include <span>

#include <glm/vec2.hpp>

namespace pcg {

// Direction, unit, of the longer side of the smallest rectangle around the points. Of several that are equally small, and of the two directions
// of each, the one nearest to `preferred`; `preferred` itself where all points are equal.
glm::dvec2 longer_side_of_least_rectangle(std::span<const glm::dvec2> points, glm::dvec2 preferred);

} // namespace pcg
