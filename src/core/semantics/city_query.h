#pragma once

#include <glm/vec3.hpp>

#include "core/semantics/city_model.h"

// Questions about the shapes in a CityModel. All look at the ground plan (x and z); heights are ignored.
namespace pcg {

// Inside or on the outline. A zone without an area contains nothing.
bool contains(const Zone &zone, glm::vec3 point);
// `point` itself if the zone contains it, else the nearest point of the outline. `point` if the zone has no polygon.
glm::vec3 nearest_point(const Zone &zone, glm::vec3 point);
// Centre of area, at the mean height of the corners; for outlines without area the mean of the corners.
glm::vec3 centroid(const Zone &zone);
// Square metres of the ground plan, never negative.
double area(const Zone &zone);

} // namespace pcg
