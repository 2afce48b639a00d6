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

Asset read_obj_asset(const FileTree &files, const std::string &path, const AssetLimits &limits);
Asset read_gltf_asset(const FileTree &files, const std::string &path, const AssetLimits &limits);

} // namespace pcg
