#include <doctest/doctest.h>

#include "core/population/building_use.h"

using namespace pcg;

TEST_CASE("a block of flats is a house to who lives there and a shop to everybody else") {
	CityModel city;
	const auto add = [&](std::initializer_list<const char *> types) {
		const BuildingId id = city.add_building();
		for (const char *type : types) {
			Entrance entrance;
			entrance.building = id;
			entrance.type = city.types.add(type);
			city.add_entrance(entrance);
		}
		return id;
	};
	const BuildingId flats = add({ "shop", "house" });
	const BuildingId villa = add({ "house" });
	const BuildingId school = add({ "school" });
	const BuildingId ruin = add({});
	Population people;
	people.households = { { flats, PersonId(0), 1 }, { school, PersonId(1), 1 } };
	people.persons.resize(2);
	people.persons[0].household = HouseholdId(0);
	people.persons[1].household = HouseholdId(1);

	CHECK(building_use(city, people, PersonId(0), flats) == "house");
	CHECK(building_use(city, people, PersonId(1), flats) == "shop");
	CHECK(building_use(city, people, PersonId(0), villa) == "house");
	CHECK(building_use(city, people, PersonId(0), school) == "school");
	CHECK(building_use(city, people, PersonId(1), school) == "school"); // the caretaker's home has no door of its own
	CHECK(building_use(city, people, PersonId(0), ruin).empty());
	CHECK(building_use(city, people, PersonId(0), BuildingId::Invalid).empty());
	people.home_type = "shop";
	CHECK(building_use(city, people, PersonId(0), flats) == "shop");
	CHECK(building_use(city, people, PersonId(1), flats) == "house");
}
