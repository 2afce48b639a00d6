#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/mesh.h"

namespace pcg {

// Materials of an OBJ file's library. What is unknown or wrong is read over. Pictures are sought beside the library, `path`.
std::vector<Material> parse_mtl(std::string_view text, const std::string &path);

} // namespace pcg
