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

PackedVector3Array moved(const std::vector<glm::vec3> &polygon, glm::vec3 origin) {
	std::vector<glm::vec3> points = polygon;
	for (glm::vec3 &point : points) {
		point -= origin;
	}
	return to_godot(std::span<const glm::vec3>(points));
}

String block_name(BlockId block) { return "Block" + String::num_int64(index_of(block)); }

constexpr size_t street_piece = 400; // faces

// Of a flat mesh without texture coordinates, as the ground's are.
Mesh part_of(const Mesh &mesh, size_t first, size_t end) {
	Mesh part;
	for (size_t i = first; i < end; ++i) {
		MeshFace face = mesh.faces[i];
		const uint32_t first_loop = face.first_loop;
		face.first_loop = uint32_t(part.loop_ends.size());
		for (uint32_t loop = first_loop; loop < first_loop + face.loop_count; ++loop) {
			const std::span<const glm::vec3> corners = mesh.loop(loop);
			part.positions.insert(part.positions.end(), corners.begin(), corners.end());
			part.loop_ends.push_back(uint32_t(part.positions.size()));
		}
		part.faces.push_back(face);
	}
	return part;
}

Transform3D to_frame(const glm::mat4 &matrix) {
	const glm::vec3 x(matrix[0]), y(matrix[1]), z(matrix[2]), origin(matrix[3]);
	return Transform3D(Basis(to_godot(x), to_godot(y), to_godot(z)), to_godot(origin));
}

} // namespace

glm::vec3 middle_of(const std::vector<glm::vec3> &polygon) {
	glm::vec3 sum(0.0f);
	for (const glm::vec3 &point : polygon) {
		sum += point;
	}
	return polygon.empty() ? sum : sum / float(polygon.size());
}

CityBuilder::CityBuilder(Node3D *root, const City &city, const CollisionSettings &collision) :
		_root(root), _city(city), _collision(collision) {
	// Its parts are saved with the scene that the city is of, or with the city where it is a scene of its own.
	_owner = root->get_owner() ? root->get_owner() : root;
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
	instance->add_to_group(group, true);
	add(parent, instance, name);
	Node3D *body = _collision.is_used ? make_static_body(mesh, _collision) : nullptr;
	if (body != nullptr) {
		add(instance, body, "Body");
		body->get_child(0)->set_owner(_owner);
	}
}

void CityBuilder::add_instances(Node *parent, const LotBuild &build, int32_t object, Vector3 position) {
	for (MultiMeshInstance3D *node : _instances.make(build.model, object, position)) {
		node->add_to_group(group, true);
		add(parent, node, "Instances");
	}
}

// Pieces of the streets: drawn where they are in view, and made in slices of time. False once all are there.
bool CityBuilder::build_streets() {
	const Mesh &all = _city.ground.streets;
	if (_streets.is_null()) {
		Node3D *streets = memnew(Node3D);
		streets->add_to_group(group, true);
		add(_root, streets, "Streets");
		_streets = ObjectID(streets->get_instance_id());
	}
	if (_next_street == all.faces.size()) {
		return false;
	}
	const size_t end = std::min(_next_street + street_piece, all.faces.size());
	Node3D *streets = Object::cast_to<Node3D>(ObjectDB::get_instance(_streets));
	if (streets != nullptr) { // nobody has freed it meanwhile
		add_geometry(streets, part_of(all, _next_street, end), _city.ground.materials, "Geometry");
	}
	_next_street = end;
	return true;
}

bool CityBuilder::build_next() {
	if (build_streets()) {
		return true;
	}
	const std::vector<CityBlock> &blocks = _city.layout.blocks;
	if (_bare_lot.is_valid()) {
		if (Node3D *lot = Object::cast_to<Node3D>(ObjectDB::get_instance(_bare_lot))) {
			furnish_lot(lot, blocks[_next_block - 1].lots[_next_lot - 1]);
		}
		_bare_lot = ObjectID();
		return true;
	}
	if (_next_block > 0 && _next_lot < blocks[_next_block - 1].lots.size()) {
		const LotId lot = blocks[_next_block - 1].lots[_next_lot++];
		if (Node3D *block = Object::cast_to<Node3D>(ObjectDB::get_instance(_block))) {
			build_lot(block, lot);
		}
		return true;
	}
	if (_next_block == blocks.size()) {
		return false;
	}
	begin_block(BlockId(_next_block++));
	return true;
}

double CityBuilder::next_work() const {
	constexpr double work_of_node = 10.0, least = 10.0;
	const std::vector<CityBlock> &blocks = _city.layout.blocks;
	if (const size_t rest = _city.ground.streets.faces.size() - _next_street; rest > 0) {
		return least + double(std::min(rest, street_piece));
	}
	if (_next_block > 0 && (_bare_lot.is_valid() || _next_lot < blocks[_next_block - 1].lots.size())) {
		const LotBuild &build = _city.lots[index_of(blocks[_next_block - 1].lots[_next_lot - (_bare_lot.is_valid() ? 1 : 0)])];
		if (!_bare_lot.is_valid()) {
			return least + double(build.model.mesh.faces.size());
		}
		double faces = double(build.model.instances.size());
		for (const auto &object : build.model.objects) {
			faces += double(object.mesh.faces.size());
		}
		return least + faces + work_of_node * double(build.entrances.size() + build.zones.size() + build.objects.size());
	}
	return least + (_next_block < _city.ground.blocks.size() ? double(_city.ground.blocks[_next_block].faces.size()) : 0.0);
}

