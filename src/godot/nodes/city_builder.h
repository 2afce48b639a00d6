#pragma once

#include <algorithm>
#include <vector>

#include <godot_cpp/classes/navigation_mesh.hpp>
#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/core/object_id.hpp>

#include "core/city/city.h"
#include "godot/city_materials.h"
#include "godot/nodes/city_collision.h"
#include "godot/nodes/city_instances.h"

namespace pcg {

class PCGLot;

// The middle of a lot's corners: where its node stands.
glm::vec3 middle_of(const std::vector<glm::vec3> &polygon);

// Puts a city into the scene: below `root` the streets, tile by tile, a node for each block with its lots, their geometry and a node for each entrance, zone
// and object, and one with the regions for walking, tile by tile.
class CityBuilder {
public:
	CityBuilder(godot::Node3D *root, const City &city, const CollisionSettings &collision = {});

	// Streets first, by tile, then block by block the ground and the lots, a piece a call: some faces of the ground, the geometry of a lot, what stands
	// on it. False once all are there.
	bool build_next();
	// About how much work the next piece is; 1 is that of a face.
	double next_work() const;
	double progress() const { return double(_next_block) / double(std::max<size_t>(1, _city.layout.blocks.size())); }
	void add_region(uint32_t tile, const godot::Ref<godot::NavigationMesh> &mesh);
	// Of a lot's node: takes away all that generation made, and makes it of what the city says now. What was put there by hand stays.
	std::vector<const godot::Node *> clear_lot(PCGLot *node, LotId lot); // what has meaning among it
	void fill_lot(PCGLot *node, LotId lot);
	// Removes whatever an earlier builder made.
	static void clear(godot::Node3D *root);

	// Everything that was built is in this group of the scene tree; what has meaning is in "pcg_lots", "pcg_entrances", "pcg_zones" and
	// "pcg_objects" besides.
	static constexpr const char *group = "pcg_generated";

private:
	void begin_streets(size_t tile);
	void begin_block(BlockId block);
	// A part of the public ground and what stands on it, piece by piece.
	void begin_ground(godot::Node3D *node, const GroundBuild &build);
	void go_on_with_ground();
	void add(godot::Node *parent, godot::Node *child, const godot::String &name);
	void add_geometry(godot::Node *parent, const Mesh &mesh, const std::vector<Material> &materials, const char *name,
			godot::Vector3 position = {});
	// Of one of the model's objects, or of none of them (-1).
	void add_instances(godot::Node *parent, const cga::DerivationResult &model, int32_t object, godot::Vector3 position = {});
	void build_lot(godot::Node3D *parent, LotId lot);
	void add_lot_geometry(godot::Node3D *lot, LotId id);
	void furnish_lot(godot::Node3D *lot, LotId id);
	void build_entrances(godot::Node3D *lot, const LotBuild &build, godot::Vector3 origin);
	void build_zones(godot::Node3D *parent, const std::vector<ZoneId> &zones, godot::Vector3 origin);
	void build_objects(godot::Node3D *parent, const std::vector<ObjectId> &objects, const cga::DerivationResult &model, godot::Vector3 origin);

	godot::Node3D *_root;
	const City &_city;
	CollisionSettings _collision;
	godot::Node *_owner; // of everything that is made, so that it is saved with the scene
	size_t _next_tile = 0; // of streets
	godot::ObjectID _streets, _ground_node; // their node, and that of the ground in work
	const GroundBuild *_ground = nullptr; // in work
	size_t _next_face = 0; // of it
	uint32_t _next_block = 0;
	size_t _next_lot = 0; // of the block before that one
	godot::ObjectID _block, _bare_lot; // its node, and that of a lot with nothing but its geometry yet; a user may free them meanwhile
	CityMaterials _materials;
	CityInstances _instances{ _materials };
};

} // namespace pcg
