#pragma once

#include <string>

#include "core/base/diagnostic.h"
#include "core/sim/heat_map_image.h"

namespace pcg {

// The picture as a PNG file, there whole or not at all. False, with one error, if it could not be written.
bool write_png(const std::string &path, const RgbImage &image, Diagnostics &diagnostics);

} // namespace pcg
