#pragma once

#include <vector>

#include <godot_cpp/classes/node3d.hpp>

#include "core/city/footprint_layout.h"

namespace pcg {

// Lots or blocks that a user drew as children of `city`: Path3D, seen from above, and Polygon2D, whose x is east and y south, in metres. Their metadata
// may say `lot_type` and `height`; what is drawn as their children are their holes.
std::vector<Footprint> drawn_footprints(const godot::Node3D *city);

} // namespace pcg
