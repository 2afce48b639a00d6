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
	if (object.places.empty()) {
		object.places.push_back({ object.position, { 0.0f, 0.0f, 1.0f } });
	}
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
