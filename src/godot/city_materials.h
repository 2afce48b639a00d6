#pragma once

#include <map>
#include <string>
#include <vector>

#include <godot_cpp/classes/array_mesh.hpp>
#include <godot_cpp/classes/base_material3d.hpp>
#include <godot_cpp/classes/material.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/standard_material3d.hpp>
#include <godot_cpp/classes/texture2d.hpp>

#include "core/geometry/mesh.h"

namespace pcg {

// The engine's materials for those of a city. Colours lie on the vertices, so materials that differ by their colour only are one here; each picture is
// loaded once. What the engine's standard material cannot show is listed in docs/cga-differences.md.
class CityMaterials {
public:
	struct Entry {
		godot::Ref<godot::Material> material;
		bool has_normal_map = false; // the mesh needs tangents
	};

	// The same material for the same look. Lives as long as this.
	const Entry &of(const Material &material);

	// The engine's front faces run clockwise, the core's counter-clockwise; v runs down in the engine. Surfaces of one material are one. Null if there
	// is nothing to draw. White: whoever shows the mesh brings the colour.
	godot::Ref<godot::ArrayMesh> to_godot(const Mesh &mesh, const std::vector<Material> &materials, bool is_white = false);

private:
	godot::Ref<godot::StandardMaterial3D> make(const Material &material);
	void set_pictures(const godot::Ref<godot::StandardMaterial3D> &target, const Material &material);
	bool set_picture(const godot::Ref<godot::StandardMaterial3D> &target, godot::BaseMaterial3D::TextureParam slot, const TextureMap *map);
	godot::Ref<godot::Texture2D> picture(const std::string &file);
	godot::Ref<godot::Texture2D> clear_picture(const TextureMap *color, const TextureMap &opacity);

	std::map<std::string, Entry> _entries; // by what the material shows beside its colour
	std::map<std::string, godot::Ref<godot::Texture2D>> _pictures; // by file, or by the two files of one; null: it cannot be loaded
};

} // namespace pcg
