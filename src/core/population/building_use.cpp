#include "core/population/building_use.h"

namespace pcg {

std::string_view building_use(const CityModel &city, const Population &population, PersonId person, BuildingId building) {
	if (index_of(building) >= city.buildings().size()) {
		return {};
	}
	const TypeId home_type = city.types.find(population.home_type);
	const bool lives_there = population.home_of(person) == building;
	for (EntranceId id : city.building(building).entrances) {
		const Entrance &entrance = city.entrance(id);
		if (!entrance.is_removed && (entrance.type == home_type) == lives_there) {
			return city.types.name(entrance.type);
		}
	}
	const EntranceId first = city.entrance_of(building);
	return is_valid(first) ? city.types.name(city.entrance(first).type) : std::string_view();
}

} // namespace pcg
