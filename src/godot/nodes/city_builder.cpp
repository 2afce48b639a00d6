#include "godot/nodes/city_builder.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include <godot_cpp/classes/array_mesh.hpp>
#include <godot_cpp/classes/mesh_instance3d.hpp>
#include <godot_cpp/classes/navigation_region3d.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include "core/semantics/city_query.h"
#include "godot/convert.h"
#include "godot/nodes/pcg_entrance.h"
#include "godot/nodes/pcg_lot.h"
#include "godot/nodes/pcg_object.h"
#include "godot/nodes/pcg_zone.h"

using namespace godot;

namespace pcg {

namespace {

glm::vec3 middle_of(const std::vector<glm::vec3> &polygon) {
	glm::vec3 sum(0.0f);
	for (const glm::vec3 &point : polygon) {
		sum += point;
	}
	return polygon.empty() ? sum : sum / float(polygon.size());
}

PackedVector3Array moved(const std::vector<glm::vec3> &polygon, glm::vec3 origin) {
	std::vector<glm::vec3> points = polygon;
	for (glm::vec3 &point : points) {
		point -= origin;
	}
	return to_godot(std::span<const glm::vec3>(points));
}

String block_name(BlockId block) { return "Block" + String::num_int64(index_of(block)); }

Transform3D to_frame(const glm::mat4 &matrix) {
	const glm::vec3 x(matrix[0]), y(matrix[1]), z(matrix[2]), origin(matrix[3]);
	return Transform3D(Basis(to_godot(x), to_godot(y), to_godot(z)), to_godot(origin));
}

} // namespace

CityBuilder::CityBuilder(Node3D *root, const City &city) : _root(root), _city(city) {
	// A city that is the scene's own root owns its parts; one that no scene holds (made by a script) leaves them without an owner.
	_owner = root->get_owner() ? root->get_owner() : (root->get_scene_file_path().is_empty() ? nullptr : root);
}

void CityBuilder::clear(Node3D *root) {
	for (int i = root->get_child_count() - 1; i >= 0; --i) {
		Node *child = root->get_child(i);
		if (child->is_in_group(group)) {
			root->remove_child(child);
			child->queue_free();
		}
	}
}

void CityBuilder::add(Node *parent, Node *child, const String &name) {
	child->set_name(name);
	parent->add_child(child, true);
	if (_owner) {
		child->set_owner(_owner);
	}
}

void CityBuilder::add_geometry(Node *parent, const Mesh &mesh, const std::vector<Material> &materials, const char *name,
		Vector3 position) {
	const Ref<ArrayMesh> surfaces = _materials.to_godot(mesh, materials);
	if (surfaces.is_null()) {
		return;
	}
	MeshInstance3D *instance = memnew(MeshInstance3D);
	instance->set_mesh(surfaces);
	instance->set_position(position);
	add(parent, instance, name);
}

void CityBuilder::add_instances(Node *parent, const LotBuild &build, int32_t object, Vector3 position) {
	for (MultiMeshInstance3D *node : _instances.make(build.model, object, position)) {
		add(parent, node, "Instances");
	}
}

void CityBuilder::build_streets() {
	Node3D *streets = memnew(Node3D);
	streets->add_to_group(group, true);
	add(_root, streets, "Streets");
	add_geometry(streets, _city.ground.streets, _city.ground.materials, "Geometry");
}

void CityBuilder::build_block(BlockId id) {
	Node3D *block = memnew(Node3D);
	block->add_to_group(group, true);
	add(_root, block, block_name(id));
	if (index_of(id) < _city.ground.blocks.size()) {
		add_geometry(block, _city.ground.blocks[index_of(id)], _city.ground.materials, "Ground");
	}
	for (const LotId lot : _city.layout.block(id).lots) {
		build_lot(block, lot);
	}
}

void CityBuilder::add_region(uint32_t tile, const Ref<NavigationMesh> &mesh) {
	if (mesh.is_null() || mesh->get_polygon_count() == 0) {
		return;
	}
	Node *parent = _root->get_node_or_null(NodePath("Navigation"));
	if (parent == nullptr) {
		parent = memnew(Node3D);
		parent->add_to_group(group, true);
		add(_root, parent, "Navigation");
	}
	NavigationRegion3D *region = memnew(NavigationRegion3D);
	region->set_navigation_mesh(mesh);
	add(parent, region, "Tile" + String::num_int64(tile));
}

void CityBuilder::build_lot(Node3D *parent, LotId id) {
	const Lot &lot = _city.layout.lot(id);
	const LotBuild &build = _city.lots[index_of(id)];
	const glm::vec3 origin = middle_of(lot.polygon);
	PCGLot *node = memnew(PCGLot);
	node->set_lot_id(int(index_of(id)));
	node->set_block_id(int(index_of(lot.block)));
	node->set_type(to_godot(std::string_view(lot.type)));
	node->set_polygon(moved(lot.polygon, origin));
	node->set_position(to_godot(origin));
	node->add_to_group("pcg_lots", true);
	add(parent, node, "Lot" + String::num_int64(index_of(id)));
	add_geometry(node, build.model.mesh, build.model.materials, "Geometry", to_godot(-origin));
	add_instances(node, build, -1, to_godot(-origin));
	build_entrances(node, build);
	build_zones(node, build);
	build_objects(node, build);
}

void CityBuilder::build_entrances(Node3D *lot, const LotBuild &build) {
	for (const EntranceId id : build.entrances) {
		const Entrance &entrance = _city.model.entrance(id);
		PCGEntrance *node = memnew(PCGEntrance);
		node->set_type(to_godot(_city.model.types.name(entrance.type)));
		node->set_capacity(int(entrance.capacity));
		node->set_building_id(int(index_of(entrance.building)));
		node->set_entrance_id(int(index_of(id)));
		node->set_transform(to_godot(entrance.position, entrance.facing).translated(-lot->get_position()));
		node->add_to_group("pcg_entrances", true);
		add(lot, node, "Entrance" + String::num_int64(index_of(id)));
		_entrances.resize(std::max(_entrances.size(), size_t(index_of(id)) + 1));
		_entrances[index_of(id)] = node->get_instance_id();
	}
}

void CityBuilder::mark_unreachable(std::span<const Reach> verdicts) {
	for (size_t i = 0; i < std::min(verdicts.size(), _entrances.size()); ++i) {
		PCGEntrance *node = Object::cast_to<PCGEntrance>(ObjectDB::get_instance(_entrances[i]));
		if (node && (verdicts[i] == Reach::OffMesh || verdicts[i] == Reach::Island)) {
			node->set_reachable(false);
		}
	}
}

void CityBuilder::build_zones(Node3D *lot, const LotBuild &build) {
	for (const ZoneId id : build.zones) {
		const Zone &zone = _city.model.zone(id);
		const glm::vec3 origin = centroid(zone);
		PCGZone *node = memnew(PCGZone);
		node->set_type(to_godot(_city.model.types.name(zone.type)));
		node->set_polygon(moved(zone.polygon, origin));
		node->set_height(zone.height);
		node->set_zone_id(int(index_of(id)));
		node->set_position(to_godot(origin) - lot->get_position());
		node->add_to_group("pcg_zones", true);
		add(lot, node, "Zone" + String::num_int64(index_of(id)));
	}
}

void CityBuilder::build_objects(Node3D *lot, const LotBuild &build) {
	for (size_t i = 0; i < build.objects.size(); ++i) {
		const CityObject &object = _city.model.object(build.objects[i]);
		const Transform3D frame = to_frame(build.model.objects[i].frame);
		PCGObject *node = memnew(PCGObject);
		node->set_type(to_godot(_city.model.types.name(object.type)));
		node->set_object_id(int(index_of(build.objects[i])));
		TypedArray<Transform3D> places;
		for (const Place &place : object.places) {
			places.push_back(frame.affine_inverse() * to_godot(place.position, place.facing));
		}
		node->set_places(places);
		node->set_transform(frame.translated(-lot->get_position()));
		node->add_to_group("pcg_objects", true);
		add(lot, node, "Object" + String::num_int64(index_of(build.objects[i])));
		add_geometry(node, build.model.objects[i].mesh, build.model.materials, "Geometry");
		add_instances(node, build, int32_t(i));
	}
}

} // namespace pcg
