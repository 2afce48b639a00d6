// The engine's "any value". Reading a wrong type gives that type's default, as in the engine.
#pragma once

#include <godot_cpp/core/defs.hpp>
#include <godot_cpp/core/object_id.hpp>
#include <godot_cpp/variant/builtin_types.hpp>
#include <godot_cpp/variant/variant_size.gen.hpp>

#include <gdextension_interface.h>

#include <array>

namespace godot {

class Object;

// clang-format off
// m_do(C++ type, Variant::Type) for each built-in type that the engine itself converts.
#define GODOT_CPP_VARIANT_TYPES(m_do)                                                                                  \
	m_do(String, STRING) m_do(Vector2, VECTOR2) m_do(Vector2i, VECTOR2I) m_do(Rect2, RECT2) m_do(Rect2i, RECT2I)       \
	m_do(Vector3, VECTOR3) m_do(Vector3i, VECTOR3I) m_do(Transform2D, TRANSFORM2D) m_do(Vector4, VECTOR4)              \
	m_do(Vector4i, VECTOR4I) m_do(Plane, PLANE) m_do(Quaternion, QUATERNION) m_do(::godot::AABB, AABB)                 \
	m_do(Basis, BASIS) m_do(Transform3D, TRANSFORM3D) m_do(Projection, PROJECTION) m_do(Color, COLOR)                  \
	m_do(StringName, STRING_NAME) m_do(NodePath, NODE_PATH) m_do(::godot::RID, RID) m_do(Callable, CALLABLE)           \
	m_do(Signal, SIGNAL) m_do(Dictionary, DICTIONARY) m_do(Array, ARRAY) m_do(PackedByteArray, PACKED_BYTE_ARRAY)      \
	m_do(PackedInt32Array, PACKED_INT32_ARRAY) m_do(PackedInt64Array, PACKED_INT64_ARRAY)                              \
	m_do(PackedFloat32Array, PACKED_FLOAT32_ARRAY) m_do(PackedFloat64Array, PACKED_FLOAT64_ARRAY)                      \
	m_do(PackedStringArray, PACKED_STRING_ARRAY) m_do(PackedVector2Array, PACKED_VECTOR2_ARRAY)                        \
	m_do(PackedVector3Array, PACKED_VECTOR3_ARRAY) m_do(PackedColorArray, PACKED_COLOR_ARRAY)                          \
	m_do(PackedVector4Array, PACKED_VECTOR4_ARRAY)
// clang-format on

class Variant {
	alignas(8) uint8_t opaque[GODOT_CPP_VARIANT_SIZE]{0};

public:
	// clang-format off
	enum Type {
		NIL, BOOL, INT, FLOAT, STRING,
		VECTOR2, VECTOR2I, RECT2, RECT2I, VECTOR3, VECTOR3I, TRANSFORM2D, VECTOR4, VECTOR4I, PLANE, QUATERNION, AABB,
		BASIS, TRANSFORM3D, PROJECTION,
		COLOR, STRING_NAME, NODE_PATH, RID, OBJECT, CALLABLE, SIGNAL, DICTIONARY, ARRAY,
		PACKED_BYTE_ARRAY, PACKED_INT32_ARRAY, PACKED_INT64_ARRAY, PACKED_FLOAT32_ARRAY, PACKED_FLOAT64_ARRAY,
		PACKED_STRING_ARRAY, PACKED_VECTOR2_ARRAY, PACKED_VECTOR3_ARRAY, PACKED_COLOR_ARRAY, PACKED_VECTOR4_ARRAY,
		VARIANT_MAX
	};

	enum Operator {
		OP_EQUAL, OP_NOT_EQUAL, OP_LESS, OP_LESS_EQUAL, OP_GREATER, OP_GREATER_EQUAL,
		OP_ADD, OP_SUBTRACT, OP_MULTIPLY, OP_DIVIDE, OP_NEGATE, OP_POSITIVE, OP_MODULE, OP_POWER,
		OP_SHIFT_LEFT, OP_SHIFT_RIGHT, OP_BIT_AND, OP_BIT_OR, OP_BIT_XOR, OP_BIT_NEGATE,
		OP_AND, OP_OR, OP_XOR, OP_NOT, OP_IN, OP_MAX
	};
	// clang-format on

	GDExtensionVariantPtr _native_ptr() const { return const_cast<uint8_t *>(opaque); }

	Variant() = default;
	Variant(std::nullptr_t) {}
	explicit Variant(GDExtensionConstVariantPtr p_native);
	Variant(const Variant &p_other);
	Variant(Variant &&p_other);
	Variant(bool p_value);
	Variant(int64_t p_value);
	Variant(int32_t p_value) : Variant(int64_t(p_value)) {}
	Variant(int16_t p_value) : Variant(int64_t(p_value)) {}
	Variant(int8_t p_value) : Variant(int64_t(p_value)) {}
	Variant(uint64_t p_value) : Variant(int64_t(p_value)) {}
	Variant(uint32_t p_value) : Variant(int64_t(p_value)) {}
	Variant(uint16_t p_value) : Variant(int64_t(p_value)) {}
	Variant(uint8_t p_value) : Variant(int64_t(p_value)) {}
	Variant(double p_value);
	Variant(float p_value) : Variant(double(p_value)) {}
	Variant(const char *p_value) : Variant(String(p_value)) {}
	Variant(const char16_t *p_value) : Variant(String(p_value)) {}
	Variant(const char32_t *p_value) : Variant(String(p_value)) {}
	Variant(const wchar_t *p_value) : Variant(String(p_value)) {}
	Variant(const ObjectID &p_value) : Variant(uint64_t(p_value)) {}
	Variant(const Object *p_value);
#define GODOT_CPP_FROM(m_type, m_variant) Variant(const m_type &p_value);
	GODOT_CPP_VARIANT_TYPES(GODOT_CPP_FROM)
#undef GODOT_CPP_FROM
	template <class T>
	requires std::is_enum_v<T>
	explicit Variant(T p_value) : Variant(int64_t(p_value)) {}
	~Variant();

