// Which C++ class wraps which engine object.
#pragma once

#include <godot_cpp/godot.hpp>

namespace godot {

class Object;
class StringName;

namespace internal {

void register_engine_class(const StringName &p_class, const GDExtensionInstanceBindingCallbacks *p_callbacks);
void register_extension_class(const StringName &p_class);
void unregister_extension_class(const StringName &p_class);
// Generated: every class that the sources include, and its ancestors.
void register_engine_classes();
extern const int64_t get_parent_class_hash;

// Gives back the wrappers of singletons, which outlive the extension.
void release_singletons();
void clear_wrapper_registry();

} // namespace internal
} // namespace godot
