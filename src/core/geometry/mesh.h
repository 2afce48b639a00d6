#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/geometry/material.h"

// The polygons that a derivation hands out. Faces stay whole polygons with holes; triangles are made where an engine or a file needs them.
// Units: metres, y up, right-handed; outlines run counter-clockwise seen from the side that the face looks to.
namespace pcg {

// One polygon: loop `first_loop` is the outline, the others are holes, which run the other way around.
struct MeshFace {
	uint32_t first_loop = 0;
	uint32_t loop_count = 1;
	uint32_t material = 0; // index in the list of materials beside the mesh
	glm::vec3 normal{ 0.0f, 1.0f, 0.0f }; // unit
};

// Texture coordinates by set: empty, or one for each position. u to the right, v upwards, (0, 0) is the lower left corner of the picture.
using UvArrays = std::array<std::vector<glm::vec2>, uv_set_count>;

// Corners are not shared between faces: each face has its own normal, and what else a corner has runs beside the positions.
struct Mesh {
	std::vector<glm::vec3> positions;
	UvArrays uvs;
	std::vector<glm::vec3> normals; // of corners, unit; empty: all faces are flat
	std::vector<uint32_t> loop_ends; // loop i owns positions [loop_ends[i - 1], loop_ends[i])
	std::vector<MeshFace> faces;

	bool is_empty() const { return faces.empty(); }
	std::span<const glm::vec3> loop(uint32_t index) const {
		const uint32_t first = index == 0 ? 0 : loop_ends[index - 1];
		return { positions.data() + first, loop_ends[index] - first };
	}
	uint32_t first_corner(uint32_t loop_index) const { return loop_index == 0 ? 0 : loop_ends[loop_index - 1]; }
};

// Triangles of one material: corners of different faces are different vertices. `indices` come in threes, counter-clockwise.
struct MeshSurface {
	uint32_t material = 0;
	std::vector<glm::vec3> positions;
	std::vector<glm::vec3> normals;
	UvArrays uvs;
	std::vector<uint32_t> indices;
};

// In order of material; faces without area are left out.
std::vector<MeshSurface> make_surfaces(const Mesh &mesh);

// Appends `source` with its material indices raised by `material_offset`. Corners that lack a texture coordinate set the other mesh has get (0, 0).
void append(Mesh &target, const Mesh &source, uint32_t material_offset = 0);

// Sum of the areas of all faces, square metres.
double area(const Mesh &mesh);

} // namespace pcg
