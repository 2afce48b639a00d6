#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/io/rule_loader.h"

// What the fuzz targets share: each takes any bytes and must neither crash, hang nor leak. `./dev fuzz` builds and runs them.
namespace pcg::fuzz {

inline std::string text_of(const uint8_t *data, size_t size) { return { reinterpret_cast<const char *>(data), size }; }

// A program of the bytes as main file; "lib" is a small second file that it may import.
std::shared_ptr<const Program> load(const std::string &bytes, const Dialect &dialect, Diagnostics &diagnostics);

} // namespace pcg::fuzz
