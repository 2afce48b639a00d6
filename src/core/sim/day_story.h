#pragma once

#include <string>
#include <vector>

#include "core/population/population.h"
#include "core/semantics/city_model.h"
#include "core/sim/lived_log.h"

// Lives in words, for people who read: "07:41 Ana (36) leaves home with Leo (8) and Mia (6) for the school".
namespace pcg {

// A household worth telling of: an adult walked with a child of the same household, the more walks and places the better; else whoever
// walked most. Invalid if the log is empty.
HouseholdId choose_household(const Population &population, const LivedLog &log);

// One line for each thing that happened to the household between two moments, in order of time.
std::vector<std::string> tell_day(const CityModel &city, const Population &population, const LivedLog &log, HouseholdId household,
		SimTime from, SimTime to);

} // namespace pcg
