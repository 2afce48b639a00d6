#include "godot/nodes/city_edits.h"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

#include <godot_cpp/core/object.hpp>

#include "godot/convert.h"
#include "godot/nodes/city_builder.h"
#include "godot/nodes/city_link.h"
#include "godot/nodes/pcg_city.h"
#include "godot/nodes/pcg_entrance.h"
#include "godot/nodes/pcg_lot.h"
#include "godot/nodes/pcg_object.h"
#include "godot/nodes/pcg_zone.h"

using namespace godot;

namespace pcg {

namespace {

constexpr float arm = 1e-3f; // metres; less is rounding between the frames of nodes

template <typename T> T *node_of(uint64_t object) { return Object::cast_to<T>(ObjectDB::get_instance(object)); }

bool is_same(glm::vec3 a, glm::vec3 b) { return glm::distance(a, b) <= arm; }

bool is_same(const std::vector<glm::vec3> &a, const std::vector<glm::vec3> &b) {
	return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](glm::vec3 x, glm::vec3 y) { return is_same(x, y); });
}

bool is_same(const std::vector<Place> &a, const std::vector<Place> &b) {
	return std::equal(a.begin(), a.end(), b.begin(), b.end(),
			[](const Place &x, const Place &y) { return is_same(x.position, y.position) && is_same(x.facing, y.facing); });
}

PCGLot *lot_above(const Node *node) {
	for (Node *parent = node->get_parent(); parent != nullptr; parent = parent->get_parent()) {
		if (PCGLot *lot = Object::cast_to<PCGLot>(parent)) {
			return lot;
		}
	}
	return nullptr;
}

LotId lot_id_above(const Node *node) {
	const PCGLot *lot = lot_above(node);
	return lot && lot->get_lot_id() >= 0 ? LotId(lot->get_lot_id()) : LotId::Invalid;
}

std::vector<glm::vec3> placed(const Transform3D &frame, const std::vector<glm::vec3> &polygon) {
	std::vector<glm::vec3> result;
	for (const glm::vec3 &corner : polygon) {
		result.push_back(from_godot(frame.xform(to_godot(corner))));
	}
	if (frame.basis.determinant() < 0.0f) { // mirrored: the other way around again
		std::reverse(result.begin(), result.end());
	}
	return result;
}

} // namespace

void CityEdits::follow(std::shared_ptr<CityState> state) {
	for (const auto &[object, bond] : _bonds) {
		_noted.push_back(object);
	}
	_state = std::move(state);
	_bonds.clear();
	_nodes = {};
	_lots.clear();
	_building_of_lot.clear();
	_lot_of_building.clear();
	_footprints.clear();
	_overlaps.clear();
	_changes = {};
}

void CityEdits::forget_ids() {
	for (const uint64_t object : _noted) {
		Node3D *node = node_of<Node3D>(object);
		CityLink *link = is_ours(node) ? CityLink::of(node) : nullptr;
		if (!link || link->kind() == Kind::Lot) {
			continue;
		}
		link->set_id(-1);
		if (PCGEntrance *entrance = Object::cast_to<PCGEntrance>(node)) {
			entrance->lead_into(-1);
		}
	}
}

void CityEdits::restore_ids() {
	constexpr int most = 1 << 24; // ids beyond that are not ours
	std::array<size_t, CityLink::kind_count> counts{};
	size_t buildings = 0;
	for (const uint64_t object : _noted) {
		Node *node = node_of<Node>(object);
		const CityLink *link = node ? CityLink::of(node) : nullptr;
		if (!link || link->id() < 0 || link->id() >= most) {
			continue;
		}
		size_t &count = counts[size_t(link->kind())];
		count = std::max(count, size_t(link->id()) + 1);
		const PCGEntrance *entrance = Object::cast_to<PCGEntrance>(node);
		if (entrance && entrance->get_building_id() >= 0 && entrance->get_building_id() < most) {
			buildings = std::max(buildings, size_t(entrance->get_building_id()) + 1);
		}
	}
	_state->city.model.reserve_ids(buildings, counts[size_t(Kind::Entrance)], counts[size_t(Kind::Zone)], counts[size_t(Kind::Object)]);
}

