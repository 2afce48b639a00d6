#include "godot/convert_asset.h"

#include <cmath>

#include <glm/geometric.hpp>

#include <godot_cpp/classes/base_material3d.hpp>
#include <godot_cpp/classes/mesh.hpp>
#include <godot_cpp/classes/texture2d.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>
#include <godot_cpp/variant/packed_vector2_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>

#include "core/geometry/polygon.h"
#include "godot/convert.h"

using namespace godot;

namespace pcg {

namespace {

void add_picture(pcg::Material &target, TextureUse use, const Ref<BaseMaterial3D> &source, BaseMaterial3D::TextureParam slot) {
	const Ref<Texture2D> texture = source->get_texture(slot);
	if (texture.is_valid() && !texture->get_path().is_empty()) {
		target.maps.push_back({ .use = use, .file = from_godot(texture->get_path()) });
	}
}

pcg::Material material_of(const Ref<godot::Material> &material) {
	pcg::Material result;
	const Ref<BaseMaterial3D> source = material;
	if (source.is_null()) {
		return result;
	}
	result.name = from_godot(source->get_name());
	result.color = from_godot(source->get_albedo());
	result.color.a = source->get_transparency() == BaseMaterial3D::TRANSPARENCY_ALPHA ? result.color.a : 1.0f;
	result.roughness = float(source->get_roughness());
	result.metallic = float(source->get_metallic());
	result.is_double_sided = source->get_cull_mode() == BaseMaterial3D::CULL_DISABLED;
	if (source->get_feature(BaseMaterial3D::FEATURE_EMISSION)) {
		result.emissive = glm::vec3(from_godot(source->get_emission()));
	}
	add_picture(result, TextureUse::Color, source, BaseMaterial3D::TEXTURE_ALBEDO); // in order of their use
	add_picture(result, TextureUse::Normal, source, BaseMaterial3D::TEXTURE_NORMAL);
	add_picture(result, TextureUse::Emissive, source, BaseMaterial3D::TEXTURE_EMISSION);
	add_picture(result, TextureUse::Occlusion, source, BaseMaterial3D::TEXTURE_AMBIENT_OCCLUSION);
	add_picture(result, TextureUse::Roughness, source, BaseMaterial3D::TEXTURE_ROUGHNESS);
	add_picture(result, TextureUse::Metallic, source, BaseMaterial3D::TEXTURE_METALLIC);
	return result;
}

// One surface's corners, and what they carry.
struct Surface {
	PackedVector3Array positions, normals;
	PackedVector2Array uvs;
	Transform3D frame;
	Basis turn; // of normals

	void add_corner(int32_t i, pcg::Mesh &mesh) const {
		const size_t corner = mesh.positions.size();
		mesh.positions.push_back(from_godot(frame.xform(positions[i])));
		if (i < uvs.size()) {
			mesh.uvs[0].resize(corner, glm::vec2(NAN));
			mesh.uvs[0].push_back({ uvs[i].x, 1.0f - uvs[i].y });
		}
		if (i < normals.size()) {
			mesh.normals.resize(corner, glm::vec3(NAN));
			mesh.normals.push_back(from_godot(turn.xform(normals[i]).normalized()));
		}
	}
	glm::dvec3 point(int32_t i) const { return glm::dvec3(from_godot(frame.xform(positions[i]))); }
};

// The engine's front faces run clockwise.
void add_triangle(const Surface &surface, int32_t a, int32_t b, int32_t c, uint32_t material, pcg::Mesh &mesh) {
	const int64_t count = surface.positions.size();
	if (a < 0 || b < 0 || c < 0 || a >= count || b >= count || c >= count) {
		return;
	}
	const glm::dvec3 points[3] = { surface.point(a), surface.point(c), surface.point(b) };
	const glm::dvec3 normal = area_vector(points);
	if (glm::length(normal) > 0.0) {
		for (const int32_t corner : { a, c, b }) {
			surface.add_corner(corner, mesh);
		}
		mesh.loop_ends.push_back(uint32_t(mesh.positions.size()));
		mesh.faces.push_back({ uint32_t(mesh.loop_ends.size()) - 1, 1, material, glm::vec3(glm::normalize(normal)) });
	}
}

} // namespace

void add_surface(const Ref<ArrayMesh> &mesh, int index, const Ref<godot::Material> &material, const Transform3D &frame, Asset &asset) {
	if (mesh->surface_get_primitive_type(index) != godot::Mesh::PRIMITIVE_TRIANGLES) {
		return;
	}
	const Array arrays = mesh->surface_get_arrays(index);
	Surface surface{ arrays[godot::Mesh::ARRAY_VERTEX], arrays[godot::Mesh::ARRAY_NORMAL], arrays[godot::Mesh::ARRAY_TEX_UV], frame, frame.basis.inverse().transposed() };
	PackedInt32Array indices = arrays[godot::Mesh::ARRAY_INDEX];
	for (int64_t i = 0; arrays[godot::Mesh::ARRAY_INDEX].get_type() == Variant::NIL && i < surface.positions.size(); ++i) {
		indices.push_back(int32_t(i));
	}
	const bool is_mirrored = frame.basis.determinant() < 0.0f;
	for (int64_t i = 0; i + 2 < indices.size(); i += 3) {
		add_triangle(surface, indices[i], indices[i + (is_mirrored ? 2 : 1)], indices[i + (is_mirrored ? 1 : 2)], uint32_t(asset.materials.size()), asset.mesh);
	}
	asset.materials.push_back(material_of(material));
}

} // namespace pcg
