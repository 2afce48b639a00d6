#include "core/io/picture.h"

#include <algorithm>

#include <glm/common.hpp>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#define STBI_NO_STDIO
#include <stb_image.h>
#define STBI_WRITE_NO_STDIO
#include <stb_image_write.h>
#pragma GCC diagnostic pop

#include "core/io/image_info.h"

namespace pcg {

namespace {

constexpr uint64_t most_pixels = uint64_t(1) << 26;

// Fills a picture as large as the larger of the two. `mix` writes a pixel from those of the two at its place; nullptr where there is no picture.
template <typename Mix> Picture mixed(const Picture *a, const Picture *b, Mix mix) {
	Picture result;
	result.size = glm::max(a != nullptr ? a->size : glm::uvec2(0), b != nullptr ? b->size : glm::uvec2(0));
	result.pixels.resize(size_t(result.size.x) * result.size.y * 4);
	const auto at = [&](const Picture *picture, glm::uvec2 place) {
		return picture != nullptr ? picture->pixel(glm::uvec2(glm::u64vec2(place) * glm::u64vec2(picture->size) / glm::u64vec2(result.size))) : nullptr;
	};
	uint8_t *out = result.pixels.data();
	for (uint32_t y = 0; y < result.size.y; ++y) {
		for (uint32_t x = 0; x < result.size.x; ++x, out += 4) {
			mix(out, at(a, { x, y }), at(b, { x, y }));
		}
	}
	return result;
}

} // namespace

std::optional<Picture> decode_picture(std::string_view bytes) {
	const ImageInfo info = read_image_info(bytes);
	if (info.size.x == 0 || info.size.y == 0 || uint64_t(info.size.x) * info.size.y > most_pixels || bytes.size() > (1u << 30)) {
		return std::nullopt;
	}
	int width = 0, height = 0, channels = 0;
	stbi_uc *pixels = stbi_load_from_memory(reinterpret_cast<const stbi_uc *>(bytes.data()), int(bytes.size()), &width, &height, &channels, 4);
	if (pixels == nullptr) {
		return std::nullopt;
	}
	Picture picture{ { uint32_t(width), uint32_t(height) }, {}, info.has_alpha };
	picture.pixels.assign(pixels, pixels + size_t(width) * size_t(height) * 4);
	stbi_image_free(pixels);
	return picture;
}

std::string encode_png(const Picture &picture) {
	std::string bytes;
	const auto append = [](void *context, void *data, int size) {
		static_cast<std::string *>(context)->append(static_cast<const char *>(data), size_t(size));
	};
	if (!picture.pixels.empty()) {
		stbi_write_png_to_func(append, &bytes, int(picture.size.x), int(picture.size.y), 4, picture.pixels.data(), int(picture.size.x) * 4);
	}
	return bytes;
}

Picture with_opacity(const Picture *color, const Picture &opacity) {
	Picture result = mixed(color, &opacity, [&](uint8_t *out, const uint8_t *a, const uint8_t *b) {
		for (int i = 0; i < 3; ++i) {
			out[i] = a != nullptr ? a[i] : 255;
		}
		const uint32_t brightness = (299u * b[0] + 587u * b[1] + 114u * b[2] + 500u) / 1000u; // ITU-R BT.601
		out[3] = opacity.has_alpha ? b[3] : uint8_t(brightness);
	});
	result.has_alpha = true;
	return result;
}

Picture metallic_roughness(const Picture *roughness, const Picture *metallic) {
	return mixed(roughness, metallic, [](uint8_t *out, const uint8_t *a, const uint8_t *b) {
		out[0] = out[3] = 255;
		out[1] = a != nullptr ? a[1] : 255;
		out[2] = b != nullptr ? b[2] : 255;
	});
}

} // namespace pcg
