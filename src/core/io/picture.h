#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

// Decoded pictures, and what files and engines want as one picture where rules name two.
namespace pcg {

struct Picture {
	glm::uvec2 size{ 0 };
	std::vector<uint8_t> pixels; // rows from the top; red, green, blue and alpha of each, one byte each
	bool has_alpha = false; // else alpha is 255 everywhere

	const uint8_t *pixel(glm::uvec2 at) const { return pixels.data() + (size_t(at.y) * size.x + at.x) * 4; }
};

// Of a PNG, JPEG, BMP, GIF or TGA file. Nothing if it is damaged, of another kind or larger than 2^26 pixels.
std::optional<Picture> decode_picture(std::string_view bytes);
// Empty if the picture is.
std::string encode_png(const Picture &picture);

// The colour of the one with the opacity of the other: of its alpha channel, or of its brightness where it has none. nullptr: white. As large as
// the larger of the two, the other one's pixels repeated.
Picture with_opacity(const Picture *color, const Picture &opacity);
// glTF's surface picture: the roughness in green, metal in blue, each from that channel of its own picture (all are equal in a grey one). nullptr: 1
// everywhere; at least one is there.
Picture metallic_roughness(const Picture *roughness, const Picture *metallic);

} // namespace pcg
