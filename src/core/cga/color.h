#pragma once

#include <string_view>

#include <glm/vec4.hpp>

namespace pcg::cga {

// "#rrggbb" or "#rrggbbaa", the # may be missing. Without aa the opacity stays. False: it is none of these.
bool parse_color(std::string_view text, glm::vec4 &color);

} // namespace pcg::cga
