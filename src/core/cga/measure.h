#pragma once

#include "core/cga/shape.h"

// Sizes of a shape's geometry, in metres; 0 without geometry (CGA reference: func_geometry).
namespace pcg::cga {

double surface_area(const Shape &shape);
double face_area(const Shape &shape, const GeometryFace &face);
double volume(const Shape &shape); // of closed surfaces, else 0
double boundary_length(const Shape &shape); // outlines and holes of all faces
bool is_concave(const Shape &shape); // any face
bool is_rectangular(const Shape &shape, double tolerance_deg); // every face has four right angles
bool is_planar(const Shape &shape, double tolerance); // every face within `tolerance` metres of a plane

} // namespace pcg::cga
