#pragma once

#include <godot_cpp/classes/array_mesh.hpp>
#include <godot_cpp/classes/material.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/variant/transform3d.hpp>

#include "core/ports/asset_provider.h"

// Models of the engine as assets of the core. On the main thread.
namespace pcg {

// Adds the triangles of a surface, and its material. After the last one complete_corners() is called.
void add_surface(const godot::Ref<godot::ArrayMesh> &mesh, int surface, const godot::Ref<godot::Material> &material, const godot::Transform3D &frame,
		Asset &asset);

} // namespace pcg
