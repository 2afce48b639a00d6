#include "core/population/crowded_homes.h"

#include <string>
#include <vector>

#include "core/population/home_finder.h"

namespace pcg {

void warn_of_crowded_homes(const Population &population, const CityModel &city, const FileNumbers &numbers, Diagnostics &diagnostics) {
	std::vector<uint64_t> persons(city.buildings().size());
	for (const Household &household : population.households) {
		if (index_of(household.home) < persons.size()) {
			persons[index_of(household.home)] += household.member_count;
		}
	}
	const TypeId type = city.types.find(population.home_type);
	BuildingId worst = BuildingId::Invalid;
	uint64_t excess = 0;
	size_t crowded = 0;
	for (const BuildingId home : city.buildings_of_type(type)) {
		const uint64_t capacity = home_capacity(city, home, type);
		if (persons[index_of(home)] > capacity) {
			++crowded;
			const bool is_worse = persons[index_of(home)] - capacity > excess;
			worst = is_worse ? home : worst;
			excess = is_worse ? persons[index_of(home)] - capacity : excess;
		}
	}
	if (crowded == 0) {
		return;
	}
	const uint64_t living = persons[index_of(worst)];
	std::string message = std::to_string(living) + " persons live in building " + number_text(numbers.buildings, worst) + ", which takes " +
			std::to_string(living - excess);
	message += crowded > 1 ? "; " + std::to_string(crowded - 1) + (crowded > 2 ? " more homes are too small" : " more home is too small") : "";
	diagnostics.warning("crowded-home", std::move(message), "move some of them elsewhere, or give the home a larger capacity");
}

} // namespace pcg
