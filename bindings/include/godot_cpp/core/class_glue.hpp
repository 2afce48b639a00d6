// What the generated class headers need beyond their own declarations.
#pragma once

#include <godot_cpp/classes/global_constants.hpp>
#include <godot_cpp/variant/variant.hpp>

namespace godot::internal {

// Tells the engine of an override; defined in core/class_db.hpp.
template <class T, auto Method> void bind_virtual(const char *p_name, uint32_t p_hash);

// The result of a call with any number of arguments is a Variant; this is its declared type.
template <class T> struct VariantResult {
	static T take(const Variant &p_value) {
		if constexpr (std::is_enum_v<T>) {
			return static_cast<T>(p_value.operator int64_t());
		} else {
			return p_value.operator T();
		}
	}
};

} // namespace godot::internal
