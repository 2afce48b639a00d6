// Object lookup and casts, method descriptions, and the macros that register properties and signals.
#pragma once

#include <godot_cpp/classes/object.hpp>
#include <godot_cpp/core/object_id.hpp>
#include <godot_cpp/core/property_info.hpp>
#include <godot_cpp/godot.hpp>

#include <vector>

#define ADD_SIGNAL(m_signal) ::godot::ClassDB::add_signal(get_class_static(), m_signal)
#define ADD_GROUP(m_name, m_prefix) ::godot::ClassDB::add_property_group(get_class_static(), m_name, m_prefix)
#define ADD_SUBGROUP(m_name, m_prefix) ::godot::ClassDB::add_property_subgroup(get_class_static(), m_name, m_prefix)
#define ADD_PROPERTY(m_property, m_setter, m_getter)                                                                   \
	::godot::ClassDB::add_property(get_class_static(), m_property, m_setter, m_getter)
#define ADD_PROPERTYI(m_property, m_setter, m_getter, m_index)                                                         \
	::godot::ClassDB::add_property(get_class_static(), m_property, m_setter, m_getter, m_index)

namespace godot {

namespace internal {

Object *get_object_instance_binding(GDExtensionObjectPtr p_engine_object);

} // namespace internal

// Name, return value and arguments of a method or signal.
struct MethodInfo {
	StringName name;
	PropertyInfo return_val;
	uint32_t flags = GDEXTENSION_METHOD_FLAG_NORMAL;
	int id = 0;
	std::vector<PropertyInfo> arguments;
	std::vector<Variant> default_arguments;

	MethodInfo() = default;
	MethodInfo(StringName p_name) : name(p_name) {}
	template <typename... Args>
	MethodInfo(StringName p_name, const Args &...p_args) : name(p_name), arguments({PropertyInfo(p_args)...}) {}
	MethodInfo(Variant::Type p_return, StringName p_name) : name(p_name) { return_val.type = p_return; }
	template <typename... Args>
	MethodInfo(Variant::Type p_return, StringName p_name, const Args &...p_args)
	    : name(p_name), arguments({PropertyInfo(p_args)...}) {
		return_val.type = p_return;
	}
	template <typename... Args>
	MethodInfo(const PropertyInfo &p_return, StringName p_name, const Args &...p_args)
	    : name(p_name), return_val(p_return), arguments({PropertyInfo(p_args)...}) {}
};

class ObjectDB {
public:
	// Null if the object is gone.
	static Object *get_instance(uint64_t p_object_id) {
		return internal::get_object_instance_binding(internal::engine.object_get_instance_from_id(p_object_id));
	}
};

// A wrapper is of the nearest class that the sources include, so C++ knows what the object is.
template <typename T> T *Object::cast_to(Object *p_object) {
	return dynamic_cast<T *>(p_object);
}

template <typename T> const T *Object::cast_to(const Object *p_object) {
	return dynamic_cast<const T *>(p_object);
}

} // namespace godot
