#include <doctest/doctest.h>

#include "core/semantics/city_model.h"

using namespace pcg;

namespace {

EntranceId add_door(CityModel &city, BuildingId building, std::string_view type, uint32_t capacity) {
	Entrance entrance;
	entrance.building = building;
	entrance.type = city.types.add(type);
	entrance.capacity = capacity;
	return city.add_entrance(entrance);
}

} // namespace

TEST_CASE("a type has one id however often it is added") {
	TypeTable types;
	const TypeId shop = types.add("shop");
	CHECK(types.add("house") != shop);
	CHECK(types.add("shop") == shop);
	CHECK(types.find("shop") == shop);
	CHECK(types.name(shop) == "shop");
	CHECK(types.find("castle") == TypeId::Invalid);
	CHECK(types.name(TypeId::Invalid).empty());
	CHECK(types.size() == 2);
}

TEST_CASE("a copied type table does not depend on the first") {
	TypeTable copy;
	{
		TypeTable types;
		types.add("a type name that is too long for the small string buffer");
		copy = types;
	}
	CHECK(is_valid(copy.find("a type name that is too long for the small string buffer")));
}

TEST_CASE("a building is listed once under each type of its entrances, in order of ids") {
	CityModel city;
	const BuildingId first = city.add_building(), second = city.add_building();
	add_door(city, second, "house", 4);
	const EntranceId shop = add_door(city, first, "shop", 2);
	add_door(city, first, "house", 3);
	add_door(city, first, "house", 5);
	const TypeId house = city.types.find("house");
	CHECK(city.buildings_of_type(house) == std::vector<BuildingId>{ first, second });
	CHECK(city.buildings_of_type(city.types.find("shop")) == std::vector<BuildingId>{ first });
	CHECK(city.buildings_of_type(city.types.find("castle")).empty());
	CHECK(city.capacity(first, house) == 8);
	CHECK(city.entrance_of(first, city.types.find("shop")) == shop);
	CHECK(city.entrance_of(first, city.types.find("castle")) == shop);
}

TEST_CASE("removing entrances takes the building from the lists only with the last of the type") {
	CityModel city;
	const BuildingId building = city.add_building();
	const EntranceId a = add_door(city, building, "house", 1), b = add_door(city, building, "house", 1);
	const TypeId house = city.types.find("house");
	city.remove_entrance(a);
	CHECK(city.buildings_of_type(house).size() == 1);
	city.remove_entrance(b);
	CHECK(city.buildings_of_type(house).empty());
	CHECK(city.entrance_of(building) == EntranceId::Invalid);
	CHECK(city.entrance(a).is_removed);
}

TEST_CASE("every edit counts the revision up, and edits of what is not there change nothing") {
	CityModel city;
	const BuildingId building = city.add_building();
	const EntranceId door = add_door(city, building, "house", 1);
	uint64_t before = city.revision();
	city.move_entrance(door, { 1, 2, 3 }, { 1, 0, 0 });
	CHECK(city.revision() > before);
	city.remove_building(building);
	before = city.revision();
	city.remove_building(building);
	city.remove_entrance(door);
	city.move_entrance(EntranceId::Invalid, {}, {});
	city.move_object(ObjectId(7), {});
	city.remove_zone(ZoneId::Invalid);
	CHECK(city.revision() == before);
}

TEST_CASE("an object without places gets one where it stands, and places follow a moved object") {
	CityModel city;
	CityObject bench;
	bench.type = city.types.add("bench");
	bench.position = { 5, 0, 5 };
	const ObjectId plain = city.add_object(bench);
	REQUIRE(city.object(plain).places.size() == 1);
	CHECK(city.object(plain).places[0].position == glm::vec3(5, 0, 5));
	city.move_object(plain, { 7, 0, 4 });
	CHECK(city.object(plain).places[0].position == glm::vec3(7, 0, 4));
	city.remove_object(plain);
	CHECK(city.objects_of_type(bench.type).empty());
}

TEST_CASE("a record that is put under its id replaces the one that is there, or brings it back") {
	CityModel city;
	const BuildingId building = city.add_building(LotId(3)), other = city.add_building();
	const EntranceId door = add_door(city, building, "house", 4);
	const TypeId house = city.types.find("house"), shop = city.types.add("shop"), bench = city.types.add("bench");
	city.put_entrance(door, { other, shop, { 1, 0, 2 }, { 1, 0, 0 }, 7, false });
	CHECK(city.buildings_of_type(house).empty());
	CHECK(city.buildings_of_type(shop) == std::vector<BuildingId>{ other });
	CHECK(city.building(building).entrances.empty());
	CHECK(city.capacity(other, shop) == 7);
	const ObjectId object = city.add_object({ bench, { 5, 0, 5 }, {}, LotId::Invalid, false });
	city.remove_object(object);
	const uint64_t before = city.revision();
	city.put_object(object, { bench, { 6, 0, 5 }, {}, LotId::Invalid, false });
	CHECK(city.revision() > before);
	CHECK(city.objects_of_type(bench) == std::vector<ObjectId>{ object });
	CHECK(city.object(object).places[0].position == glm::vec3(6, 0, 5));
	city.put_object(ObjectId(9), { bench, {}, {}, LotId::Invalid, false });
	CHECK(city.objects().size() == 1);
}

TEST_CASE("reserved ids name removed records until something is put there") {
	CityModel city;
	const TypeId park = city.types.add("park"), house = city.types.add("house");
	city.reserve_ids(2, 2, 3, 1);
	CHECK(city.buildings().size() == 2);
	CHECK(city.building(BuildingId(1)).is_removed);
	CHECK(city.zones_of_type(park).empty());
	city.put_building(BuildingId(1), LotId(5));
	city.put_entrance(EntranceId(1), { BuildingId(1), house, {}, { 0, 0, 1 }, 2, false });
	city.put_zone(ZoneId(2), { park, {}, 3.0f, LotId(5), false });
	CHECK(city.buildings_of_type(house) == std::vector<BuildingId>{ BuildingId(1) });
	CHECK(city.entrance_of(BuildingId(1)) == EntranceId(1));
	CHECK(city.zones_of_type(park) == std::vector<ZoneId>{ ZoneId(2) });
	CHECK(city.objects()[0].is_removed);
	city.reserve_ids(1, 1, 1, 1);
	CHECK(city.zones().size() == 3);
}
