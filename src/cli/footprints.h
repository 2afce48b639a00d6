#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/diagnostic.h"
#include "core/cga/derivation.h"

namespace pcg::cli {

// Initial shapes of an OBJ file: what stands behind an `o` or `g` line is one shape of that name, and each face in front of the first such line is
// a shape of its own. Texture coordinates become those of set 0: streets bring u along and v across. Nothing, with errors, if the file is no
// footprint.
std::optional<std::vector<cga::InitialShape>> load_footprints(const std::string &path, Diagnostics &diagnostics);

} // namespace pcg::cli
