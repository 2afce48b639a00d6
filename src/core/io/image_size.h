#pragma once

#include <string_view>

#include <glm/vec2.hpp>

namespace pcg {

// Width and height in pixels from the first bytes of a PNG, JPEG, TIFF, BMP, GIF or TGA file; 0, 0: none of these.
glm::uvec2 image_size(std::string_view bytes);

} // namespace pcg
