#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace pcg {

// The ages that the paper's figure of heat maps tells apart: under 18, under 65, and older.
constexpr std::array<std::string_view, 3> age_group_names{ "children", "adults", "elders" };

// Index of the above; `age` in years.
constexpr size_t age_group(float age) { return age < 18.0f ? 0 : age < 65.0f ? 1 : 2; }

} // namespace pcg
