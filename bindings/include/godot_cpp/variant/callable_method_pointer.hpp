// `callable_mp(object, &Class::method)` and `callable_mp_static(&function)`: a Callable of a C++ function.
#pragma once

#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/variant/callable_custom.hpp>

#include <cstring>

namespace godot {

namespace internal {

// Two are equal if they call the same function on the same object.
class MethodCallable : public CallableCustom {
	const void *identity = nullptr;
	size_t identity_size = 0;

	static bool equal(const CallableCustom *p_a, const CallableCustom *p_b);
	static bool less(const CallableCustom *p_a, const CallableCustom *p_b);

protected:
	uint64_t object_id = 0;
	void set_identity(const void *p_data, size_t p_size) {
		identity = p_data;
		identity_size = p_size;
	}

public:
	uint32_t hash() const override;
	String get_as_text() const override { return "<C++ method>"; }
	CompareEqualFunc get_compare_equal_func() const override { return equal; }
	CompareLessFunc get_compare_less_func() const override { return less; }
	ObjectID get_object() const override { return ObjectID(object_id); }
};

template <class M> class MethodCallableOf : public MethodCallable {
	using Traits = MethodTraits<M>;
	static constexpr size_t parameter_count = std::tuple_size_v<typename Traits::Arguments>;
	struct Target {
		typename Traits::Class *instance;
		M method;
	} target;

public:
	MethodCallableOf(typename Traits::Class *p_instance, M p_method) {
		// Padding counts in comparisons.
		std::memset(static_cast<void *>(&target), 0, sizeof(Target));
		target.instance = p_instance;
		target.method = p_method;
		set_identity(&target, sizeof(Target));
		if constexpr (!std::is_void_v<typename Traits::Class>) {
			object_id = p_instance->get_instance_id();
		}
	}
	int get_argument_count(bool &r_is_valid) const override {
		r_is_valid = true;
		return int(parameter_count);
	}
	void call(const Variant **p_arguments, int p_argcount, Variant &r_return_value,
	          GDExtensionCallError &r_call_error) const override {
		if (p_argcount != int(parameter_count)) {
			r_call_error.error = p_argcount < int(parameter_count) ? GDEXTENSION_CALL_ERROR_TOO_FEW_ARGUMENTS
			                                                       : GDEXTENSION_CALL_ERROR_TOO_MANY_ARGUMENTS;
			r_call_error.expected = int32_t(parameter_count);
			return;
		}
		call_with_variants(target.method, target.instance, p_arguments, r_return_value, r_call_error);
	}
};

} // namespace internal

template <class C, class D, class R, class... P>
Callable create_custom_callable_function_pointer(C *p_instance, R (D::*p_method)(P...)) {
	return Callable(memnew(internal::MethodCallableOf<R (D::*)(P...)>(p_instance, p_method)));
}
template <class C, class D, class R, class... P>
Callable create_custom_callable_function_pointer(C *p_instance, R (D::*p_method)(P...) const) {
	return Callable(memnew(internal::MethodCallableOf<R (D::*)(P...) const>(
	        const_cast<D *>(static_cast<const D *>(p_instance)), p_method)));
}
template <class R, class... P> Callable create_custom_callable_static_function_pointer(R (*p_method)(P...)) {
	return Callable(memnew(internal::MethodCallableOf<R (*)(P...)>(nullptr, p_method)));
}

} // namespace godot

#define callable_mp(m_instance, m_method) ::godot::create_custom_callable_function_pointer(m_instance, m_method)
#define callable_mp_static(m_method) ::godot::create_custom_callable_static_function_pointer(m_method)
