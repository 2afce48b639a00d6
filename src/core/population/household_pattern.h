#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/population/age_group.h"
#include "core/population/population.h"

// What the rows of a household table mean (paper, "Population": "one adult woman with two minor children" and how often it occurs).
namespace pcg {

// Some members alike. `is_open`: that many or more.
struct MemberGroup {
	uint8_t count = 0;
	bool is_open = false;
	enum class Sex : uint8_t { Any, Man, Woman } sex = Sex::Any;
	bool is_minor = false;
	// Whole years, both included.
	uint8_t min_age = adult_age;
	uint8_t max_age = 99;
};

struct HouseholdPattern {
	std::string descriptor; // as in the table
	double weight = 0.0; // occurrences, >= 0
	std::vector<MemberGroup> groups; // at least one member that is not a minor
	bool is_couple = false; // the first two adults are of an age
};

struct HouseholdTable {
	std::string file;
	std::vector<HouseholdPattern> patterns;
};

// Largest household that is drawn from an open pattern or accepted in a table.
constexpr int max_members = 20;

} // namespace pcg
