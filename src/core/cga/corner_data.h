#pragma once

#include <span>

#include "core/cga/geometry.h"

// Brings texture coordinates and normals from a geometry to what an operation makes of it.
namespace pcg::cga {

// One entry for each of `points`; origins may be fewer, the rest has none. nullptr if nothing is carried. Normals are multiplied by `turn`.
const CornerData *carry_corner_data(const Geometry &source, std::span<const glm::dvec3> points, std::span<const CornerOrigin> origins,
		const glm::dmat3 &turn, Arena &arena);

// Weights of the corners of a face (outline and holes, in order) at a point of it: mean value coordinates (Hormann and Floater 2006), exact for
// everything that is linear over the face. They sum up to 1.
void mean_value_weights(const Geometry &geometry, const GeometryFace &face, glm::dvec3 point, std::vector<double> &weights);

} // namespace pcg::cga
