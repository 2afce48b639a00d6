#pragma once

#include <godot_cpp/classes/object.hpp>
#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/memory.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/core/type_info.hpp>

namespace godot {

// A counted pointer to a RefCounted object; the last one frees it.
template <typename T> class Ref {
	T *reference = nullptr;

	void ref(T *p_object) {
		if (p_object == reference) {
			return;
		}
		unref();
		if (p_object && p_object->reference()) {
			reference = p_object;
		}
	}
	// For an object that may be new: a new one already counts one reference, and `init_ref` takes that one over.
	void ref_pointer(T *p_object) {
		if (p_object && p_object->init_ref()) {
			reference = p_object;
		}
	}
	template <typename U> static T *convert(U *p_object) {
		if constexpr (std::is_base_of_v<T, U>) {
			return p_object;
		} else {
			return Object::cast_to<T>(static_cast<Object *>(p_object));
		}
	}

public:
	Ref() = default;
	Ref(const Ref &p_from) { ref(p_from.reference); }
	Ref(Ref &&p_from) : reference(p_from.reference) { p_from.reference = nullptr; }
	template <typename U> Ref(const Ref<U> &p_from) { ref(convert(const_cast<U *>(p_from.ptr()))); }
	Ref(T *p_reference) { ref_pointer(p_reference); }
	Ref(const Variant &p_variant) { ref(Object::cast_to<T>(p_variant.get_validated_object())); }
	~Ref() { unref(); }

	Ref &operator=(const Ref &p_from) {
		ref(p_from.reference);
		return *this;
	}
	Ref &operator=(Ref &&p_from) {
		if (this != &p_from) {
			unref();
			std::swap(reference, p_from.reference);
		}
		return *this;
	}
	template <typename U> void operator=(const Ref<U> &p_from) { ref(convert(const_cast<U *>(p_from.ptr()))); }
	void operator=(const Variant &p_variant) { ref(Object::cast_to<T>(p_variant.get_validated_object())); }

	template <typename U> void reference_ptr(U *p_object) {
		if (reference != p_object) {
			unref();
			ref_pointer(convert(p_object));
		}
	}

	bool operator==(const T *p_ptr) const { return reference == p_ptr; }
	bool operator!=(const T *p_ptr) const { return reference != p_ptr; }
	bool operator==(const Ref &p_other) const { return reference == p_other.reference; }
	bool operator!=(const Ref &p_other) const { return reference != p_other.reference; }
	bool operator<(const Ref &p_other) const { return reference < p_other.reference; }

	T *operator->() const { return reference; }
	T *operator*() const { return reference; }
	T *ptr() const { return reference; }
	operator Variant() const { return Variant(reference); }

	bool is_valid() const { return reference != nullptr; }
	bool is_null() const { return reference == nullptr; }

	void unref() {
		if (reference && reference->unreference()) {
			memdelete(reference);
		}
		reference = nullptr;
	}
	void instantiate() {
		unref();
		ref_pointer(memnew(T()));
	}

	// Takes over a reference that the engine already counted.
	static Ref<T> _gde_internal_constructor(Object *p_object) {
		Ref<T> result;
		result.reference = static_cast<T *>(p_object);
		return result;
	}
};

template <typename T> struct PtrToArg<Ref<T>> {
	// The address of a Ref on the engine's side.
	using EncodeT = GDExtensionObjectPtr;

	static Ref<T> convert(const void *p_ptr) {
		GDExtensionObjectPtr object = p_ptr ? internal::engine.ref_get_object(p_ptr) : nullptr;
		return Ref<T>(static_cast<T *>(internal::get_object_instance_binding(object)));
	}
	static void encode(const Ref<T> &p_value, void *r_ptr) {
		if (p_value.is_valid()) {
			internal::engine.ref_set_object(r_ptr, p_value->_owner);
		}
	}
};

template <typename T> struct GetTypeInfo<Ref<T>> : internal::PlainTypeInfo<Variant::OBJECT> {
	static PropertyInfo get_class_info() {
		return PropertyInfo(Variant::OBJECT, StringName(), PROPERTY_HINT_RESOURCE_TYPE, T::get_class_static());
	}
};

} // namespace godot
