#include "core/city/lot_semantics.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "core/city/lot_ground.h"
#include "core/semantics/city_query.h"

namespace pcg {

namespace {

constexpr float threshold_step = 0.25f;
constexpr float threshold_reach = 6.0f; // a porch or a deep doorway
constexpr float threshold_search = 3.0f;

// The walkable ground around a lot, as plain zones for the questions of city_query.
std::vector<Zone> walkable_around(const City &city, LotId lot) {
	std::vector<Zone> pieces;
	const auto add_free_ground = [&](LotId of) {
		for (std::vector<glm::vec3> &piece : lot_ground(city, of)) {
			pieces.push_back({ TypeId::Invalid, std::move(piece), 0.0f, lot, false });
		}
	};
	add_free_ground(lot);
	if (const LotId around = city.layout.lot(lot).around; is_valid(around)) {
		add_free_ground(around);
	}
	for (uint32_t i : city.layout.block(city.layout.lot(lot).block).pavements) {
		pieces.push_back({ TypeId::Invalid, city.layout.ground[i].polygon, 0.0f, lot, false });
	}
	return pieces;
}

bool is_walkable(const std::vector<Zone> &pieces, glm::vec3 point) {
	for (const Zone &piece : pieces) {
		if (contains(piece, point)) {
			return true;
		}
	}
	return false;
}

} // namespace

std::vector<ZoneId> add_zones(City &city, const cga::DerivationResult &model, LotId lot) {
	std::vector<ZoneId> ids;
	for (const cga::ModelZone &zone : model.zones) {
		ids.push_back(city.model.add_zone({ city.model.types.add(zone.type), zone.polygon, zone.height, lot, false }));
	}
	return ids;
}

std::vector<ObjectId> add_objects(City &city, const cga::DerivationResult &model, LotId lot) {
	std::vector<ObjectId> ids;
	for (const cga::ModelObject &object : model.objects) {
		CityObject record;
		record.type = city.model.types.add(object.tag);
		record.position = glm::vec3(object.frame[3]);
		record.lot = lot;
		for (const cga::ModelPlace &place : object.places) {
			record.places.push_back({ place.position, place.facing });
		}
		ids.push_back(city.model.add_object(std::move(record)));
	}
	return ids;
}

glm::vec3 threshold_of(const City &city, LotId lot, const cga::ModelEntrance &entrance) {
	const std::vector<Zone> pieces = walkable_around(city, lot);
	const glm::vec3 door{ entrance.position.x, city.layout.lot(lot).polygon[0].y, entrance.position.z };
	const glm::vec3 outwards{ entrance.facing.x, 0.0f, entrance.facing.z };
	for (float metres = 0.0f; metres <= threshold_reach; metres += threshold_step) {
		if (is_walkable(pieces, door + outwards * metres)) {
			return door + outwards * metres;
		}
	}
	glm::vec3 best = door;
	float best_distance = threshold_search;
	for (const Zone &piece : pieces) {
		const glm::vec3 candidate = nearest_point(piece, door);
		if (glm::distance(candidate, door) < best_distance) {
			best_distance = glm::distance(candidate, door);
			best = candidate;
		}
	}
	return best;
}

void unregister_lot(City &city, LotId lot) {
	LotBuild &build = city.lots[index_of(lot)];
	for (EntranceId id : build.entrances) {
		city.model.remove_entrance(id);
	}
	for (ZoneId id : build.zones) {
		city.model.remove_zone(id);
	}
	for (ObjectId id : build.objects) {
		city.model.remove_object(id);
	}
	build.entrances.clear();
	build.zones.clear();
	build.objects.clear();
}

void register_lot(City &city, LotId lot) {
	LotBuild &build = city.lots[index_of(lot)];
	const bool has_building = is_valid(build.building) && !city.model.building(build.building).is_removed;
	if (!build.model.entrances.empty() && !has_building) {
		build.building = city.model.add_building(lot);
	} else if (build.model.entrances.empty() && has_building && city.model.building(build.building).entrances.empty()) {
		city.model.remove_building(build.building);
		build.building = BuildingId::Invalid;
	}
	for (const cga::ModelEntrance &door : build.model.entrances) {
		Entrance entrance;
		entrance.building = build.building;
		entrance.type = city.model.types.add(door.type);
		entrance.position = threshold_of(city, lot, door);
		entrance.facing = door.facing;
		entrance.capacity = door.capacity;
		build.entrances.push_back(city.model.add_entrance(entrance));
	}
	build.zones = add_zones(city, build.model, lot);
	build.objects = add_objects(city, build.model, lot);
}

} // namespace pcg
