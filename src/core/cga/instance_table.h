#pragma once

#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <unordered_map>
#include <vector>

#include "core/cga/derivation.h"
#include "core/cga/material_table.h"
#include "core/cga/shape.h"

namespace pcg::cga {

// A face whose area vector is not longer than this is an edge or a point, and is left out of models.
constexpr double least_face_size = 1e-12;

// GeometryFace::material of all faces, each once, in order of first use.
std::vector<uint16_t> materials_in(const Geometry &geometry);

// Which geometries are models from files, and where a derivation puts them. What differs from its file in more than place and size is no instance:
// its faces are written out.
class InstanceTable {
public:
	// Forgets the last derivation, not the models.
	void begin();
	// Shapes that have exactly this geometry may be instances from now on. It lives as long as this; turned back by `turn` it is the mesh, whose faces
	// name their material by its place in materials_in().
	void add_model(const Geometry &geometry, const glm::dmat3 &turn, std::shared_ptr<const Mesh> mesh);
	// `frame` leads from the shape's scope to where the faces would be written. False: that is to be done.
	bool add(const Shape &shape, const Frame &frame, MaterialTable &materials, DerivationResult &result);

private:
	struct Model {
		std::shared_ptr<const Mesh> mesh;
		std::vector<uint16_t> materials;
		glm::dmat3 turn{ 1.0 };
		// Sizes of the smallest face that is in the mesh and of the largest that is not.
		double least_kept = INFINITY, most_lost = 0.0;
		std::map<std::vector<uint32_t>, uint32_t> prototypes; // of this derivation, by their materials
	};

	std::unordered_map<const Geometry *, Model> _models; // looked up only, never listed for results
	std::vector<uint32_t> _looked_up;
};

} // namespace pcg::cga