CityEdits::Changes CityEdits::take_in() {
	std::vector<uint64_t> noted = std::move(_noted);
	_noted.clear();
	if (!_state) {
		return {};
	}
	const uint64_t revision = _state->city.model.revision();
	std::unordered_set<uint64_t> done;
	for (const uint64_t object : noted) { // those that left first: what comes in may be what went out elsewhere
		if (!is_ours(node_of<Node3D>(object)) && done.insert(object).second) {
			let_go(object);
		}
	}
	for (const uint64_t object : noted) {
		if (done.insert(object).second) {
			take_in(object);
		}
	}
	_changes.has_edits = _state->city.model.revision() != revision;
	return std::exchange(_changes, {});
}

bool CityEdits::is_ours(Node3D *node) const {
	const CityLink *link = node && node->is_inside_tree() ? CityLink::of(node) : nullptr;
	return link && link->city() == _city;
}

void CityEdits::take_in(uint64_t object) {
	Node3D *node = node_of<Node3D>(object);
	if (PCGLot *lot = Object::cast_to<PCGLot>(node)) {
		take_in_lot(lot);
	} else if (PCGEntrance *entrance = Object::cast_to<PCGEntrance>(node)) {
		take_in_entrance(entrance);
	} else if (PCGZone *zone = Object::cast_to<PCGZone>(node)) {
		take_in_zone(zone);
	} else if (PCGObject *thing = Object::cast_to<PCGObject>(node)) {
		take_in_object(thing);
	}
}

void CityEdits::let_go(uint64_t object) {
	_changes.has_new_ground |= _lots.erase(object) > 0;
	set_footprint(object, {});
	const auto found = _bonds.find(object);
	if (found == _bonds.end()) {
		return;
	}
	const auto [kind, id] = found->second;
	_bonds.erase(found);
	_nodes[size_t(kind)][id] = 0;
	remove_record(kind, id);
}

void CityEdits::remove_record(Kind kind, uint32_t id) {
	CityModel &model = _state->city.model;
	switch (kind) {
		case Kind::Entrance: {
			const BuildingId building = model.entrance(EntranceId(id)).building;
			model.remove_entrance(EntranceId(id));
			if (index_of(building) < model.buildings().size() && model.building(building).entrances.empty()) {
				model.remove_building(building); // nobody gets in or out any more
			}
			_changes.has_new_doors = true;
			break;
		}
		case Kind::Zone: model.remove_zone(ZoneId(id)); break;
		case Kind::Object: model.remove_object(ObjectId(id)); break;
		case Kind::Lot: break;
	}
}

void CityEdits::remove_unclaimed() {
	const auto remove_of = [this](Kind kind, const auto &records) {
		std::vector<uint64_t> &nodes = _nodes[size_t(kind)];
		nodes.resize(std::max(nodes.size(), records.size()));
		for (uint32_t id = 0; id < records.size(); ++id) {
			if (nodes[id] == 0 && !records[id].is_removed) {
				remove_record(kind, id);
			}
		}
	};
	const CityModel &model = _state->city.model;
	remove_of(Kind::Entrance, model.entrances());
	remove_of(Kind::Zone, model.zones());
	remove_of(Kind::Object, model.objects());
}

// From parent to parent: in the world, places far from its origin are rounded, and a city there would seem to be edited.
Transform3D CityEdits::frame_of(const Node3D *node) const {
	Transform3D frame;
	for (const Node3D *part = node; part && !part->is_set_as_top_level() && !part->is_scale_disabled(); part = part->get_parent_node_3d()) {
		frame = part->get_transform() * frame;
		if (part->get_parent() == _city) {
			return frame;
		}
	}
	return _city->get_global_transform().affine_inverse() * node->get_global_transform();
}

