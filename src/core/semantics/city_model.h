#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/ids.h"

// What a city means: entrances, zones and objects that people can use. The only bridge between the city and its people (paper, "City
// semantics"). Plain records; ids are indices and stay valid, removed records keep their place with `is_removed` set.
// Units: metres, y up, -z north.
namespace pcg {

// Names of entrance, zone and object types; one table, so that a TypeId means one word.
class TypeTable {
public:
	TypeId add(std::string_view name); // the existing id if the name is known
	TypeId find(std::string_view name) const; // Invalid if unknown
	std::string_view name(TypeId id) const;
	size_t size() const { return _names.size(); }

private:
	std::deque<std::string> _names;
	std::map<std::string, TypeId, std::less<>> _ids;
};

// A typed door (paper, "entrance"). People walk to `position` and vanish into the building.
struct Entrance {
	BuildingId building = BuildingId::Invalid;
	TypeId type = TypeId::Invalid;
	glm::vec3 position{ 0.0f }; // on walkable ground, before the threshold
	glm::vec3 facing{ 0.0f, 0.0f, 1.0f }; // unit, out of the building
	uint32_t capacity = 0; // persons that live or work behind it; 0 = not said
	bool is_removed = false;
};

// What one or more entrances of a lot lead into.
struct Building {
	LotId lot = LotId::Invalid;
	std::vector<EntranceId> entrances;
	bool is_removed = false;
};

// A typed prism of interest (paper, "zone"): `polygon` is its ground outline, counter-clockwise seen from above, raised by `height`.
struct Zone {
	TypeId type = TypeId::Invalid;
	std::vector<glm::vec3> polygon;
	float height = 0.0f;
	LotId lot = LotId::Invalid;
	bool is_removed = false;
};

// Where and how one person uses an object: a seat of a bench.
struct Place {
	glm::vec3 position{ 0.0f };
	glm::vec3 facing{ 0.0f, 0.0f, 1.0f }; // unit
};

// A tagged subtree that people can use (paper, "@Object").
struct CityObject {
	TypeId type = TypeId::Invalid;
	glm::vec3 position{ 0.0f };
	std::vector<Place> places; // at least one
	LotId lot = LotId::Invalid;
	bool is_removed = false;
};

class CityModel {
public:
	TypeTable types;
	// Tells cities apart by what they were generated from; edits leave it as it is. 0: not generated.
	uint64_t origin = 0;

	BuildingId add_building(LotId lot = LotId::Invalid);
	EntranceId add_entrance(Entrance entrance); // of an existing building
	ZoneId add_zone(Zone zone);
	ObjectId add_object(CityObject object); // gets one place at its position if it has none

	// Edits by hand. Each counts `revision` up; whoever caches something derived compares it. Ids that name nothing are ignored.
	void move_entrance(EntranceId id, glm::vec3 position, glm::vec3 facing);
	void move_zone(ZoneId id, std::vector<glm::vec3> polygon, float height);
	void move_object(ObjectId id, glm::vec3 position); // its places come along
	void remove_entrance(EntranceId id);
	void remove_zone(ZoneId id);
	void remove_object(ObjectId id);
	void remove_building(BuildingId id); // and its entrances
	// Replaces all that the record says, or brings it back if it is removed.
	void put_building(BuildingId id, LotId lot);
	void put_entrance(EntranceId id, Entrance entrance); // of an existing building
	void put_zone(ZoneId id, Zone zone);
	void put_object(ObjectId id, CityObject object);
	// Sees that so many ids exist; new ones name removed records, which put_..() may fill: so a city is read back under the ids that it had.
	void reserve_ids(size_t buildings, size_t entrances, size_t zones, size_t objects);
	uint64_t revision() const { return _revision; }

	const std::vector<Building> &buildings() const { return _buildings; }
	const std::vector<Entrance> &entrances() const { return _entrances; }
	const std::vector<Zone> &zones() const { return _zones; }
	const std::vector<CityObject> &objects() const { return _objects; }
	const Building &building(BuildingId id) const { return _buildings[index_of(id)]; }
	const Entrance &entrance(EntranceId id) const { return _entrances[index_of(id)]; }
	const Zone &zone(ZoneId id) const { return _zones[index_of(id)]; }
	const CityObject &object(ObjectId id) const { return _objects[index_of(id)]; }

	// Buildings with an entrance of the type, in order of id, without removed ones. An unknown type has none.
	const std::vector<BuildingId> &buildings_of_type(TypeId type) const;
	const std::vector<ObjectId> &objects_of_type(TypeId type) const;
	const std::vector<ZoneId> &zones_of_type(TypeId type) const;
	// The first entrance of the type, else the first of the building; Invalid if it has none left.
	EntranceId entrance_of(BuildingId building, TypeId type = TypeId::Invalid) const;
	// Sum over the building's entrances of the type.
	uint32_t capacity(BuildingId building, TypeId type) const;

private:
	void index_building(BuildingId building, TypeId type);
	void unindex_building(BuildingId building, TypeId type);

	std::vector<Building> _buildings;
	std::vector<Entrance> _entrances;
	std::vector<Zone> _zones;
	std::vector<CityObject> _objects;
	std::vector<std::vector<BuildingId>> _buildings_of_type; // by TypeId, sorted, as are the next two
	std::vector<std::vector<ObjectId>> _objects_of_type;
	std::vector<std::vector<ZoneId>> _zones_of_type;
	uint64_t _revision = 0;
};

} // namespace pcg
