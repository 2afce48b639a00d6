#include <godot_cpp/classes/mesh.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>
#include <godot_cpp/variant/packed_vector2_array.hpp>

#include "godot/convert.h"

using namespace godot;

namespace pcg {

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
