#pragma once

#include <string_view>

#include "core/population/population.h"
#include "core/semantics/city_model.h"

namespace pcg {

// What a building is to a person, as a type of entrance: its own home is of the type that homes have, any other building of the first type that
// homes do not have (a block of flats with a shop below is the shop to who does not live there). The first type of what has no such entrance,
// "" of what has none at all.
std::string_view building_use(const CityModel &city, const Population &population, PersonId person, BuildingId building);

} // namespace pcg
