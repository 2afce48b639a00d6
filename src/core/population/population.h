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
	uint32_t name = 0; // see first_name() in names.h
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
	uint32_t family_name = 0; // see family_name() in names.h
	uint8_t hair_color = 0; // index in hair_colors(); shared by the members, as in the paper
};

constexpr uint32_t max_household_size = 0xFFFF; // members; far more than anybody lives with

struct Population {
	std::vector<Person> persons;
	std::vector<Household> households;
	std::vector<std::string> names; // of persons and families, that the lists of names.h lack
	std::string home_type = "house"; // of the entrances of homes

	// Households in order of id, their members one behind the other.
	const Person &person(PersonId id) const { return persons[index_of(id)]; }
	const Household &household(HouseholdId id) const { return households[index_of(id)]; }
	BuildingId home_of(PersonId id) const { return household(person(id).household).home; }
};

// More households behind the others, numbered on from them.
void append_population(Population &population, const Population &more);

} // namespace pcg
