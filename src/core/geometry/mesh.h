#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

// The polygons that a derivation hands out. Faces stay whole polygons with holes; triangles are made where an engine or a file needs them.
// Units: metres, y up, right-handed; outlines run counter-clockwise seen from the side that the face looks to.
namespace pcg {

// Look of a surface, as glTF's metallic-roughness model has it. Colours are sRGB in 0 .. 1, alpha is the opacity.
struct Material {
	std::string name;
	glm::vec4 color{ 1.0f };
	float roughness = 0.9f; // 0 .. 1
	float metallic = 0.0f; // 0 .. 1
	bool is_double_sided = false;

	friend bool operator==(const Material &, const Material &) = default;
};

// One polygon: loop `first_loop` is the outline, the others are holes, which run the other way around.
struct MeshFace {
	uint32_t first_loop = 0;
	uint32_t loop_count = 1;
	uint32_t material = 0; // index in the list of materials beside the mesh
	glm::vec3 normal{ 0.0f, 1.0f, 0.0f }; // unit
};

// Corners are not shared between faces: each face has its own normal, and texture coordinates run beside the positions.
struct Mesh {
	std::vector<glm::vec3> positions;
	std::vector<uint32_t> loop_ends; // loop i owns positions [loop_ends[i - 1], loop_ends[i])
	std::vector<MeshFace> faces;

	bool is_empty() const { return faces.empty(); }
	std::span<const glm::vec3> loop(uint32_t index) const {
		const uint32_t first = index == 0 ? 0 : loop_ends[index - 1];
		return { positions.data() + first, loop_ends[index] - first };
	}
	uint32_t first_corner(uint32_t loop_index) const { return loop_index == 0 ? 0 : loop_ends[loop_index - 1]; }
};

// Triangles of one material, flat shaded: corners of different faces are different vertices. `indices` come in threes, counter-clockwise.
struct MeshSurface {
	uint32_t material = 0;
	std::vector<glm::vec3> positions;
	std::vector<glm::vec3> normals;
	std::vector<uint32_t> indices;
};

// In order of material; faces without area are left out.
std::vector<MeshSurface> make_surfaces(const Mesh &mesh);

// Appends `source` with its material indices raised by `material_offset`.
void append(Mesh &target, const Mesh &source, uint32_t material_offset = 0);

// Sum of the areas of all faces, square metres.
double area(const Mesh &mesh);

} // namespace pcg
