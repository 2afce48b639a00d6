#pragma once

#include <cstdint>

#include <godot_cpp/classes/node3d.hpp>

#include "core/geometry/mesh.h"

namespace pcg {

// Whether bodies of a game's physics stand on a city and bump into it, and on which of the engine's 32 layers it lies for them.
struct CollisionSettings {
	bool is_used = false;
	uint32_t layer = 1;
	uint32_t mask = 1;
};

// A static body whose shape is every face of the mesh, seen from the side that the face looks to; null if there is none.
godot::Node3D *make_static_body(const Mesh &mesh, const CollisionSettings &settings);

} // namespace pcg
