#pragma once

#include <string_view>

#include <glm/vec2.hpp>

namespace pcg {

struct ImageInfo {
	glm::uvec2 size{ 0 }; // pixels; 0, 0: no picture that is known
	bool has_alpha = false;
};
// From the first bytes of a PNG, JPEG, TIFF, BMP, GIF or TGA file.
ImageInfo read_image_info(std::string_view bytes);

} // namespace pcg
