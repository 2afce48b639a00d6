#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/geometry/material.h"

// Where setupProjection() lays a picture in space; projectUV() takes it from there (CGA reference: op_setupProjection, section 7.4).
namespace pcg::cga {

// (u, v) of a point of the derivation's coordinates, in which a shape may move or be cut while the picture stays.
struct Projection {
	glm::dvec3 u{ 0.0 }, v{ 0.0 };
	double u0 = 0.0, v0 = 0.0;

	glm::dvec2 at(glm::dvec3 point) const { return { glm::dot(u, point) + u0, glm::dot(v, point) + v0 }; }
};

// By texture coordinate set; nullptr: not set up. In the arena, shared until a shape changes one.
struct Projections {
	const Projection *sets[uv_set_count] = {};
};

} // namespace pcg::cga
