#pragma once

#include <cstdint>

#include "core/cga/shape.h"

// Geometry of unit size and how it is fitted to a scope (CGA reference: op_i, op_primitive; sections 5.1, 5.2).
namespace pcg::cga {

enum class PrimitiveKind : uint8_t { Quad, Disk, Cube, PlainCube, Sphere, Cylinder, Cone };

// The body that all others are scaled from, with texture coordinates in set 0 (PlainCube has none):
// Quad, 0 to 1, at 0 on the axis that it looks along: a = that axis.
// Disk, radius 0.5 around 0.5, at 0 on the axis that it looks along: a = sides, b = that axis.
// Cube, 0 to 1. Cylinder, Cone: radius 0.5 around 0.5, height 1: a = sides. Sphere, around 0.5: a = sides, b = divisions.
// 3 to 1000 sides; faces of a cube: bottom, top, front, right, back, left; of a cylinder: bottom, sides from the one that looks to +z counter-clockwise, top;
// of a sphere from below ring by ring.
const Geometry *make_primitive(PrimitiveKind kind, uint32_t a, uint32_t b, Arena &arena);

// Puts geometry of any size into the scope box. Scope sizes that are 0 are chosen: all three: as large and where the geometry is; two: scaled like
// the third; one: scaled by the mean of the other two factors.
void fit_to_scope(Shape &shape, const Geometry *geometry);
// Gives the scope that size around the middle of its floor, and the geometry with it; sizes of 0 flatten it.
void place_on_floor(Shape &shape, const Geometry *geometry, glm::dvec3 size);
// The same in a plane through the scope's origin, around the scope's middle there.
void place_in_plane(Shape &shape, const Geometry *geometry, glm::dvec3 size, int normal_axis);

} // namespace pcg::cga
