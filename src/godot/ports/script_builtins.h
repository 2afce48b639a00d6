#pragma once

#include <string>

#include <godot_cpp/variant/callable.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/variant.hpp>

#include "core/base/diagnostic.h"
#include "core/lang/dialect.h"

// Functions and operations that scripts add to the agenda language. There is one set for the whole program, since rule files are compiled
// wherever they are loaded. Main thread only.
namespace pcg {

// The agenda language with what scripts added.
const Dialect &agenda_dialect();
// Then agendas are written on the main thread: scripts are called meanwhile.
bool has_script_builtins();

// `parameters`: name to Variant::Type (int, float, bool or String), in order. The script gets the focused person (-1: nobody) before them. Adding
// the same again with another Callable replaces that. False, with an error, if something is wrong with it.
bool add_script_function(const godot::String &name, const godot::Dictionary &parameters, godot::Variant::Type result, const godot::Callable &function,
		Diagnostics &diagnostics);
// The script gives back nothing, an entry or an Array of entries: Dictionaries with `kind` ("goToBuilding" unless told, "stayInside"), `building`,
// `start` and `end` (seconds of the day).
bool add_script_operation(const godot::String &name, const godot::Dictionary &parameters, const godot::Callable &function, Diagnostics &diagnostics);

} // namespace pcg
