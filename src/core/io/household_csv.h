#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/population/household_pattern.h"

// Household tables (paper, "Population"): a row for each kind of household, a descriptor and how often it occurs.
//
// Columns: `descriptor` (or household, household_type, type, composition) and `count` (or households, number, occurrences), in any order. Where
// one of `adults`, `elders`, `minors` is filled in, the columns tell the household and the descriptor is only its name, otherwise the
// descriptor is read. Numbers of persons may be open: "2+". Further columns, all optional: `women`, `men` (of the adults and elders),
// `min_age`, `max_age` (of the adults; else 18 or over), `adult_from` (age from which the table counts adults; 18).
namespace pcg {

Result<HouseholdTable> parse_household_table(std::string_view text, std::string_view file);
Result<HouseholdTable> read_household_table(const std::string &path);

} // namespace pcg
