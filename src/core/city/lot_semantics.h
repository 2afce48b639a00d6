#pragma once

#include "core/city/city.h"

// From what a derivation says about a lot to records of the city's model.
namespace pcg {

// Where people stand before an entrance: from the door outwards to the first ground that can be walked on, of the lot or its pavements; where there is
// none along that line, the nearest such ground within 3 m; else the door itself.
glm::vec3 threshold_of(const City &city, LotId lot, const cga::ModelEntrance &entrance);

// Records for what a model means; `lot` may be Invalid, for streets.
std::vector<ZoneId> add_zones(City &city, const cga::DerivationResult &model, LotId lot);
std::vector<ObjectId> add_objects(City &city, const cga::DerivationResult &model, LotId lot);

// Takes what the lot's last model brought out of the city's model. What was added there by hand stays, and so does the building, without
// its generated entrances, so that a lot that is made anew keeps its residents' address.
void unregister_lot(City &city, LotId lot);
// Adds what the lot's new model says. Its building goes only if nothing leads into it any more.
void register_lot(City &city, LotId lot);

} // namespace pcg
