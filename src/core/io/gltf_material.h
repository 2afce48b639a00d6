#pragma once

#include <string>
#include <vector>

#include "core/geometry/material.h"
#include "core/io/gltf_library.h"

namespace pcg {

// A picture and the set of texture coordinates that it is laid out by.
struct TexturePlace {
	TextureUse use;
	int texture = -1;
	int uv_set = 0;
};

// The colour's is the first.
std::vector<TexturePlace> textures_of(const tinygltf::Material &material);
// Pictures are named by their paths beside the file, `path`; those inside of it by their number: "chair.glb#0".
Material material_of_gltf(const tinygltf::Model &model, const tinygltf::Material &source, const std::string &path);

} // namespace pcg
