#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/diagnostic.h"

// Wavefront OBJ as far as footprints need it: faces as polygons. Normals, texture coordinates, groups and materials are read over.
namespace pcg {

struct ObjPolygons {
	std::vector<std::vector<glm::dvec3>> faces; // as the file has them: three corners or more, in its units
};

// Nothing, and errors with their lines, if a vertex or a face is wrong or if there is no face at all. `file` is the name shown in diagnostics.
std::optional<ObjPolygons> parse_obj(std::string_view text, const std::string &file, Diagnostics &diagnostics);
std::optional<ObjPolygons> load_obj(const std::string &path, Diagnostics &diagnostics);

} // namespace pcg
