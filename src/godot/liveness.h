#pragma once

#include <cstdint>

#include <godot_cpp/core/object.hpp>

namespace pcg {

// Whether an object outlived what scripts did meanwhile: whoever listens to a signal or is called by a rule may free it.
inline bool is_there(uint64_t object) { return godot::ObjectDB::get_instance(object) != nullptr; }

} // namespace pcg