	operator bool() const {
		return booleanize();
	}
	operator int64_t() const;
	operator int32_t() const {
		return int32_t(operator int64_t());
	}
	operator int16_t() const {
		return int16_t(operator int64_t());
	}
	operator int8_t() const {
		return int8_t(operator int64_t());
	}
	operator uint64_t() const {
		return uint64_t(operator int64_t());
	}
	operator uint32_t() const {
		return uint32_t(operator int64_t());
	}
	operator uint16_t() const {
		return uint16_t(operator int64_t());
	}
	operator uint8_t() const {
		return uint8_t(operator int64_t());
	}
	operator double() const;
	operator float() const {
		return float(operator double());
	}
	operator ObjectID() const;
	operator Object *() const;
#define GODOT_CPP_TO(m_type, m_variant) operator m_type() const;
	GODOT_CPP_VARIANT_TYPES(GODOT_CPP_TO)
#undef GODOT_CPP_TO

	// Null also for an object that was freed since.
	Object *get_validated_object() const;

	Variant &operator=(const Variant &p_other);
	Variant &operator=(Variant &&p_other);
	bool operator==(const Variant &p_other) const;
	bool operator!=(const Variant &p_other) const {
		return !(*this == p_other);
	}
	bool operator<(const Variant &p_other) const;

	void callp(const StringName &p_method, const Variant **p_args, int p_argcount, Variant &r_ret,
	           GDExtensionCallError &r_error);
	template <typename... Args> Variant call(const StringName &p_method, Args... p_args) {
		std::array<Variant, sizeof...(Args)> args = {Variant(p_args)...};
		std::array<const Variant *, sizeof...(Args)> pointers;
		for (size_t i = 0; i < args.size(); i++) {
			pointers[i] = &args[i];
		}
		Variant result;
		GDExtensionCallError error;
		callp(p_method, pointers.data(), int(pointers.size()), result, error);
		return result;
	}

	static void evaluate(const Operator &p_op, const Variant &p_a, const Variant &p_b, Variant &r_ret, bool &r_valid);

	void set(const Variant &p_key, const Variant &p_value, bool *r_valid = nullptr);
	void set_named(const StringName &p_name, const Variant &p_value, bool &r_valid);
	void set_indexed(int64_t p_index, const Variant &p_value, bool &r_valid, bool &r_oob);
	void set_keyed(const Variant &p_key, const Variant &p_value, bool &r_valid);
	Variant get(const Variant &p_key, bool *r_valid = nullptr) const;
	Variant get_named(const StringName &p_name, bool &r_valid) const;
	Variant get_indexed(int64_t p_index, bool &r_valid, bool &r_oob) const;
	Variant get_keyed(const Variant &p_key, bool &r_valid) const;

	bool iter_init(Variant &r_iter, bool &r_valid) const;
	bool iter_next(Variant &r_iter, bool &r_valid) const;
	Variant iter_get(const Variant &r_iter, bool &r_valid) const;

	Type get_type() const;
	bool has_method(const StringName &p_method) const;
	bool has_key(const Variant &p_key, bool *r_valid = nullptr) const;
	uint32_t hash() const;
	bool hash_compare(const Variant &p_other) const;
	bool booleanize() const;
	String stringify() const;
	Variant duplicate(bool p_deep = false) const;

	static String get_type_name(Type p_type);
	static bool can_convert(Type p_from, Type p_to);
	static bool can_convert_strict(Type p_from, Type p_to);

	void clear();
};

namespace internal {

// Fills the tables of conversion functions; once, before anything else is used.
void init_variant();

} // namespace internal

template <typename... Args> String vformat(const String &p_text, const Args... p_args) {
	Array args;
	(args.push_back(Variant(p_args)), ...);
	return p_text % args;
}

struct VariantHasher {
	static uint32_t hash(const Variant &p_variant) { return p_variant.hash(); }
};

struct VariantComparator {
	static bool compare(const Variant &p_left, const Variant &p_right) { return p_left.hash_compare(p_right); }
};

inline Array::Array(std::initializer_list<Variant> p_init) : Array() {
	for (const Variant &element : p_init) {
		push_back(element);
	}
}
inline const Variant *Array::end() const {
	return ptr() + size();
}
inline Variant *Array::end() {
	return ptrw() + size();
}

template <typename... Args> Array Array::make(const Args &...p_args) {
	return Array{Variant(p_args)...};
}

} // namespace godot

#include <godot_cpp/variant/builtin_vararg_methods.gen.hpp>
