// Calling a C++ function with arguments that come from the engine, as Variants or by ptrcall.
#pragma once

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/core/enum_info.hpp>
#include <godot_cpp/core/method_ptrcall.hpp>
#include <godot_cpp/core/type_info.hpp>

#include <tuple>

namespace godot {

template <class T> struct VariantCaster {
	static T cast(const Variant &p_variant) {
		if constexpr (std::is_enum_v<T>) {
			return static_cast<T>(p_variant.operator int64_t());
		} else if constexpr (std::is_same_v<T, char16_t> || std::is_same_v<T, char32_t>) {
			return static_cast<T>(p_variant.operator int64_t());
		} else if constexpr (std::is_pointer_v<T>) {
			return Object::cast_to<internal::Bare<std::remove_pointer_t<T>>>(p_variant.get_validated_object());
		} else if constexpr (std::is_same_v<T, Variant>) {
			return p_variant;
		} else if constexpr (std::is_constructible_v<T, const Variant &> && !std::is_arithmetic_v<T>) {
			return T(p_variant);
		} else {
			return p_variant.operator T();
		}
	}
};
template <class T> struct VariantCaster<BitField<T>> {
	static BitField<T> cast(const Variant &p_variant) { return p_variant.operator int64_t(); }
};
template <class T> struct VariantCaster<const T> : VariantCaster<T> {};
template <class T> struct VariantCaster<T &> : VariantCaster<internal::Bare<T>> {};

namespace internal {

template <class M> struct MethodTraits;
template <class R, class... P> struct MethodTraits<R (*)(P...)> {
	using Return = R;
	using Arguments = std::tuple<P...>;
	using Class = void;
	static constexpr bool is_const = false;
};
template <class C, class R, class... P> struct MethodTraits<R (C::*)(P...)> : MethodTraits<R (*)(P...)> {
	using Class = C;
};
template <class C, class R, class... P> struct MethodTraits<R (C::*)(P...) const> : MethodTraits<R (*)(P...)> {
	using Class = C;
	static constexpr bool is_const = true;
};

template <class T> bool accepts(const Variant &p_value) {
	using Value = Bare<T>;
	constexpr Variant::Type wanted = GetTypeInfo<Value>::VARIANT_TYPE;
	if constexpr (wanted == Variant::NIL) {
		return true;
	} else {
		if (p_value.get_type() != wanted && !Variant::can_convert_strict(p_value.get_type(), wanted)) {
			return false;
		}
		if constexpr (wanted == Variant::OBJECT) {
			// An object of another class is refused; null is a value.
			const auto object = VariantCaster<Value>::cast(p_value);
			return object != nullptr || p_value.get_validated_object() == nullptr;
		} else {
			return true;
		}
	}
}

template <class... P, size_t... I>
bool check_arguments([[maybe_unused]] const Variant *const *p_args, GDExtensionCallError &r_error, std::tuple<P...> *,
                     std::index_sequence<I...>) {
	[[maybe_unused]] auto check = [&](bool p_accepted, size_t p_index, Variant::Type p_wanted) {
		if (!p_accepted && r_error.error == GDEXTENSION_CALL_OK) {
			r_error = {GDEXTENSION_CALL_ERROR_INVALID_ARGUMENT, int32_t(p_index), int32_t(p_wanted)};
		}
	};
	(check(accepts<P>(*p_args[I]), I, GetTypeInfo<P>::VARIANT_TYPE), ...);
	return r_error.error == GDEXTENSION_CALL_OK;
}

template <class M, class C, class... P, size_t... I, class Get>
decltype(auto) invoke_method(M p_method, [[maybe_unused]] C *p_instance, std::tuple<P...> *, std::index_sequence<I...>,
                             [[maybe_unused]] Get p_get) {
	if constexpr (std::is_member_function_pointer_v<M>) {
		return (p_instance->*p_method)(p_get.template operator()<P>(I)...);
	} else {
		return p_method(p_get.template operator()<P>(I)...);
	}
}

// Calls with exactly as many Variants as there are parameters.
template <class M>
void call_with_variants(M p_method, typename MethodTraits<M>::Class *p_instance, const Variant *const *p_args,
                        Variant &r_ret, GDExtensionCallError &r_error) {
	using Traits = MethodTraits<M>;
	using Arguments = typename Traits::Arguments;
	constexpr auto indices = std::make_index_sequence<std::tuple_size_v<Arguments>>{};
	r_error.error = GDEXTENSION_CALL_OK;
	if (!check_arguments(p_args, r_error, static_cast<Arguments *>(nullptr), indices)) {
		return;
	}
	auto get = [&]<class P>(size_t p_index) -> decltype(auto) { return VariantCaster<P>::cast(*p_args[p_index]); };
	if constexpr (std::is_void_v<typename Traits::Return>) {
		invoke_method(p_method, p_instance, static_cast<Arguments *>(nullptr), indices, get);
	} else {
		r_ret = Variant(invoke_method(p_method, p_instance, static_cast<Arguments *>(nullptr), indices, get));
	}
}

template <class M>
void call_with_pointers(M p_method, typename MethodTraits<M>::Class *p_instance, const GDExtensionConstTypePtr *p_args,
                        GDExtensionTypePtr r_ret) {
	using Traits = MethodTraits<M>;
	using Arguments = typename Traits::Arguments;
	constexpr auto indices = std::make_index_sequence<std::tuple_size_v<Arguments>>{};
	auto get = [&]<class P>(size_t p_index) -> decltype(auto) { return PtrToArg<P>::convert(p_args[p_index]); };
	if constexpr (std::is_void_v<typename Traits::Return>) {
		invoke_method(p_method, p_instance, static_cast<Arguments *>(nullptr), indices, get);
	} else {
		PtrToArg<typename Traits::Return>::encode(
		        invoke_method(p_method, p_instance, static_cast<Arguments *>(nullptr), indices, get), r_ret);
	}
}

} // namespace internal
} // namespace godot

#include <godot_cpp/classes/global_constants_binds.hpp>
