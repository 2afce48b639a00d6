// How a C++ value crosses the engine's fast call ("ptrcall"): integers as int64_t, reals as double, bool as one byte,
// objects as their engine pointer, built-in types as themselves.
#pragma once

#include <godot_cpp/core/defs.hpp>
#include <godot_cpp/godot.hpp>
#include <godot_cpp/variant/variant.hpp>

namespace godot {

class Object;
class Wrapped;
template <class T> class Ref;
template <class T> class BitField;
template <class T> class TypedArray;
template <class K, class V> class TypedDictionary;

namespace internal {

// The wrapper of an engine object, made if there is none yet; null for null.
Object *get_object_instance_binding(GDExtensionObjectPtr p_engine_object);

template <class T> using Bare = std::remove_cv_t<std::remove_reference_t<T>>;

} // namespace internal

template <class T> struct PtrToArg {
	static_assert(std::is_same_v<T, internal::Bare<T>>);

	static constexpr bool is_number = std::is_arithmetic_v<T> || std::is_enum_v<T>;
	static constexpr bool is_object = std::is_pointer_v<T>;

	using EncodeT = std::conditional_t<
	        std::is_same_v<T, bool>, uint8_t,
	        std::conditional_t<
	                std::is_floating_point_v<T>, double,
	                std::conditional_t<is_number, int64_t, std::conditional_t<is_object, GDExtensionObjectPtr, T>>>>;

	static T convert(const void *p_ptr) {
		const EncodeT &stored = *static_cast<const EncodeT *>(p_ptr);
		if constexpr (is_number) {
			return static_cast<T>(stored);
		} else if constexpr (is_object) {
			return static_cast<T>(internal::get_object_instance_binding(stored));
		} else {
			return stored;
		}
	}

	static EncodeT encode_arg(const T &p_value) {
		if constexpr (is_number) {
			return static_cast<EncodeT>(p_value);
		} else if constexpr (is_object) {
			return p_value ? p_value->_owner : nullptr;
		} else {
			return p_value;
		}
	}

	static void encode(const T &p_value, void *r_ptr) { *static_cast<EncodeT *>(r_ptr) = encode_arg(p_value); }
};

template <class T> struct PtrToArg<const T> : PtrToArg<T> {};
template <class T> struct PtrToArg<T &> : PtrToArg<internal::Bare<T>> {};

template <class T> struct PtrToArg<BitField<T>> {
	using EncodeT = int64_t;
	static BitField<T> convert(const void *p_ptr) { return *static_cast<const int64_t *>(p_ptr); }
	static int64_t encode_arg(BitField<T> p_value) { return p_value; }
	static void encode(BitField<T> p_value, void *r_ptr) { *static_cast<int64_t *>(r_ptr) = p_value; }
};

// The typed containers differ from the plain ones in what they admit, not in memory.
template <class T> struct PtrToArg<TypedArray<T>> {
	using EncodeT = Array;
	static TypedArray<T> convert(const void *p_ptr) { return *static_cast<const Array *>(p_ptr); }
	static const Array &encode_arg(const TypedArray<T> &p_value) { return p_value; }
	static void encode(const Array &p_value, void *r_ptr) { *static_cast<Array *>(r_ptr) = p_value; }
};

template <class K, class V> struct PtrToArg<TypedDictionary<K, V>> {
	using EncodeT = Dictionary;
	static TypedDictionary<K, V> convert(const void *p_ptr) { return *static_cast<const Dictionary *>(p_ptr); }
	static const Dictionary &encode_arg(const TypedDictionary<K, V> &p_value) { return p_value; }
	static void encode(const Dictionary &p_value, void *r_ptr) { *static_cast<Dictionary *>(r_ptr) = p_value; }
};

} // namespace godot
