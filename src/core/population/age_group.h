#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace pcg {

// Years.
constexpr int adult_age = 18; // the rules of the paper split at 18; tables may count adults from another age on
constexpr int elder_age = 65;

// The ages that the paper's figure of heat maps tells apart: under 18, under 65, and older.
constexpr std::array<std::string_view, 3> age_group_names{ "children", "adults", "elders" };

// Index of the above; `age` in years.
constexpr size_t age_group(float age) { return age < adult_age ? 0 : age < elder_age ? 1 : 2; }

} // namespace pcg
