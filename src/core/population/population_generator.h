#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/diagnostic.h"
#include "core/base/parallel.h"
#include "core/population/home_finder.h"
#include "core/population/household_pattern.h"
#include "core/population/population.h"
#include "core/semantics/city_model.h"

namespace pcg {

struct PopulationOptions {
	uint64_t seed = 1;
	uint32_t persons = 0; // at least so many, as near as whole households come to it
	uint32_t households = 0; // used instead of `persons` if it is above 0
	std::string home_type = "house"; // type of the entrances of homes
	WorkOptions work; // progress in persons or households, as asked for; a cancelled draw gives nobody, and a warning
	uint32_t default_capacity = default_home_capacity; // persons in a building whose entrances of that type say 0
};

// Draws households in proportion to their occurrence and houses them by the capacity of the buildings (paper, "Population"). The n-th
// household depends on (seed, n) only. Whatever finds no home is left out, with a warning that tells both figures; that may be everybody. At least one
// member of every household is 18 or over.
Population generate_population(const HouseholdTable &table, const CityModel &city, const PopulationOptions &options, Diagnostics &diagnostics);

// How many households of each row of the table the same draw gives while homes have room for all of them. All 0 for a table in which none occurs.
std::vector<uint32_t> preview_households(const HouseholdTable &table, const PopulationOptions &options);

} // namespace pcg
