#pragma once

#include <initializer_list>
#include <utility>

#include "core/population/population.h"
#include "core/semantics/city_model.h"

namespace pcg::fuzz {

// Two homes and three other buildings on a street, a park with a bench; a family, a couple and an elder.
struct Street {
	CityModel city;
	Population population;

	Street() {
		float x = 0.0f;
		for (const char *type : { "house", "house", "school", "workplace", "shop" }) {
			Entrance entrance;
			entrance.building = city.add_building();
			entrance.type = city.types.add(type);
			entrance.position = { x += 100.0f, 0.0f, 0.0f };
			city.add_entrance(entrance);
		}
		Zone park;
		park.type = city.types.add("park");
		park.polygon = { { 0.0f, 0.0f, 50.0f }, { 0.0f, 0.0f, 90.0f }, { 40.0f, 0.0f, 90.0f } };
		city.add_zone(std::move(park));
		CityObject bench;
		bench.type = city.types.add("bench");
		bench.position = { 10.0f, 0.0f, 70.0f };
		bench.places = { { bench.position, { 0.0f, 0.0f, 1.0f } } };
		city.add_object(std::move(bench));
		add_household({ 40.0f, 38.0f, 6.0f, 10.0f });
		add_household({ 30.0f, 31.0f });
		add_household({ 70.0f });
	}

	void add_household(std::initializer_list<float> ages) {
		Household household;
		household.home = BuildingId(uint32_t(population.households.size() % 2));
		household.first_member = PersonId(uint32_t(population.persons.size()));
		household.member_count = uint16_t(ages.size());
		for (float age : ages) {
			Person person;
			person.household = HouseholdId(uint32_t(population.households.size()));
			person.age = age;
			population.persons.push_back(person);
		}
		population.households.push_back(household);
	}
};

} // namespace pcg::fuzz
