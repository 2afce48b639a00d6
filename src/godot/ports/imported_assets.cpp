#include "godot/ports/imported_assets.h"

#include <godot_cpp/classes/array_mesh.hpp>
#include <godot_cpp/classes/file_access.hpp>
#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/mesh_instance3d.hpp>
#include <godot_cpp/classes/packed_scene.hpp>
#include <godot_cpp/classes/resource_loader.hpp>
#include <godot_cpp/classes/texture2d.hpp>

#include "godot/convert.h"
#include "godot/convert_asset.h"

using namespace godot;

namespace pcg {

namespace {

// The file itself is gone, but the engine has something that was made of it.
bool is_imported(const std::string &path) {
	const String name = to_godot(std::string_view(path));
	return !FileAccess::file_exists(name) && ResourceLoader::get_singleton()->exists(name);
}

// `node` and all below it; `frame` leads from its parent's coordinates to the model's.
void add_node(const Node *node, const Transform3D &frame, Asset &asset) {
	const Node3D *body = Object::cast_to<Node3D>(node);
	const Transform3D own = body != nullptr ? frame * body->get_transform() : frame;
	if (const MeshInstance3D *instance = Object::cast_to<MeshInstance3D>(node)) {
		const Ref<ArrayMesh> mesh = instance->get_mesh();
		for (int i = 0; mesh.is_valid() && i < mesh->get_surface_count(); ++i) {
			const Ref<godot::Material> replaced = instance->get_surface_override_material(i);
			add_surface(mesh, i, replaced.is_valid() ? replaced : mesh->surface_get_material(i), own, asset);
		}
	}
	for (int i = 0; i < node->get_child_count(); ++i) {
		add_node(node->get_child(i), own, asset);
	}
}

Asset read_model(const std::string &path) {
	Asset asset;
	const Ref<Resource> resource = ResourceLoader::get_singleton()->load(to_godot(std::string_view(path)));
	const Ref<ArrayMesh> mesh = resource;
	const Ref<PackedScene> scene = resource;
	for (int i = 0; mesh.is_valid() && i < mesh->get_surface_count(); ++i) {
		add_surface(mesh, i, mesh->surface_get_material(i), Transform3D(), asset);
	}
	if (scene.is_valid()) {
		if (Node *root = scene->instantiate()) {
			add_node(root, Transform3D(), asset);
			memdelete(root);
		}
	}
	complete_corners(asset.mesh);
	if (asset.mesh.is_empty()) {
		asset.problem = "the engine's import of it holds no triangles";
	}
	return asset;
}

} // namespace

std::optional<Asset> ImportedAssets::model(const std::string &path) const {
	std::optional<Asset> result;
	if (is_imported(path)) { // the main thread is waited for only where it is needed
		_main->run([&] { result = read_model(path); });
	}
	return result;
}

std::optional<ImageInfo> ImportedAssets::picture(const std::string &path) const {
	std::optional<ImageInfo> result;
	if (!is_imported(path)) {
		return result;
	}
	_main->run([&] {
		const Ref<Texture2D> texture = ResourceLoader::get_singleton()->load(to_godot(std::string_view(path)));
		if (texture.is_valid()) {
			const Ref<Image> image = texture->get_image();
			const bool has_alpha = image.is_valid() && image->detect_alpha() != Image::ALPHA_NONE;
			result = ImageInfo{ { uint32_t(texture->get_width()), uint32_t(texture->get_height()) }, has_alpha };
		}
	});
	return result;
}

} // namespace pcg
