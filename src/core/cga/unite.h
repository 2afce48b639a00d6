#pragma once

#include <span>

#include "core/cga/geometry.h"

// Bodies laid into each other (CGA reference: op_inline, unify).
namespace pcg::cga {

// Takes from each part what lies inside of another one, and of faces in one place all but the first; nullptr: nothing remains. Bodies that touch
// lose what is between them. Parts that enclose nothing are cut by those that do, flat ones in one plane by those before them. All parts have
// the same coordinates.
void unite(std::span<const Geometry *> parts, GeometryBuilder &builder, Arena &arena);

// How many times a face of one part is compared with a face of another one that may meet it, at most.
double unite_cost(std::span<const Geometry *const> parts);

// Whether unite() knows what to do with it: it encloses something, or is flat.
bool can_unite(const Geometry &part);

} // namespace pcg::cga
