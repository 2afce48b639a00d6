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

constexpr size_t ground_piece = 1500; // faces

template <typename Value> void append_part(std::vector<Value> &to, const std::vector<Value> &from, size_t first, size_t end) {
	if (!from.empty()) {
		to.insert(to.end(), from.begin() + ptrdiff_t(first), from.begin() + ptrdiff_t(end));
	}
}

Mesh part_of(const Mesh &mesh, size_t first, size_t end) {
	Mesh part;
	for (size_t i = first; i < end; ++i) {
		MeshFace face = mesh.faces[i];
		const uint32_t first_loop = face.first_loop;
		face.first_loop = uint32_t(part.loop_ends.size());
		for (uint32_t loop = first_loop; loop < first_loop + face.loop_count; ++loop) {
			const size_t from = mesh.first_corner(loop), to = mesh.loop_ends[loop];
			append_part(part.positions, mesh.positions, from, to);
			append_part(part.normals, mesh.normals, from, to);
			for (size_t set = 0; set < mesh.uvs.size(); ++set) {
				append_part(part.uvs[set], mesh.uvs[set], from, to);
			}
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

// What the making of nodes costs beside that of faces.
constexpr double work_of_node = 10.0;

// Of all that is not the geometry of a part itself.
double work_of_furniture(const cga::DerivationResult &model, size_t node_count) {
	double faces = double(model.instances.size());
	for (const auto &object : model.objects) {
		faces += double(object.mesh.faces.size());
	}
	return faces + work_of_node * double(node_count);
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

void CityBuilder::add_instances(Node *parent, const cga::DerivationResult &model, int32_t object, Vector3 position) {
	for (MultiMeshInstance3D *node : _instances.make(model, object, position)) {
		node->add_to_group(group, true);
		add(parent, node, "Instances");
	}
}

// Made in slices of time, and drawn where its pieces are in view; then comes what stands on it.
void CityBuilder::go_on_with_ground() {
	const cga::DerivationResult &model = _ground->model;
	Node3D *node = Object::cast_to<Node3D>(ObjectDB::get_instance(_ground_node));
	if (node != nullptr && _next_face < model.mesh.faces.size()) {
		const size_t end = std::min(_next_face + ground_piece, model.mesh.faces.size());
		add_geometry(node, part_of(model.mesh, _next_face, end), model.materials, "Ground");
		_next_face = end;
		return;
	}
	if (node != nullptr) {
		add_instances(node, model, -1);
		build_zones(node, _ground->zones, {});
		build_objects(node, _ground->objects, model, {});
	}
	_ground = nullptr;
}

void CityBuilder::begin_ground(Node3D *node, const GroundBuild &build) {
	_ground = &build;
	_ground_node = ObjectID(node->get_instance_id());
	_next_face = 0;
}

void CityBuilder::begin_streets(size_t tile) {
	if (tile == 0) {
		Node3D *streets = memnew(Node3D);
		streets->add_to_group(group, true);
		add(_root, streets, "Streets");
		_streets = ObjectID(streets->get_instance_id());
	}
	Node3D *streets = Object::cast_to<Node3D>(ObjectDB::get_instance(_streets));
	const GroundBuild &build = _city.ground.streets[tile];
	if (streets == nullptr || (build.model.mesh.is_empty() && build.model.instances.empty() && build.objects.empty())) {
		return;
	}
	Node3D *node = memnew(Node3D);
	node->add_to_group(group, true);
	add(streets, node, "Tile" + String::num_int64(int64_t(tile)));
	begin_ground(node, build);
}

bool CityBuilder::build_next() {
	if (_ground != nullptr) {
		go_on_with_ground();
		return true;
	}
	if (_next_tile < _city.ground.streets.size()) {
		begin_streets(_next_tile++);
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
	if (_ground != nullptr) {
		const size_t rest = _ground->model.mesh.faces.size() - _next_face;
		return work_of_node + (rest > 0 ? double(std::min(rest, ground_piece)) : work_of_furniture(_ground->model, _ground->zones.size() + _ground->objects.size()));
	}
	const std::vector<CityBlock> &blocks = _city.layout.blocks;
	const bool is_bare = _bare_lot.is_valid();
	if (_next_block == 0 || !(is_bare || _next_lot < blocks[_next_block - 1].lots.size())) {
		return work_of_node;
	}
	const LotBuild &build = _city.lots[index_of(blocks[_next_block - 1].lots[_next_lot - (is_bare ? 1 : 0)])];
	return work_of_node + (is_bare ? work_of_furniture(build.model, build.entrances.size() + build.zones.size() + build.objects.size())
								   : double(build.model.mesh.faces.size()));
}

void CityBuilder::begin_block(BlockId id) {
	Node3D *block = memnew(Node3D);
	block->add_to_group(group, true);
	add(_root, block, block_name(id));
	if (index_of(id) < _city.ground.blocks.size()) {
		begin_ground(block, _city.ground.blocks[index_of(id)]);
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
	TypedArray<PackedVector3Array> holes;
	for (const std::vector<glm::vec3> &hole : lot.holes) {
		holes.push_back(moved(hole, origin));
	}
	node->set_holes(holes);
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
	add_instances(node, build.model, -1, -origin);
	build_entrances(node, build, origin);
	build_zones(node, build.zones, origin);
	build_objects(node, build.objects, build.model, origin);
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

void CityBuilder::build_zones(Node3D *parent, const std::vector<ZoneId> &zones, Vector3 origin) {
	for (const ZoneId id : zones) {
		const Zone &zone = _city.model.zone(id);
		const glm::vec3 middle = centroid(zone);
		PCGZone *node = memnew(PCGZone);
		node->set_type(to_godot(_city.model.types.name(zone.type)));
		node->set_polygon(moved(zone.polygon, middle));
		node->set_height(zone.height);
		node->set_zone_id(int(index_of(id)));
		node->set_position(to_godot(middle) - origin);
		node->add_to_group("pcg_zones", true);
		add(parent, node, "Zone" + String::num_int64(index_of(id)));
	}
}

void CityBuilder::build_objects(Node3D *parent, const std::vector<ObjectId> &objects, const cga::DerivationResult &model, Vector3 origin) {
	for (size_t i = 0; i < objects.size(); ++i) {
		const CityObject &object = _city.model.object(objects[i]);
		const Transform3D frame = to_frame(model.objects[i].frame);
		PCGObject *node = memnew(PCGObject);
		node->set_type(to_godot(_city.model.types.name(object.type)));
		node->set_object_id(int(index_of(objects[i])));
		TypedArray<Transform3D> places;
		for (const Place &place : object.places) {
			places.push_back(frame.affine_inverse() * to_godot(place.position, place.facing));
		}
		node->set_places(places);
		node->set_transform(frame.translated(-origin));
		node->add_to_group("pcg_objects", true);
		add(parent, node, "Object" + String::num_int64(index_of(objects[i])));
		add_geometry(node, model.objects[i].mesh, model.materials, "Geometry");
		add_instances(node, model, int32_t(i));
	}
}

} // namespace pcg
