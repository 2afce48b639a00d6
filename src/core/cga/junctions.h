#pragma once

#include "core/cga/geometry.h"

// Places where the edge of one face meets the middle of another face's edge.
namespace pcg::cga {

// Inserts into every edge the vertices of other faces that lie on it, not farther than `distance`, so that neighbours share whole edges: of faces
// whose normals differ by less than `angle` degrees. The geometry itself if there are none.
const Geometry *with_junctions(const Geometry &geometry, double distance, double angle, GeometryBuilder &builder, Arena &arena);

} // namespace pcg::cga
