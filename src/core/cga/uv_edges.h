#pragma once

#include <string_view>

#include "core/cga/geometry.h"

// Edges of faces as their texture coordinates name them: uv.left, uv.uMin (CGA reference: op_setback).
namespace pcg::cga {

enum class UvSide : uint8_t { None, Left, Right, Bottom, Top, UMin, UMax, VMin, VMax };

// None for any other word.
UvSide uv_side_of(std::string_view word);

// The edge between two corners of the face. Left to Top: where its outward normal points on the texture; the others: both ends lie at the
// geometry's least or greatest coordinate. False without coordinates.
bool matches(UvSide side, const Geometry &geometry, const GeometryFace &face, uint32_t from, uint32_t to, size_t set);

} // namespace pcg::cga
