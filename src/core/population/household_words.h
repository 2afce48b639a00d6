#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/population/household_pattern.h"

namespace pcg {

// Reads an English descriptor: "One adult woman with two minor children", "Two adults aged 35+, one aged 16-34, no minors", "Male
// householder, no spouse/partner, living alone, 65 and over". `adult_from` is the age from which the table counts adults. The diagnostic
// says which words were not understood and has no place; weight stays 0. A household of more than max_members is a warning.
Result<HouseholdPattern> read_household_words(std::string_view descriptor, int adult_from = adult_age);

// The warning that a row of a table is left out.
Diagnostic too_large_household();

// One sentence with the words that are understood, for messages.
std::string_view understood_household_words();

} // namespace pcg
