#pragma once

#include <string_view>

#include "core/cga/asset_store.h"

namespace pcg {
class Vm;
struct Dialect;
} // namespace pcg

namespace pcg::cga {

// The geometry of the asset, or built-in body, that the running operation names. A box, with a warning once, where it is missing or broken.
const Geometry *inserted_geometry(Vm &vm, std::string_view name, AssetStore::Up up);
bool is_built_in(std::string_view name); // "builtin:cube", "builtin:uvtest.png" ..: a body or picture that every runtime of CGA has
void add_along_uv_operations(Dialect &dialect); // insertAlongUV

} // namespace pcg::cga
