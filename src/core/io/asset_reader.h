#pragma once

#include <cstddef>
#include <string>

#include "core/io/file_tree.h"
#include "core/ports/asset_provider.h"

// Models that rules insert. What is wrong with a file is told in Asset::problem; what can be used of it is used.
namespace pcg {

struct AssetLimits {
	size_t bytes = size_t(256) << 20; // of one file
	size_t faces = 2'000'000; // of one model
};

// By the file's ending: .obj (with its .mtl), .glb, .gltf.
Asset read_asset(const FileTree &files, const std::string &path, const AssetLimits &limits = {});

// The bytes of a picture that a material names: of the file, or of the picture within a glTF file that "model.glb#2" means (counted from 0); of a
// built-in picture, a PNG.
Result<std::string> read_picture(const FileTree &files, const std::string &name, size_t limit);

// What a reader does last: corners lack what other corners have, and normals go if they say nothing that the faces do not say.
void complete_corners(Mesh &mesh);

Asset read_obj_asset(const FileTree &files, const std::string &path, const AssetLimits &limits);
Asset read_gltf_asset(const FileTree &files, const std::string &path, const AssetLimits &limits);
Result<std::string> read_gltf_picture(const FileTree &files, const std::string &path, size_t index, size_t limit);

} // namespace pcg
