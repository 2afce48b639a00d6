#include "godot/nodes/city_collision.h"

#include <godot_cpp/classes/collision_shape3d.hpp>
#include <godot_cpp/classes/concave_polygon_shape3d.hpp>
#include <godot_cpp/classes/static_body3d.hpp>

#include "godot/convert.h"

using namespace godot;

namespace pcg {

namespace {

PackedVector3Array triangles_of(const Mesh &mesh) {
	PackedVector3Array corners;
	for (const MeshSurface &surface : make_surfaces(mesh)) {
		for (size_t i = 0; i + 2 < surface.indices.size(); i += 3) {
			for (const size_t corner : { i, i + 2, i + 1 }) { // the engine's fronts run clockwise
				corners.push_back(to_godot(surface.positions[surface.indices[corner]]));
			}
		}
	}
	return corners;
}

} // namespace

Node3D *make_static_body(const Mesh &mesh, const CollisionSettings &settings) {
	const PackedVector3Array triangles = triangles_of(mesh);
	if (triangles.is_empty()) {
		return nullptr;
	}
	Ref<ConcavePolygonShape3D> faces;
	faces.instantiate();
	faces->set_faces(triangles);
	CollisionShape3D *shape = memnew(CollisionShape3D);
	shape->set_shape(faces);
	shape->set_name("Shape");
	StaticBody3D *body = memnew(StaticBody3D);
	body->set_collision_layer(settings.layer);
	body->set_collision_mask(settings.mask);
	body->add_child(shape);
	return body;
}

} // namespace pcg
