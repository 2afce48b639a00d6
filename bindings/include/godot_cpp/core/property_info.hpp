#pragma once

#include <godot_cpp/classes/global_constants.hpp>
#include <godot_cpp/variant/variant.hpp>

namespace godot {

// Name, type and editor hint of a property, an argument or a return value.
struct PropertyInfo {
	Variant::Type type = Variant::NIL;
	StringName name;
	StringName class_name;
	uint32_t hint = PROPERTY_HINT_NONE;
	String hint_string;
	uint32_t usage = PROPERTY_USAGE_DEFAULT;

	PropertyInfo() = default;
	PropertyInfo(Variant::Type p_type, const StringName &p_name, PropertyHint p_hint = PROPERTY_HINT_NONE,
	             const String &p_hint_string = "", uint32_t p_usage = PROPERTY_USAGE_DEFAULT,
	             const StringName &p_class_name = "")
	    : type(p_type), name(p_name),
	      class_name(p_hint == PROPERTY_HINT_RESOURCE_TYPE ? StringName(p_hint_string) : p_class_name), hint(p_hint),
	      hint_string(p_hint_string), usage(p_usage) {}
	PropertyInfo(GDExtensionVariantType p_type, const StringName &p_name, PropertyHint p_hint = PROPERTY_HINT_NONE,
	             const String &p_hint_string = "", uint32_t p_usage = PROPERTY_USAGE_DEFAULT,
	             const StringName &p_class_name = "")
	    : PropertyInfo(Variant::Type(p_type), p_name, p_hint, p_hint_string, p_usage, p_class_name) {}
	explicit PropertyInfo(const GDExtensionPropertyInfo *p_info);

	operator Dictionary() const;
	static PropertyInfo from_dict(const Dictionary &p_dict);

	// Writes the fields into the engine's own strings (`_validate_property`).
	void _update(GDExtensionPropertyInfo *r_info) const;
	// Points at this object's fields: valid as long as it lives.
	GDExtensionPropertyInfo _to_gdextension() const;
};

} // namespace godot
