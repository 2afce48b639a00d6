#include "core/population/home_finder.h"

#include <algorithm>

namespace pcg {

namespace {

constexpr size_t none = SIZE_MAX;

} // namespace

uint32_t home_capacity(const CityModel &city, BuildingId building, TypeId home_type, uint32_t default_capacity) {
	const uint32_t told = city.capacity(building, home_type);
	return told > 0 ? told : default_capacity;
}

HomeFinder::HomeFinder(const CityModel &city, std::string_view home_type, uint32_t default_capacity) {
	const TypeId type = city.types.find(home_type);
	_homes = city.buildings_of_type(type);
	while (_leaf_count < _homes.size()) {
		_leaf_count *= 2;
	}
	_most_free.assign(2 * _leaf_count, 0);
	for (size_t i = 0; i < _homes.size(); ++i) {
		const uint32_t capacity = home_capacity(city, _homes[i], type, default_capacity);
		_total += capacity;
		_end_of.push_back(_total);
		_most_free[_leaf_count + i] = capacity;
	}
	_free = _total;
	_largest = _homes.empty() ? 0 : *std::max_element(_most_free.begin(), _most_free.end());
	for (size_t node = _leaf_count - 1; node >= 1; --node) {
		_most_free[node] = std::max(_most_free[2 * node], _most_free[2 * node + 1]);
	}
}

// The first home from `from` on with room, below `node`, whose leaves are first .. last - 1.
size_t HomeFinder::find_room(size_t node, size_t first, size_t last, size_t from, uint32_t persons) const {
	if (last <= from || _most_free[node] < persons) {
		return none;
	}
	if (last - first == 1) {
		return first;
	}
	const size_t middle = first + (last - first) / 2;
	const size_t left = find_room(2 * node, first, middle, from, persons);
	return left != none ? left : find_room(2 * node + 1, middle, last, from, persons);
}

BuildingId HomeFinder::take(Random &random, uint32_t persons) {
	if (_homes.empty() || persons == 0 || persons > _free) {
		return BuildingId::Invalid;
	}
	const uint64_t place = random.index(size_t(_total));
	const size_t start = size_t(std::upper_bound(_end_of.begin(), _end_of.end(), place) - _end_of.begin());
	size_t home = find_room(1, 0, _leaf_count, start, persons);
	if (home == none) {
		home = find_room(1, 0, _leaf_count, 0, persons);
	}
	if (home == none) {
		return BuildingId::Invalid;
	}
	_free -= persons;
	size_t node = _leaf_count + home;
	_most_free[node] -= persons;
	for (node /= 2; node >= 1; node /= 2) {
		_most_free[node] = std::max(_most_free[2 * node], _most_free[2 * node + 1]);
	}
	return _homes[home];
}

} // namespace pcg
