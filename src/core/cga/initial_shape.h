#pragma once

#include "core/base/diagnostic.h"
#include "core/cga/derivation.h"
#include "core/cga/shape.h"

namespace pcg::cga {

// Coordinate systems and first shape of a derivation (CGA reference, sections 2.1 and 2.3). Repeated points are dropped. False, with an error: no
// face is left; self-intersecting outlines are only warned of.
bool make_initial_shape(const InitialShape &source, GeometryBuilder &builder, Arena &arena, Lot &lot, Shape &shape, Diagnostics &diagnostics);

} // namespace pcg::cga