void CityBuilder::begin_block(BlockId id) {
	Node3D *block = memnew(Node3D);
	block->add_to_group(group, true);
	add(_root, block, block_name(id));
	if (index_of(id) < _city.ground.blocks.size()) {
		add_geometry(block, _city.ground.blocks[index_of(id)], _city.ground.materials, "Ground");
	}
	_block = block->get_instance_id();
	_next_lot = 0;
}

void CityBuilder::add_region(uint32_t tile, const Ref<NavigationMesh> &mesh) {
	const String name = "Tile" + String::num_int64(tile);
	Node *parent = _root->get_node_or_null(NodePath("Navigation"));
	NavigationRegion3D *region = parent ? Object::cast_to<NavigationRegion3D>(parent->get_node_or_null(NodePath(name))) : nullptr;
	if (region != nullptr) {
		region->set_navigation_mesh(mesh);
		return;
	}
	if (mesh.is_null() || mesh->get_polygon_count() == 0) {
		return;
	}
	if (parent == nullptr) {
		parent = memnew(Node3D);
		parent->add_to_group(group, true);
		add(_root, parent, "Navigation");
	}
	region = memnew(NavigationRegion3D);
	region->set_navigation_mesh(mesh);
	add(parent, region, name);
}

std::vector<const Node *> CityBuilder::clear_lot(PCGLot *node, LotId id) {
	const LotBuild &build = _city.lots[index_of(id)];
	const auto is_in = [](const auto &ids, int number) {
		return std::ranges::any_of(ids, [&](auto one) { return int(index_of(one)) == number; });
	};
	std::vector<const Node *> removed;
	for (int i = node->get_child_count() - 1; i >= 0; --i) {
		Node *child = node->get_child(i);
		const PCGEntrance *entrance = Object::cast_to<PCGEntrance>(child);
		const PCGZone *zone = Object::cast_to<PCGZone>(child);
		const PCGObject *object = Object::cast_to<PCGObject>(child);
		const bool has_meaning = (entrance && is_in(build.entrances, entrance->get_entrance_id())) ||
				(zone && is_in(build.zones, zone->get_zone_id())) || (object && is_in(build.objects, object->get_object_id()));
		if (has_meaning || child->is_in_group(group)) {
			if (has_meaning) {
				removed.push_back(child);
			}
			node->remove_child(child);
			child->queue_free();
		}
	}
	return removed;
}

void CityBuilder::build_lot(Node3D *parent, LotId id) {
	const Lot &lot = _city.layout.lot(id);
	const glm::vec3 origin = middle_of(lot.polygon);
	PCGLot *node = memnew(PCGLot);
	node->set_lot_id(int(index_of(id)));
	node->set_block_id(int(index_of(lot.block)));
	node->set_type(to_godot(std::string_view(lot.type)));
	node->set_polygon(moved(lot.polygon, origin));
	node->set_position(to_godot(origin));
	node->add_to_group("pcg_lots", true);
	add(parent, node, "Lot" + String::num_int64(index_of(id)));
	add_lot_geometry(node, id);
	_bare_lot = ObjectID(node->get_instance_id());
}

void CityBuilder::fill_lot(PCGLot *node, LotId id) {
	add_lot_geometry(node, id);
	furnish_lot(node, id);
}

void CityBuilder::add_lot_geometry(Node3D *node, LotId id) {
	const LotBuild &build = _city.lots[index_of(id)];
	add_geometry(node, build.model.mesh, build.model.materials, "Geometry", -to_godot(middle_of(_city.layout.lot(id).polygon)));
}

void CityBuilder::furnish_lot(Node3D *node, LotId id) {
	const LotBuild &build = _city.lots[index_of(id)];
	const Vector3 origin = to_godot(middle_of(_city.layout.lot(id).polygon));
	add_instances(node, build, -1, -origin);
	build_entrances(node, build, origin);
	build_zones(node, build, origin);
	build_objects(node, build, origin);
}

void CityBuilder::build_entrances(Node3D *lot, const LotBuild &build, Vector3 origin) {
	for (const EntranceId id : build.entrances) {
		const Entrance &entrance = _city.model.entrance(id);
		PCGEntrance *node = memnew(PCGEntrance);
		node->set_type(to_godot(_city.model.types.name(entrance.type)));
		node->set_capacity(int(entrance.capacity));
		node->set_building_id(int(index_of(entrance.building)));
		node->set_entrance_id(int(index_of(id)));
		node->set_transform(to_godot(entrance.position, entrance.facing).translated(-origin));
		node->add_to_group("pcg_entrances", true);
		add(lot, node, "Entrance" + String::num_int64(index_of(id)));
	}
}

void CityBuilder::build_zones(Node3D *lot, const LotBuild &build, Vector3 origin) {
	for (const ZoneId id : build.zones) {
		const Zone &zone = _city.model.zone(id);
		const glm::vec3 middle = centroid(zone);
		PCGZone *node = memnew(PCGZone);
		node->set_type(to_godot(_city.model.types.name(zone.type)));
		node->set_polygon(moved(zone.polygon, middle));
		node->set_height(zone.height);
		node->set_zone_id(int(index_of(id)));
		node->set_position(to_godot(middle) - origin);
		node->add_to_group("pcg_zones", true);
		add(lot, node, "Zone" + String::num_int64(index_of(id)));
	}
}

void CityBuilder::build_objects(Node3D *lot, const LotBuild &build, Vector3 origin) {
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
		node->set_transform(frame.translated(-origin));
		node->add_to_group("pcg_objects", true);
		add(lot, node, "Object" + String::num_int64(index_of(build.objects[i])));
		add_geometry(node, build.model.objects[i].mesh, build.model.materials, "Geometry");
		add_instances(node, build, int32_t(i));
	}
}

} // namespace pcg
