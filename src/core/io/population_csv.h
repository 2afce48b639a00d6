#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/diagnostic.h"
#include "core/base/file_ids.h"
#include "core/population/population.h"

// People as a table: a row for each person, columns `household`, `person`, `home` (building), `age` (years), `gender` (w or m) and `speed`
// (walking, m/s). Ids are whole numbers, those of homes as in the city's file,
// others 0 or larger. Rows of one household may stand anywhere; all have to tell one home.
// Columns that may be missing or empty: `first_name` and `family_name`, any, and `hair` and `clothes`, out of the lists in names.h. Family name
// and hair are the household's: the first row that tells them does so for all.
namespace pcg {

struct PopulationFile {
	Population population;
	FileIds household_ids, person_ids; // numbers of the table by dense id
};

// `building_ids`: the numbers of the city's file; null: of no city yet, and nobody has a home. Nothing after an error: a missing column, a bad or repeated
// number, a home that the city does not have; every bad cell is one, up to max_table_problems of them. Warnings: a color that is none, which is drawn
// instead; a family name or hair other than that of the household; a household of more than max_household_size members, which loses the others.
std::optional<PopulationFile> parse_population(std::string_view text, std::string_view file, const FileIds *building_ids, Diagnostics &diagnostics);
std::optional<PopulationFile> read_population(const std::string &path, const FileIds *building_ids, Diagnostics &diagnostics);
// The same table with all columns, so that what was drawn or edited by hand comes back the same.
std::string population_to_csv(const Population &population, const FileNumbers &numbers = {});

} // namespace pcg
