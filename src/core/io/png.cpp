#include "core/io/png.h"

#include "core/io/atomic_file.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
// The library's implementation lives in this file alone.
#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>
#pragma GCC diagnostic pop

namespace pcg {

bool write_png(const std::string &path, const RgbImage &image, Diagnostics &diagnostics) {
	std::string bytes;
	const auto append = [](void *context, void *data, int size) {
		static_cast<std::string *>(context)->append(static_cast<const char *>(data), size_t(size));
	};
	const int stride = int(image.width) * 3;
	if (image.pixels.empty() || stbi_write_png_to_func(append, &bytes, int(image.width), int(image.height), 3, image.pixels.data(), stride) == 0) {
		diagnostics.error("picture-failed", "the picture '" + path + "' could not be encoded", "give it a size above 0");
		return false;
	}
	return write_file(path, bytes, diagnostics);
}

} // namespace pcg
