#include <godot_cpp/classes/mesh.hpp>
#include <godot_cpp/variant/packed_color_array.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>
#include <godot_cpp/variant/packed_vector2_array.hpp>

#include "godot/convert.h"

using namespace godot;

namespace pcg {

namespace {

struct Arrays {
	PackedVector3Array positions, normals;
	PackedColorArray colors;
	PackedInt32Array indices;

	void add(const MeshSurface &surface, const Color &color) {
		const int32_t first = int32_t(positions.size());
		positions.append_array(to_godot(std::span<const glm::vec3>(surface.positions)));
		normals.append_array(to_godot(std::span<const glm::vec3>(surface.normals)));
		const int64_t count = colors.size();
		colors.resize(positions.size());
		Color *out = colors.ptrw();
		for (int64_t i = count; i < positions.size(); ++i) {
			out[i] = color;
		}
		const int64_t index_count = indices.size();
		indices.resize(index_count + int64_t(surface.indices.size()));
		int32_t *index = indices.ptrw() + index_count;
		for (size_t i = 0; i + 2 < surface.indices.size(); i += 3) {
			*index++ = first + int32_t(surface.indices[i]);
			*index++ = first + int32_t(surface.indices[i + 2]);
			*index++ = first + int32_t(surface.indices[i + 1]);
		}
	}

	void add_to(const Ref<ArrayMesh> &mesh, const Ref<godot::Material> &material) const {
		if (indices.is_empty()) {
			return;
		}
		Array arrays;
		arrays.resize(godot::Mesh::ARRAY_MAX);
		arrays[godot::Mesh::ARRAY_VERTEX] = positions;
		arrays[godot::Mesh::ARRAY_NORMAL] = normals;
		arrays[godot::Mesh::ARRAY_COLOR] = colors;
		arrays[godot::Mesh::ARRAY_INDEX] = indices;
		mesh->add_surface_from_arrays(godot::Mesh::PRIMITIVE_TRIANGLES, arrays);
		mesh->surface_set_material(mesh->get_surface_count() - 1, material);
	}
};

} // namespace

Ref<ArrayMesh> to_godot(const Mesh &mesh, const std::vector<Material> &materials, const Ref<godot::Material> &opaque,
		const Ref<godot::Material> &transparent) {
	Arrays solid, clear;
	for (const MeshSurface &surface : make_surfaces(mesh)) {
		const glm::vec4 color = surface.material < materials.size() ? materials[surface.material].color : glm::vec4(1.0f);
		(color.a < 1.0f ? clear : solid).add(surface, to_godot(color));
	}
	Ref<ArrayMesh> result;
	if (solid.indices.is_empty() && clear.indices.is_empty()) {
		return result;
	}
	result.instantiate();
	solid.add_to(result, opaque);
	clear.add_to(result, transparent);
	return result;
}

NavRegion from_godot(const Ref<NavigationMesh> &mesh) {
	NavRegion region;
	region.vertices = from_godot(mesh->get_vertices());
	for (int i = 0; i < mesh->get_polygon_count(); ++i) {
		const PackedInt32Array polygon = mesh->get_polygon(i);
		region.polygons.emplace_back(polygon.ptr(), polygon.ptr() + polygon.size());
	}
	return region;
}

Ref<ArrayMesh> to_godot(const Figure &figure) {
	PackedVector3Array positions, normals;
	PackedVector2Array region_and_limb, hip_and_knee;
	for (const FigureVertex &vertex : figure.vertices) {
		positions.push_back(to_godot(vertex.position));
		normals.push_back(to_godot(vertex.normal));
		region_and_limb.push_back(Vector2(float(vertex.region), float(vertex.limb)));
		hip_and_knee.push_back(Vector2(figure.hip_height, figure.knee_height));
	}
	PackedInt32Array indices;
	for (size_t i = 0; i + 2 < figure.indices.size(); i += 3) {
		indices.push_back(int32_t(figure.indices[i]));
		indices.push_back(int32_t(figure.indices[i + 2]));
		indices.push_back(int32_t(figure.indices[i + 1]));
	}
	Array arrays;
	arrays.resize(godot::Mesh::ARRAY_MAX);
	arrays[godot::Mesh::ARRAY_VERTEX] = positions;
	arrays[godot::Mesh::ARRAY_NORMAL] = normals;
	arrays[godot::Mesh::ARRAY_TEX_UV] = region_and_limb;
	arrays[godot::Mesh::ARRAY_TEX_UV2] = hip_and_knee;
	arrays[godot::Mesh::ARRAY_INDEX] = indices;
	Ref<ArrayMesh> mesh;
	mesh.instantiate();
	mesh->add_surface_from_arrays(godot::Mesh::PRIMITIVE_TRIANGLES, arrays);
	return mesh;
}

} // namespace pcg
