#include "core/io/image_info.h"

#include <algorithm>
#include <cstdint>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wsign-compare"
// The library's implementation lives in this file alone.
#define STBI_NO_STDIO
#define STB_IMAGE_IMPLEMENTATION
#include <stb_image.h>
#pragma GCC diagnostic pop

namespace pcg {

namespace {

// TIFF, which the library does not know: a list of tagged numbers, in either byte order.
class TiffHeader {
public:
	explicit TiffHeader(std::string_view bytes) : _bytes(bytes), _is_big_endian(bytes.starts_with("MM")) {}

	ImageInfo info() const {
		ImageInfo result;
		const size_t list = number(4, 4);
		const size_t count = number(list, 2);
		for (size_t i = 0; i < count; ++i) {
			const size_t entry = list + 2 + i * 12;
			const size_t tag = number(entry, 2), type = number(entry + 2, 2);
			if (tag == 256 || tag == 257) {
				result.size[tag == 256 ? 0 : 1] = number(entry + 8, type == 3 ? 2 : 4);
			}
			result.has_alpha |= tag == 338; // samples beside the colours
		}
		return result;
	}

private:
	// 0 outside of the bytes.
	uint32_t number(size_t at, size_t length) const {
		uint32_t result = 0;
		if (at > _bytes.size() || _bytes.size() - at < length) {
			return 0;
		}
		for (size_t i = 0; i < length; ++i) {
			result = result << 8 | uint8_t(_bytes[at + (_is_big_endian ? i : length - 1 - i)]);
		}
		return result;
	}

	std::string_view _bytes;
	bool _is_big_endian;
};

} // namespace

ImageInfo read_image_info(std::string_view bytes) {
	if (bytes.starts_with(std::string_view("II*\0", 4)) || bytes.starts_with(std::string_view("MM\0*", 4))) {
		return TiffHeader(bytes).info();
	}
	int width = 0, height = 0, channels = 0;
	const int size = int(std::min<size_t>(bytes.size(), 1u << 30));
	if (stbi_info_from_memory(reinterpret_cast<const stbi_uc *>(bytes.data()), size, &width, &height, &channels) == 0 || width < 0 || height < 0) {
		return {};
	}
	const bool is_gif = bytes.starts_with("GIF8"); // the library always gives it four channels
	return { { uint32_t(width), uint32_t(height) }, (channels == 2 || channels == 4) && !is_gif };
}

} // namespace pcg
