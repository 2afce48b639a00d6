#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/base/diagnostic.h"

// Wavefront OBJ: faces stay the polygons that they are. Curves, lines and points are read over. The usual libraries triangulate, give up at
// the first wrong line or have no line to tell, which is why this one is ours.
namespace pcg {

struct ObjModel {
	static constexpr uint32_t none = 0xFFFFFFFF;

	struct Corner {
		uint32_t position = 0;
		uint32_t uv = none;
		uint32_t normal = none;
	};
	struct Face {
		uint32_t first_corner = 0;
		uint32_t corner_count = 0;
		uint32_t material = none; // in material_names
		uint32_t group = 0; // number of the `o` or `g` line before it
	};

	std::vector<glm::dvec3> positions; // in the file's units
	std::vector<glm::dvec2> uvs; // v upwards
	std::vector<glm::dvec3> normals; // of any length
	std::vector<Corner> corners;
	std::vector<Face> faces;
	std::vector<std::string> material_names;
	std::vector<std::string> libraries; // as `mtllib` names them
};

// Lines that are wrong are left out and told as errors, twenty at most; `file` is the name shown in them. More than `max_faces` faces are an error too.
ObjModel parse_obj_model(std::string_view text, const std::string &file, Diagnostics &diagnostics, size_t max_faces = 5'000'000);

struct ObjPolygons {
	std::vector<std::vector<glm::dvec3>> faces; // three corners or more
	std::vector<std::vector<glm::dvec2>> uvs; // of each face, one for each corner; empty where a corner has none
};

// For footprints: nothing, and errors, if a vertex or a face is wrong or if there is no face at all.
std::optional<ObjPolygons> parse_obj(std::string_view text, const std::string &file, Diagnostics &diagnostics);
std::optional<ObjPolygons> load_obj(const std::string &path, Diagnostics &diagnostics);

} // namespace pcg
