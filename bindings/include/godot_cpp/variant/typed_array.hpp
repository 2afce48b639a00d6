#pragma once

#include <godot_cpp/variant/variant.hpp>

namespace godot {

class Object;

namespace internal {

void report_untyped_assignment();

template <class T> constexpr Variant::Type element_type = Variant::OBJECT;
template <> inline constexpr Variant::Type element_type<Variant> = Variant::NIL;
template <> inline constexpr Variant::Type element_type<bool> = Variant::BOOL;
template <class T>
requires std::is_integral_v<T>
constexpr Variant::Type element_type<T> = Variant::INT;
template <class T>
requires std::is_floating_point_v<T>
constexpr Variant::Type element_type<T> = Variant::FLOAT;
#define GODOT_CPP_ELEMENT(m_type, m_variant)                                                                           \
	template <> inline constexpr Variant::Type element_type<m_type> = Variant::m_variant;
GODOT_CPP_VARIANT_TYPES(GODOT_CPP_ELEMENT)
#undef GODOT_CPP_ELEMENT

template <class T> StringName element_class() {
	if constexpr (element_type<T> == Variant::OBJECT) {
		return T::get_class_static();
	} else {
		return StringName();
	}
}

template <class T> String element_type_name() {
	if constexpr (element_type<T> == Variant::OBJECT) {
		return T::get_class_static();
	} else if constexpr (element_type<T> == Variant::NIL) {
		return "Variant";
	} else {
		return Variant::get_type_name(element_type<T>);
	}
}

} // namespace internal

// An Array that admits one element type; for objects, T is the class (not a pointer or Ref).
template <typename T> class TypedArray : public Array {
	void set_element_type() { set_typed(internal::element_type<T>, internal::element_class<T>(), Variant()); }

public:
	TypedArray() { set_element_type(); }
	TypedArray(const Array &p_array) {
		set_element_type();
		if (is_same_typed(p_array)) {
			_ref(p_array);
		} else {
			assign(p_array);
		}
	}
	TypedArray(const Variant &p_variant) : TypedArray(p_variant.operator Array()) {}

	TypedArray &operator=(const TypedArray &p_array) {
		_ref(p_array);
		return *this;
	}
	TypedArray(const TypedArray &p_array) : Array() { _ref(p_array); }
	void operator=(const Array &p_array) {
		if (is_same_typed(p_array)) {
			_ref(p_array);
		} else {
			internal::report_untyped_assignment();
		}
	}
};

} // namespace godot
