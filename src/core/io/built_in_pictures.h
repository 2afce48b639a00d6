#pragma once

#include <optional>
#include <string_view>

#include <glm/vec2.hpp>

#include "core/io/picture.h"

// The pictures that CGA has without a file: "builtin:default", a checkerboard of 16 by 16 black and white fields, and "builtin:uvtest.png", whose fields
// tell where they lie. The latter is our own drawing.
namespace pcg {

// (0, 0): there is none of that name.
glm::uvec2 built_in_picture_size(std::string_view name);
std::optional<Picture> built_in_picture(std::string_view name);

} // namespace pcg
