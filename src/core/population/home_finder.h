#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/base/random.h"
#include "core/semantics/city_model.h"

namespace pcg {

constexpr uint32_t default_home_capacity = 4; // persons, where the entrances of a building say none

// Persons who live in this building at most; it has an entrance of `home_type`.
uint32_t home_capacity(const CityModel &city, BuildingId building, TypeId home_type, uint32_t default_capacity = default_home_capacity);

// Free places to live, building by building. Large buildings are found more often, in proportion to their capacity.
class HomeFinder {
public:
	// Buildings with an entrance of `home_type`; one whose entrances say no capacity houses `default_capacity` persons.
	HomeFinder(const CityModel &city, std::string_view home_type, uint32_t default_capacity);

	bool is_empty() const { return _homes.empty(); } // the city has no homes at all
	uint64_t total() const { return _total; } // persons that all homes together house
	uint64_t free() const { return _free; }
	uint32_t most_free() const { return _most_free[1]; } // places in the home that has most of them left
	uint32_t largest() const { return _largest; } // capacity of the largest home when it was empty
	// A building with room for so many persons, which are taken off it; Invalid if there is none.
	BuildingId take(Random &random, uint32_t persons);

private:
	size_t find_room(size_t node, size_t first, size_t last, size_t from, uint32_t persons) const;

	std::vector<BuildingId> _homes;
	std::vector<uint64_t> _end_of; // running sum of capacities
	size_t _leaf_count = 1;
	std::vector<uint32_t> _most_free; // a tree of maxima: children of i at 2i and 2i + 1, leaves at _leaf_count + home
	uint64_t _total = 0;
	uint64_t _free = 0;
	uint32_t _largest = 0;
};

} // namespace pcg
