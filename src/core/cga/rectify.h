#pragma once

#include "core/cga/geometry.h"

namespace pcg::cga {

// Adds the faces with edges that are less than `angle` degrees off an axis of their coordinates turned parallel to it, as seen along the axis that
// most of the area faces (CGA reference: op_rectify). Edges that hang together take their mean line; corners that were one stay one.
void rectify(const Geometry &geometry, double angle, GeometryBuilder &builder);

} // namespace pcg::cga