// The node's record: the one that it has, else that of its own id if no other node has it, else a new one (Invalid).
template <typename Id> Id CityEdits::take_id(const Node3D *node, const CityLink &link, size_t count) {
	const auto known = _bonds.find(node->get_instance_id());
	if (known != _bonds.end()) {
		return Id(known->second.id);
	}
	std::vector<uint64_t> &nodes = _nodes[size_t(link.kind())];
	nodes.resize(std::max(nodes.size(), count));
	const bool is_free = link.id() >= 0 && size_t(link.id()) < count && nodes[size_t(link.id())] == 0;
	const uint32_t id = is_free ? uint32_t(link.id()) : uint32_t(count);
	nodes.resize(std::max(nodes.size(), size_t(id) + 1));
	nodes[id] = node->get_instance_id();
	_bonds[node->get_instance_id()] = { link.kind(), id };
	return is_free ? Id(id) : Id::Invalid;
}

void CityEdits::take_in_lot(PCGLot *node) {
	const int id = node->get_lot_id();
	if (id < 0 || size_t(id) >= _state->city.layout.lots.size()) {
		return; // drawn by hand: what it is for, its children say
	}
	const Vector3 home = to_godot(middle_of(_state->city.layout.lots[size_t(id)].polygon));
	const LotPlace place = { LotId(id), frame_of(node) * Transform3D(Basis(), -home) };
	const auto [known, is_new] = _lots.try_emplace(node->get_instance_id(), place);
	if (is_new || known->second.lot != place.lot || !known->second.motion.is_equal_approx(place.motion)) {
		known->second = place;
		_changes.has_new_ground = true;
	}
}

// A lot that was copied has a building of its own; a door that was copied alone leads into the same one.
BuildingId CityEdits::building_for(PCGEntrance *node) {
	CityModel &model = _state->city.model;
	const PCGLot *lot = lot_above(node);
	const uint64_t owner = lot ? lot->get_instance_id() : 0;
	const auto known = _building_of_lot.find(owner);
	BuildingId building = owner != 0 && known != _building_of_lot.end() ? known->second : BuildingId::Invalid;
	if (const int wanted = node->get_building_id(); wanted >= 0 && size_t(wanted) < model.buildings().size()) {
		const auto claim = _lot_of_building.find(uint32_t(wanted));
		const bool is_of_other = owner != 0 && claim != _lot_of_building.end() && claim->second != owner && node_of<PCGLot>(claim->second);
		building = is_of_other ? building : BuildingId(wanted);
	}
	const LotId lot_id = lot_id_above(node);
	if (!is_valid(building)) {
		building = model.add_building(lot_id);
	} else if (model.building(building).is_removed) {
		model.put_building(building, lot_id);
	}
	if (owner != 0) {
		_building_of_lot[owner] = building;
		_lot_of_building[index_of(building)] = owner;
	}
	return building;
}

void CityEdits::take_in_entrance(PCGEntrance *node) {
	CityModel &model = _state->city.model;
	const bool is_new = !_bonds.contains(node->get_instance_id());
	EntranceId id = take_id<EntranceId>(node, node->link(), model.entrances().size());
	const Transform3D frame = frame_of(node);
	Entrance entrance;
	entrance.type = model.types.add(from_godot(node->get_type()));
	entrance.position = from_godot(frame.get_origin());
	entrance.facing = facing_of(frame);
	entrance.capacity = uint32_t(node->get_capacity());
	const bool keeps_building = !is_new && int(index_of(model.entrance(id).building)) == node->get_building_id();
	entrance.building = keeps_building ? model.entrance(id).building : building_for(node);
	if (!is_valid(id)) {
		id = model.add_entrance(entrance);
	} else {
		const Entrance &old = model.entrance(id);
		if (!old.is_removed && old.building == entrance.building && old.type == entrance.type && old.capacity == entrance.capacity &&
				is_same(old.position, entrance.position) && is_same(old.facing, entrance.facing)) {
			return;
		}
		model.put_entrance(id, entrance);
	}
	node->link().set_id(int(index_of(id)));
	node->lead_into(int(index_of(entrance.building)));
	_changes.has_new_doors = true;
}

