#pragma once

#include <functional>
#include <string>

#include <godot_cpp/classes/global_constants.hpp>
#include <godot_cpp/variant/string.hpp>

#include "core/base/diagnostic.h"

namespace pcg {

// Tells the user, once: errors as one engine error that counts them, warnings as one engine warning; each with the texts of all, places in
// the file kept. Nothing is said of empty diagnostics.
void report(const Diagnostics &diagnostics);

// Has a file written: `writer` gets the path (of the engine's kind) as the system knows it, and says what went wrong, which is reported.
// ERR_FILE_CANT_WRITE if anything did.
godot::Error save_to(const godot::String &path, const std::function<void(const std::string &path, Diagnostics &diagnostics)> &writer);

} // namespace pcg
