#pragma once

#include "core/geometry/polygon.h"

// How far it is to the sides of loops in plan, metres.
namespace pcg {

// To the side from `a` to `b`.
double distance_to(glm::dvec2 a, glm::dvec2 b, glm::dvec2 point);

// From a point in a direction (unit) to the first side; infinite if there is none.
double way_to(const Loop2 &loop, glm::dvec2 from, glm::dvec2 direction);

} // namespace pcg
