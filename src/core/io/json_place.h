#pragma once

#include <cstddef>
#include <string_view>

namespace pcg {

// Where the value of a path such as "buildings[3].id" begins in a sound JSON text; of what is not there, where that begins which it should stand in.
size_t find_json_place(std::string_view text, std::string_view path);

} // namespace pcg
