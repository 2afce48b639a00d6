#pragma once

#include <utility>

#include "core/cga/shape.h"

// Sizes of a shape's geometry, in metres and degrees; 0 and false without geometry (CGA reference: func_geometry).
namespace pcg::cga {

double surface_area(const Shape &shape);
double face_area(const Shape &shape, const GeometryFace &face);
double face_count(const Shape &shape); // edges and points are none
uint32_t vertex_count(const Geometry &geometry); // shared ones count once
double volume(const Shape &shape); // of closed surfaces, else 0
double boundary_length(const Shape &shape); // edges with one face
bool is_closed_surface(const Shape &shape); // at least one face, and every edge has two
bool is_concave(const Shape &shape); // any face
bool is_rectangular(const Shape &shape, double tolerance_deg); // every face has four right angles
bool is_planar(const Shape &shape, double tolerance_deg); // at every corner of every face the face turns in its plane
std::pair<double, double> vertical_extent(const Shape &shape); // lowest and highest, in the derivation's coordinates

// Of the face that is steepest to the ground; of several the first.
struct SlopeAngles {
	double slope = 0.0; // 0 to 90
	double azimuth = 0.0; // where it looks to, clockwise from north, in [0, 360); 0 of level faces
};
SlopeAngles steepest_slope(const Shape &shape);

} // namespace pcg::cga
