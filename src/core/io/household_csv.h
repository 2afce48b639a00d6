#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/diagnostic.h"
#include "core/population/household_pattern.h"

// Household tables (paper, "Population"): a row for each kind of household, a descriptor and how often it occurs.
//
// Columns: `descriptor` (or household, household_type, type, composition) and `count` (or households, number, occurrences), in any order. Where
// one of `adults`, `elders`, `minors` is filled in, the columns tell the household and the descriptor is only its name, otherwise the
// descriptor is read. Numbers of persons may be open: "2+". Further columns, all optional: `women`, `men` (of the adults and elders),
// `min_age`, `max_age` (of the adults; else 18 or over), `adult_from` (age from which the table counts adults; 18). A table of a descriptor and a
// count only needs no line of names.
namespace pcg {

// Nothing after an error; each bad row is one, up to max_table_problems of them. A household of more than max_members is a warning, and left out.
std::optional<HouseholdTable> parse_household_table(std::string_view text, std::string_view file, Diagnostics &diagnostics);
std::optional<HouseholdTable> read_household_table(const std::string &path, Diagnostics &diagnostics);

} // namespace pcg
