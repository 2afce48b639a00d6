#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/io/city_json.h"
#include "core/population/population.h"

// People as a table: a row for each person, columns `household`, `person`, `home` (building), `age` (years), `gender` (w or m) and `speed`
// (walking, m/s). Ids are whole numbers, as in the city's file. Rows of one household may stand anywhere; all have to tell one home.
// Columns that may be missing or empty: `first_name`, `family_name`, `hair` and `clothes`, each out of the lists in names.h. Family name and
// hair are the household's: all rows that tell them tell the same.
namespace pcg {

struct PopulationFile {
	Population population;
	FileIds household_ids, person_ids; // numbers of the table by dense id
};

// `building_ids`: the numbers of the city's file. Errors: a missing column, a bad or repeated number, a home that the city does not have.
Result<PopulationFile> parse_population(std::string_view text, std::string_view file, const FileIds &building_ids);
Result<PopulationFile> read_population(const std::string &path, const FileIds &building_ids);
// The same table with all columns, so that what was drawn or edited by hand comes back the same; homes are numbered as in `building_ids`, or by dense id without it.
std::string population_to_csv(const Population &population, const FileIds *building_ids = nullptr);

} // namespace pcg
