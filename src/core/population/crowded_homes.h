#pragma once

#include "core/base/diagnostic.h"
#include "core/base/file_ids.h"
#include "core/population/population.h"
#include "core/semantics/city_model.h"

namespace pcg {

// For people who were given homes by hand: one warning, with both figures of the most crowded, if homes house more persons than they take. Everybody
// lives where he was put.
void warn_of_crowded_homes(const Population &population, const CityModel &city, const FileNumbers &numbers, Diagnostics &diagnostics);

} // namespace pcg
