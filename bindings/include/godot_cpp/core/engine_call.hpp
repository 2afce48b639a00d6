// Calls into the engine, used by the generated code: one template per kind of callee, arguments by `PtrToArg`.
#pragma once

#include <godot_cpp/core/method_ptrcall.hpp>

namespace godot::internal {

// Null, with an error in the log, if this engine has no such method (it is older or newer than the API dump).
GDExtensionMethodBindPtr find_method(const char *p_class, const char *p_method, int64_t p_hash);
GDExtensionPtrBuiltInMethod find_builtin_method(GDExtensionVariantType p_type, const char *p_method, int64_t p_hash);
GDExtensionPtrUtilityFunction find_utility(const char *p_name, int64_t p_hash);

// The wrapper of a singleton, looked up once and given back when the extension ends.
Object *find_singleton(const char *p_name, Object *&r_cached);

// A constant name that lives as long as the program: counted as static by the engine, never destroyed.
const StringName &make_static_name(const char *p_name);

// Holds one argument in the form and at the address that a ptrcall wants.
template <class T> struct Argument {
	using Stored = typename PtrToArg<T>::EncodeT;
	static constexpr bool in_place = !PtrToArg<T>::is_number && !PtrToArg<T>::is_object;

	std::conditional_t<in_place, const T *, Stored> value;

	explicit Argument(const T &p_value) {
		if constexpr (in_place) {
			value = &p_value;
		} else {
			value = PtrToArg<T>::encode_arg(p_value);
		}
	}
	GDExtensionConstTypePtr ptr() const {
		if constexpr (in_place) {
			return value;
		} else {
			return &value;
		}
	}
};

template <class T> struct Argument<BitField<T>> {
	int64_t value;
	explicit Argument(BitField<T> p_value) : value(p_value) {}
	GDExtensionConstTypePtr ptr() const { return &value; }
};

template <class T> struct Argument<Ref<T>> {
	GDExtensionObjectPtr value;
	explicit Argument(const Ref<T> &p_value) : value(p_value.is_valid() ? p_value->_owner : nullptr) {}
	GDExtensionConstTypePtr ptr() const { return &value; }
};

template <class T> struct Argument<TypedArray<T>> {
	const Array *value;
	explicit Argument(const Array &p_value) : value(&p_value) {}
	GDExtensionConstTypePtr ptr() const { return value; }
};

template <class K, class V> struct Argument<TypedDictionary<K, V>> {
	const Dictionary *value;
	explicit Argument(const Dictionary &p_value) : value(&p_value) {}
	GDExtensionConstTypePtr ptr() const { return value; }
};

// Room for a returned value, and how to make the C++ value of it.
template <class T> struct Result {
	typename PtrToArg<T>::EncodeT stored{};
	T take() { return PtrToArg<T>::convert(&stored); }
};

template <class T>
requires(!PtrToArg<T>::is_number && !PtrToArg<T>::is_object) struct Result<T> {
	T stored{};
	T take() { return std::move(stored); }
};

template <class T> struct Result<Ref<T>> {
	GDExtensionObjectPtr stored = nullptr;
	// The engine already counted the reference that it hands over.
	Ref<T> take() { return Ref<T>::_gde_internal_constructor(get_object_instance_binding(stored)); }
};

template <class R, class Invoke, class... Slots> R call_with(Invoke p_invoke, const Slots &...p_slots) {
	GDExtensionConstTypePtr arguments[] = {p_slots.ptr()..., nullptr};
	if constexpr (std::is_void_v<R>) {
		p_invoke(arguments, nullptr);
	} else {
		Result<R> result;
		p_invoke(arguments, &result.stored);
		return result.take();
	}
}

template <class R, class... A>
R call_method(GDExtensionMethodBindPtr p_method, GDExtensionObjectPtr p_object, const A &...p_args) {
	auto invoke = [&](const GDExtensionConstTypePtr *p_arguments, GDExtensionTypePtr r_result) {
		if (likely(p_method)) {
			engine.object_method_bind_ptrcall(p_method, p_object, p_arguments, r_result);
		}
	};
	return call_with<R>(invoke, Argument<A>(p_args)...);
}

template <class R, class... A>
R call_builtin(GDExtensionPtrBuiltInMethod p_method, GDExtensionConstTypePtr p_base, const A &...p_args) {
	auto invoke = [&](const GDExtensionConstTypePtr *p_arguments, GDExtensionTypePtr r_result) {
		if (likely(p_method)) {
			p_method(const_cast<GDExtensionTypePtr>(p_base), p_arguments, r_result, sizeof...(A));
		}
	};
	return call_with<R>(invoke, Argument<A>(p_args)...);
}

template <class R, class... A> R call_utility(GDExtensionPtrUtilityFunction p_function, const A &...p_args) {
	auto invoke = [&](const GDExtensionConstTypePtr *p_arguments, GDExtensionTypePtr r_result) {
		if (likely(p_function)) {
			p_function(r_result, p_arguments, sizeof...(A));
		}
	};
	return call_with<R>(invoke, Argument<A>(p_args)...);
}

template <class R, class A>
R call_operator(GDExtensionPtrOperatorEvaluator p_operator, GDExtensionConstTypePtr p_left, const A &p_right) {
	auto invoke = [&](const GDExtensionConstTypePtr *p_arguments, GDExtensionTypePtr r_result) {
		p_operator(p_left, p_arguments[0], r_result);
	};
	return call_with<R>(invoke, Argument<A>(p_right));
}

template <class... A>
void construct(GDExtensionPtrConstructor p_constructor, GDExtensionUninitializedTypePtr r_base, const A &...p_args) {
	auto invoke = [&](const GDExtensionConstTypePtr *p_arguments, GDExtensionTypePtr) {
		p_constructor(r_base, p_arguments);
	};
	call_with<void>(invoke, Argument<A>(p_args)...);
}

// A call with any number of arguments (`emit_signal`, `call_deferred`); the result is a Variant.
Variant call_method_varargs(GDExtensionMethodBindPtr p_method, GDExtensionObjectPtr p_object,
                            const Variant *const *p_args, int64_t p_count);

} // namespace godot::internal
