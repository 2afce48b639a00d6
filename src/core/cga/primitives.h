#pragma once

#include <cstdint>

#include "core/cga/shape.h"

// Geometry of unit size and how it is fitted to a scope (CGA reference: op_i, op_primitive; sections 5.1, 5.2).
namespace pcg::cga {

const Geometry *make_cube(Arena &arena); // from 0 to 1
const Geometry *make_quad(int normal_axis, Arena &arena); // from 0 to 1, at 0 on its normal's axis
// Radius 0.5 around (0.5, .., 0.5); height 1 from 0. 3 to 1000 sides.
const Geometry *make_disk(uint32_t sides, Arena &arena);
const Geometry *make_cylinder(uint32_t sides, Arena &arena);
const Geometry *make_cone(uint32_t sides, Arena &arena);
const Geometry *make_sphere(uint32_t sides, uint32_t divisions, Arena &arena);

// Puts geometry of any size into the scope box. Scope sizes that are 0 are chosen: all three: as large and where the geometry is; two: scaled like
// the third; one: scaled by the mean of the other two factors.
void fit_to_scope(Shape &shape, const Geometry *geometry);

} // namespace pcg::cga
