#pragma once

#include <cstdint>
#include <vector>

#include "core/io/gltf_library.h"

namespace pcg {

// The numbers of an accessor, `components` for each element (3 for positions); normalized integers as fractions. Empty if the accessor is not of
// that kind, points outside of its buffer, or is sparse: files are not to be believed.
std::vector<double> read_accessor(const tinygltf::Model &model, int accessor, size_t components);
// The same for indices of vertices.
std::vector<uint32_t> read_indices(const tinygltf::Model &model, int accessor);

} // namespace pcg
