#pragma once

#include "core/cga/geometry.h"

// Texture coordinates (set 0) of the built-in bodies, which fill the unit cube (CGA reference: op_primitive).
namespace pcg::cga {

// Each face of four corners has the picture once, its first edge below.
const Geometry *with_face_uvs(const Geometry *geometry, Arena &arena);
// u around the upright axis and v upwards; faces that look up or down have the picture as seen from above, flat bodies as seen from their front.
const Geometry *with_round_uvs(const Geometry *geometry, uint32_t sides, Arena &arena);

// A block's coordinates when it is cut along an axis: from share `a` to share `b` of its extent. New ends have none.
const CornerData *cut_block_corners(const Geometry &block, int axis, double a, double b, Arena &arena);

} // namespace pcg::cga