void CityEdits::take_in_zone(PCGZone *node) {
	CityModel &model = _state->city.model;
	const ZoneId id = take_id<ZoneId>(node, node->link(), model.zones().size());
	const Transform3D frame = frame_of(node);
	const float height = float(node->get_height() * frame.basis.get_column(1).length());
	Zone zone{ model.types.add(from_godot(node->get_type())), placed(frame, from_godot(node->get_polygon())), height, lot_id_above(node), false };
	if (!is_valid(id)) {
		node->link().set_id(int(index_of(model.add_zone(std::move(zone)))));
		_changes.has_new_zones = true;
		return;
	}
	const Zone &old = model.zone(id);
	if (old.is_removed || old.type != zone.type || std::abs(old.height - zone.height) > arm || !is_same(old.polygon, zone.polygon)) {
		model.put_zone(id, std::move(zone));
		_changes.has_new_zones = true;
	}
}

void CityEdits::take_in_object(PCGObject *node) {
	CityModel &model = _state->city.model;
	const ObjectId id = take_id<ObjectId>(node, node->link(), model.objects().size());
	const Transform3D frame = frame_of(node);
	CityObject object;
	object.type = model.types.add(from_godot(node->get_type()));
	object.position = from_godot(frame.get_origin());
	object.lot = lot_id_above(node);
	const TypedArray<Transform3D> places = node->get_places();
	for (int64_t i = 0; i < std::max<int64_t>(1, places.size()); ++i) {
		const Transform3D place = places.is_empty() ? frame : frame * Transform3D(places[i]);
		object.places.push_back({ from_godot(place.get_origin()), facing_of(place) });
	}
	set_footprint(node->get_instance_id(), placed(frame, node->footprint_corners()));
	if (!is_valid(id)) {
		node->link().set_id(int(index_of(model.add_object(std::move(object)))));
		return;
	}
	const CityObject &old = model.object(id);
	if (old.is_removed || old.type != object.type || !is_same(old.position, object.position) || !is_same(old.places, object.places)) {
		model.put_object(id, std::move(object));
	}
}

void CityEdits::set_footprint(uint64_t object, std::vector<glm::vec3> corners) {
	const auto known = _footprints.find(object);
	const bool is_same_as_before = known == _footprints.end() ? corners.empty() : is_same(known->second, corners);
	if (is_same_as_before) {
		return;
	}
	_changes.has_new_ground = true;
	if (corners.empty()) {
		_footprints.erase(known);
	} else {
		_footprints[object] = std::move(corners);
	}
}

void CityEdits::release(const Node *node) {
	if (const auto found = _bonds.find(node->get_instance_id()); found != _bonds.end()) {
		_nodes[size_t(found->second.kind)][found->second.id] = 0;
		_bonds.erase(found);
	}
	set_footprint(node->get_instance_id(), {});
}

void CityEdits::note_shown(const LotBuild &build) {
	const auto note_of = [this](Kind kind, const auto &ids) {
		const std::vector<uint64_t> &nodes = _nodes[size_t(kind)];
		for (const auto id : ids) {
			if (index_of(id) < nodes.size() && nodes[index_of(id)] != 0) {
				_noted.push_back(nodes[index_of(id)]);
			}
		}
	};
	note_of(Kind::Entrance, build.entrances);
	note_of(Kind::Zone, build.zones);
	note_of(Kind::Object, build.objects);
}

PCGLot *CityEdits::lot_node(LotId lot) const {
	PCGLot *found = nullptr;
	for (const auto &[object, place] : _lots) {
		PCGLot *node = place.lot == lot ? node_of<PCGLot>(object) : nullptr;
		found = node && (!found || found->is_greater_than(node)) ? node : found;
	}
	return found;
}

} // namespace pcg
