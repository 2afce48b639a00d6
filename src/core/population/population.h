#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/ids.h"

// Who lives in the city: households and their members (paper, "Population"). Plain arrays; a PersonId is an index into `persons`.
namespace pcg {

enum class Gender : uint8_t { Man, Woman };

// Whole of a person's lasting data: 24 bytes.
struct Person {
	HouseholdId household = HouseholdId::Invalid;
	uint32_t name = 0; // index in first_names(gender), see names.h
	float walking_speed = 1.3f; // m/s, > 0
	float age = 30.0f; // years
	Gender gender = Gender::Woman;
	uint8_t clothes_color = 0; // index in clothes_colors()
	uint16_t reserved = 0;
};

// Members are consecutive persons: first_member .. first_member + member_count - 1.
struct Household {
	BuildingId home = BuildingId::Invalid;
	PersonId first_member = PersonId::Invalid;
	uint16_t member_count = 0;
	uint16_t pattern = 0; // row of the household table that it was drawn from
	uint16_t family_name = 0; // index in family_names()
	uint8_t hair_color = 0; // index in hair_colors(); shared by the members, as in the paper
};

struct Population {
	std::vector<Person> persons;
	std::vector<Household> households;
	std::string home_type = "house"; // of the entrances of homes

	// Households in order of id, their members one behind the other.
	const Person &person(PersonId id) const { return persons[index_of(id)]; }
	const Household &household(HouseholdId id) const { return households[index_of(id)]; }
	BuildingId home_of(PersonId id) const { return household(person(id).household).home; }
};

// More households behind the others, numbered on from them.
inline void append_population(Population &population, const Population &more) {
	const auto first_household = uint32_t(population.households.size()), first_person = uint32_t(population.persons.size());
	for (Household household : more.households) {
		household.first_member = PersonId(index_of(household.first_member) + first_person);
		population.households.push_back(household);
	}
	for (Person person : more.persons) {
		person.household = HouseholdId(index_of(person.household) + first_household);
		population.persons.push_back(person);
	}
}

} // namespace pcg
