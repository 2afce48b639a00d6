// What the engine is told about a C++ type in a bound method: Variant type, width, class or enum name.
#pragma once

#include <godot_cpp/core/enum_info.hpp>
#include <godot_cpp/core/method_ptrcall.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/typed_array.hpp>
#include <godot_cpp/variant/typed_dictionary.hpp>

namespace godot {

// No general case: an unsupported type, or an enum without VARIANT_ENUM_CAST, stops the compiler here.
template <class T, class = void> struct GetTypeInfo;

template <class T> struct GetTypeInfo<const T> : GetTypeInfo<T> {};
template <class T> struct GetTypeInfo<T &> : GetTypeInfo<internal::Bare<T>> {};

namespace internal {

template <Variant::Type V, GDExtensionClassMethodArgumentMetadata M = GDEXTENSION_METHOD_ARGUMENT_METADATA_NONE>
struct PlainTypeInfo {
	static constexpr Variant::Type VARIANT_TYPE = V;
	static constexpr GDExtensionClassMethodArgumentMetadata METADATA = M;
	static PropertyInfo get_class_info() { return PropertyInfo(V, StringName()); }
};

// "A::B::Enum" -> "B.Enum": the engine knows enums by class and name.
StringName enum_class_name(const char *p_qualified_name);

} // namespace internal

#define GODOT_CPP_TYPE_INFO(m_type, m_variant)                                                                         \
	template <> struct GetTypeInfo<m_type> : internal::PlainTypeInfo<Variant::m_variant> {};
GODOT_CPP_TYPE_INFO(bool, BOOL)
GODOT_CPP_VARIANT_TYPES(GODOT_CPP_TYPE_INFO)
#undef GODOT_CPP_TYPE_INFO

#define GODOT_CPP_TYPE_INFO(m_type, m_variant, m_meta)                                                                 \
	template <>                                                                                                        \
	struct GetTypeInfo<m_type>                                                                                         \
	    : internal::PlainTypeInfo<Variant::m_variant, GDEXTENSION_METHOD_ARGUMENT_METADATA_##m_meta> {};
GODOT_CPP_TYPE_INFO(int8_t, INT, INT_IS_INT8)
GODOT_CPP_TYPE_INFO(int16_t, INT, INT_IS_INT16)
GODOT_CPP_TYPE_INFO(int32_t, INT, INT_IS_INT32)
GODOT_CPP_TYPE_INFO(int64_t, INT, INT_IS_INT64)
GODOT_CPP_TYPE_INFO(uint8_t, INT, INT_IS_UINT8)
GODOT_CPP_TYPE_INFO(uint16_t, INT, INT_IS_UINT16)
GODOT_CPP_TYPE_INFO(uint32_t, INT, INT_IS_UINT32)
GODOT_CPP_TYPE_INFO(uint64_t, INT, INT_IS_UINT64)
GODOT_CPP_TYPE_INFO(char16_t, INT, INT_IS_CHAR16)
GODOT_CPP_TYPE_INFO(char32_t, INT, INT_IS_CHAR32)
GODOT_CPP_TYPE_INFO(float, FLOAT, REAL_IS_FLOAT)
GODOT_CPP_TYPE_INFO(double, FLOAT, REAL_IS_DOUBLE)
#undef GODOT_CPP_TYPE_INFO

template <>
struct GetTypeInfo<ObjectID>
    : internal::PlainTypeInfo<Variant::INT, GDEXTENSION_METHOD_ARGUMENT_METADATA_INT_IS_UINT64> {};

template <> struct GetTypeInfo<Variant> : internal::PlainTypeInfo<Variant::NIL> {
	static PropertyInfo get_class_info() {
		return PropertyInfo(Variant::NIL, StringName(), PROPERTY_HINT_NONE, "",
		                    PROPERTY_USAGE_DEFAULT | PROPERTY_USAGE_NIL_IS_VARIANT);
	}
};

template <class T>
struct GetTypeInfo<T *, std::enable_if_t<std::is_base_of_v<Object, T>>> : internal::PlainTypeInfo<Variant::OBJECT> {
	static PropertyInfo get_class_info() {
		return PropertyInfo(Variant::OBJECT, StringName(), PROPERTY_HINT_RESOURCE_TYPE, T::get_class_static());
	}
};

template <class T> struct GetTypeInfo<TypedArray<T>> : internal::PlainTypeInfo<Variant::ARRAY> {
	static PropertyInfo get_class_info() {
		return PropertyInfo(Variant::ARRAY, StringName(), PROPERTY_HINT_ARRAY_TYPE, internal::element_type_name<T>());
	}
};

template <class K, class V> struct GetTypeInfo<TypedDictionary<K, V>> : internal::PlainTypeInfo<Variant::DICTIONARY> {
	static PropertyInfo get_class_info() {
		String types = internal::element_type_name<K>() + String(";") + internal::element_type_name<V>();
		return PropertyInfo(Variant::DICTIONARY, StringName(), PROPERTY_HINT_DICTIONARY_TYPE, types);
	}
};

// A set of flags of one enum, passed as an integer.
template <class T> class BitField {
	int64_t value = 0;

public:
	BitField(int64_t p_value) : value(p_value) {}
	void set_flag(T p_flag) { value |= int64_t(p_flag); }
	bool has_flag(T p_flag) const { return (value & int64_t(p_flag)) != 0; }
	void clear_flag(T p_flag) { value &= ~int64_t(p_flag); }
	operator int64_t() const { return value; }
	operator Variant() const { return value; }
};

template <class T> struct GetTypeInfo<T, std::enable_if_t<std::is_enum_v<T>>> : internal::PlainTypeInfo<Variant::INT> {
	static_assert(internal::enum_info<T>.name != nullptr,
	              "This enum needs a VARIANT_ENUM_CAST or VARIANT_BITFIELD_CAST.");
	static PropertyInfo get_class_info() {
		constexpr internal::EnumInfo info = internal::enum_info<T>;
		return PropertyInfo(Variant::INT, StringName(), PROPERTY_HINT_NONE, "",
		                    PROPERTY_USAGE_DEFAULT | (info.is_bitfield ? PROPERTY_USAGE_CLASS_IS_BITFIELD
		                                                               : PROPERTY_USAGE_CLASS_IS_ENUM),
		                    internal::enum_class_name(info.name));
	}
};

template <class T> struct GetTypeInfo<BitField<T>> : GetTypeInfo<T> {};

template <class T> StringName _gde_constant_get_enum_name(T, const StringName &) {
	return GetTypeInfo<T>::get_class_info().class_name;
}

} // namespace godot
