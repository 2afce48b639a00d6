#pragma once

#include <array>
#include <map>
#include <memory>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/variant/transform3d.hpp>

#include "godot/nodes/city_job.h"
#include "godot/nodes/city_link.h"
#include "godot/nodes/city_overlaps.h"

namespace pcg {

class PCGCity;
class PCGEntrance;
class PCGLot;
class PCGObject;
class PCGZone;

// Carries what happens to the nodes of a city over to its model. The nodes are right: a record is what its node says, each node has one
// record and each record one node. A node whose id belongs to another one is a copy and becomes a record of its own; one that left the tree takes
// its record with it, and finds it again under the same id when it comes back.
class CityEdits {
public:
	explicit CityEdits(PCGCity *city) : _city(city) {}

	// Before the nodes are there or with them. `state` may be null: nodes lose their records, and keep their ids.
	void follow(std::shared_ptr<CityState> state);
	// Noted nodes that stood here before the city came get new ids, for theirs are those of others in it.
	void forget_ids();
	// Instead: makes room for the ids that the noted nodes bring along, so that none of them changes: a city that was saved comes back.
	void restore_ids();
	void note(const godot::Node3D *node) { _noted.push_back(node->get_instance_id()); }
	void note_new_ground() { _changes.has_new_ground = true; } // what lots leave free is not as before

	struct Changes {
		bool has_edits = false; // the model is not as before
		bool has_new_doors = false; // entrances came, moved or went
		bool has_new_zones = false; // zones came, moved or changed
		bool has_new_ground = false; // patches() says something else
	};
	// Takes in all that was noted. Not while another thread reads the model.
	Changes take_in();
	// Removes the records whose nodes were freed before they were taken in, or whose lot was before they were made. Call it when all nodes have been.
	void remove_unclaimed();
	// What the lots and objects that stand in the tree do to the ground for walking.
	LayeredPatches patches() const;
	void mark_overlaps(); // on the nodes of lots, after lots came, moved or went
	void mark_reach(std::span<const Reach> entrances, std::span<const Reach> zones) const; // by EntranceId and ZoneId
	// The node goes, and what its record says is somebody else's to decide.
	void release(const godot::Node *node);
	// Nodes that show what a lot was made with, before it is made anew: what was taken off the lot stays, and finds its record again.
	void note_shown(const LotBuild &build);
	// The node that shows a generated lot; null if it is gone.
	PCGLot *lot_node(LotId lot) const;

private:
	using Kind = CityLink::Kind;
	struct Bond {
		Kind kind = Kind::Entrance;
		uint32_t id = 0;
	};
	struct LotPlace {
		LotId lot = LotId::Invalid;
		godot::Transform3D motion; // from where it was generated
	};

	void take_in(uint64_t object);
	void set_footprint(uint64_t object, std::vector<glm::vec3> corners);
	void let_go(uint64_t object);
	void remove_record(Kind kind, uint32_t id);
	void take_in_lot(PCGLot *node);
	void take_in_entrance(PCGEntrance *node);
	void take_in_zone(PCGZone *node);
	void take_in_object(PCGObject *node);
	bool is_ours(godot::Node3D *node) const;
	std::vector<PlacedLot> placed_lots() const;
	godot::Transform3D frame_of(const godot::Node3D *node) const; // in the city
	BuildingId building_for(PCGEntrance *node);
	template <typename Id> Id take_id(const godot::Node3D *node, const CityLink &link, size_t count);

	PCGCity *_city;
	std::shared_ptr<CityState> _state;
	std::vector<uint64_t> _noted; // objects; some may be gone
	std::unordered_map<uint64_t, Bond> _bonds; // by object
	std::array<std::vector<uint64_t>, CityLink::kind_count> _nodes; // by Kind, then by id; 0 = none. Lots have no records, so none of theirs
	std::map<uint64_t, LotPlace> _lots; // by object
	std::unordered_map<uint64_t, BuildingId> _building_of_lot; // by object
	std::unordered_map<uint32_t, uint64_t> _lot_of_building;
	std::map<uint64_t, std::vector<glm::vec3>> _footprints; // by object
	Changes _changes; // since they were taken in
	CityOverlaps _overlaps;
};

} // namespace pcg
