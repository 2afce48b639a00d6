#include "core/semantics/city_model.h"

#include <algorithm>
#include <cassert>

namespace pcg {

namespace {

template <typename Id> void insert_sorted(std::vector<std::vector<Id>> &lists, TypeId type, Id id) {
	if (!is_valid(type)) {
		return;
	}
	if (lists.size() <= index_of(type)) {
		lists.resize(index_of(type) + 1);
	}
	std::vector<Id> &list = lists[index_of(type)];
	const auto place = std::lower_bound(list.begin(), list.end(), id);
	if (place == list.end() || *place != id) {
		list.insert(place, id);
	}
}

template <typename Id> void erase_sorted(std::vector<std::vector<Id>> &lists, TypeId type, Id id) {
	if (index_of(type) >= lists.size()) {
		return;
	}
	std::vector<Id> &list = lists[index_of(type)];
	const auto place = std::lower_bound(list.begin(), list.end(), id);
	if (place != list.end() && *place == id) {
		list.erase(place);
	}
}

template <typename Id> const std::vector<Id> &list_of(const std::vector<std::vector<Id>> &lists, TypeId type) {
	static const std::vector<Id> none;
	return index_of(type) < lists.size() ? lists[index_of(type)] : none;
}

void give_place(CityObject &object) {
	if (object.places.empty()) {
		object.places.push_back({ object.position, { 0.0f, 0.0f, 1.0f } });
	}
}

template <typename Id, typename Record> bool is_present(const std::vector<Record> &records, Id id) {
	return index_of(id) < records.size() && !records[index_of(id)].is_removed;
}

} // namespace

BuildingId CityModel::add_building(LotId lot) {
	++_revision;
	const BuildingId id = BuildingId(_buildings.size());
	_buildings.push_back({ lot, {}, false });
	return id;
}

EntranceId CityModel::add_entrance(Entrance entrance) {
	assert(is_present(_buildings, entrance.building));
	++_revision;
	const EntranceId id = EntranceId(_entrances.size());
	_buildings[index_of(entrance.building)].entrances.push_back(id);
	index_building(entrance.building, entrance.type);
	_entrances.push_back(entrance);
	return id;
}

ZoneId CityModel::add_zone(Zone zone) {
	++_revision;
	const ZoneId id = ZoneId(_zones.size());
	insert_sorted(_zones_of_type, zone.type, id);
	_zones.push_back(std::move(zone));
	return id;
}

ObjectId CityModel::add_object(CityObject object) {
	++_revision;
	const ObjectId id = ObjectId(_objects.size());
	give_place(object);
	insert_sorted(_objects_of_type, object.type, id);
	_objects.push_back(std::move(object));
	return id;
}

void CityModel::move_entrance(EntranceId id, glm::vec3 position, glm::vec3 facing) {
	if (is_present(_entrances, id)) {
		++_revision;
		_entrances[index_of(id)].position = position;
		_entrances[index_of(id)].facing = facing;
	}
}

void CityModel::move_zone(ZoneId id, std::vector<glm::vec3> polygon, float height) {
	if (is_present(_zones, id)) {
		++_revision;
		_zones[index_of(id)].polygon = std::move(polygon);
		_zones[index_of(id)].height = height;
	}
}

void CityModel::move_object(ObjectId id, glm::vec3 position) {
	if (!is_present(_objects, id)) {
		return;
	}
	++_revision;
	CityObject &object = _objects[index_of(id)];
	for (Place &place : object.places) {
		place.position += position - object.position;
	}
	object.position = position;
}

void CityModel::remove_entrance(EntranceId id) {
	if (!is_present(_entrances, id)) {
		return;
	}
	++_revision;
	Entrance &entrance = _entrances[index_of(id)];
	entrance.is_removed = true;
	std::erase(_buildings[index_of(entrance.building)].entrances, id);
	unindex_building(entrance.building, entrance.type);
}

void CityModel::remove_zone(ZoneId id) {
	if (is_present(_zones, id)) {
		++_revision;
		_zones[index_of(id)].is_removed = true;
		erase_sorted(_zones_of_type, _zones[index_of(id)].type, id);
	}
}

void CityModel::remove_object(ObjectId id) {
	if (is_present(_objects, id)) {
		++_revision;
		_objects[index_of(id)].is_removed = true;
		erase_sorted(_objects_of_type, _objects[index_of(id)].type, id);
	}
}

void CityModel::remove_building(BuildingId id) {
	if (!is_present(_buildings, id)) {
		return;
	}
	++_revision;
	const std::vector<EntranceId> entrances = _buildings[index_of(id)].entrances;
	for (EntranceId entrance : entrances) {
		remove_entrance(entrance);
	}
	_buildings[index_of(id)].is_removed = true;
}

void CityModel::put_building(BuildingId id, LotId lot) {
	if (index_of(id) < _buildings.size()) {
		++_revision;
		_buildings[index_of(id)].lot = lot;
		_buildings[index_of(id)].is_removed = false;
	}
}

void CityModel::put_entrance(EntranceId id, Entrance entrance) {
	if (index_of(id) >= _entrances.size()) {
		return;
	}
	assert(is_present(_buildings, entrance.building));
	remove_entrance(id);
	++_revision;
	entrance.is_removed = false;
	_buildings[index_of(entrance.building)].entrances.push_back(id);
	_entrances[index_of(id)] = entrance;
	index_building(entrance.building, entrance.type);
}

void CityModel::put_zone(ZoneId id, Zone zone) {
	if (index_of(id) >= _zones.size()) {
		return;
	}
	remove_zone(id);
	++_revision;
	zone.is_removed = false;
	insert_sorted(_zones_of_type, zone.type, id);
	_zones[index_of(id)] = std::move(zone);
}

void CityModel::put_object(ObjectId id, CityObject object) {
	if (index_of(id) >= _objects.size()) {
		return;
	}
	remove_object(id);
	++_revision;
	object.is_removed = false;
	give_place(object);
	insert_sorted(_objects_of_type, object.type, id);
	_objects[index_of(id)] = std::move(object);
}

void CityModel::reserve_ids(size_t buildings, size_t entrances, size_t zones, size_t objects) {
	++_revision;
	Entrance entrance;
	Zone zone;
	CityObject object;
	entrance.is_removed = zone.is_removed = object.is_removed = true;
	_buildings.resize(std::max(_buildings.size(), buildings), { LotId::Invalid, {}, true });
	_entrances.resize(std::max(_entrances.size(), entrances), entrance);
	_zones.resize(std::max(_zones.size(), zones), zone);
	_objects.resize(std::max(_objects.size(), objects), object);
}

const std::vector<BuildingId> &CityModel::buildings_of_type(TypeId type) const {
	return list_of(_buildings_of_type, type);
}

const std::vector<ObjectId> &CityModel::objects_of_type(TypeId type) const { return list_of(_objects_of_type, type); }

const std::vector<ZoneId> &CityModel::zones_of_type(TypeId type) const { return list_of(_zones_of_type, type); }

EntranceId CityModel::entrance_of(BuildingId building, TypeId type) const {
	if (index_of(building) >= _buildings.size()) {
		return EntranceId::Invalid;
	}
	const std::vector<EntranceId> &entrances = _buildings[index_of(building)].entrances;
	for (EntranceId id : entrances) {
		if (_entrances[index_of(id)].type == type) {
			return id;
		}
	}
	return entrances.empty() ? EntranceId::Invalid : entrances.front();
}

uint32_t CityModel::capacity(BuildingId building, TypeId type) const {
	uint32_t sum = 0;
	if (index_of(building) < _buildings.size()) {
		for (EntranceId id : _buildings[index_of(building)].entrances) {
			sum += entrance(id).type == type ? entrance(id).capacity : 0;
		}
	}
	return sum;
}

void CityModel::index_building(BuildingId building, TypeId type) {
	insert_sorted(_buildings_of_type, type, building);
}

void CityModel::unindex_building(BuildingId building, TypeId type) {
	for (EntranceId id : _buildings[index_of(building)].entrances) {
		if (entrance(id).type == type) {
			return;
		}
	}
	erase_sorted(_buildings_of_type, type, building);
}

} // namespace pcg
