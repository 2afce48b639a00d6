#pragma once

#include "core/cga/geometry.h"

// Texture coordinates of boxes and rectangles that are cut.
namespace pcg::cga {

// A block's coordinates when it is cut along an axis: from share `a` to share `b` of its extent. New ends have none.
const CornerData *cut_block_corners(const Geometry &block, int axis, double a, double b, Arena &arena);

} // namespace pcg::cga
