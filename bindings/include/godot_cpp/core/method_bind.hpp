// A bound method: what the engine holds to call one of our C++ functions.
#pragma once

#include <godot_cpp/core/binder_common.hpp>

#include <vector>

namespace godot {

class MethodBind {
	friend class ClassDB;

	StringName name;
	std::vector<StringName> argument_names;
	// For the last parameters, in order.
	std::vector<Variant> default_arguments;

protected:
	StringName instance_class;
	uint32_t flags = GDEXTENSION_METHOD_FLAG_NORMAL;
	bool returns = false;
	PropertyInfo return_info;
	GDExtensionClassMethodArgumentMetadata return_metadata = GDEXTENSION_METHOD_ARGUMENT_METADATA_NONE;
	std::vector<PropertyInfo> argument_infos;
	std::vector<GDExtensionClassMethodArgumentMetadata> argument_metadata;

	virtual void call_variants(void *p_instance, const Variant *const *p_args, Variant &r_ret,
	                           GDExtensionCallError &r_error) const = 0;
	virtual void call_pointers(void *p_instance, const GDExtensionConstTypePtr *p_args,
	                           GDExtensionTypePtr r_ret) const = 0;

public:
	virtual ~MethodBind() = default;

	const StringName &get_name() const { return name; }
	const StringName &get_instance_class() const { return instance_class; }
	int get_argument_count() const { return int(argument_infos.size()); }
	bool has_return() const { return returns; }
	bool is_static() const { return (flags & GDEXTENSION_METHOD_FLAG_STATIC) != 0; }

	// Adds the defaults of missing arguments, or reports too many or too few.
	void call(void *p_instance, const Variant *const *p_args, int64_t p_count, Variant &r_ret,
	          GDExtensionCallError &r_error) const;

	static void bind_call(void *p_bind, GDExtensionClassInstancePtr p_instance,
	                      const GDExtensionConstVariantPtr *p_args, GDExtensionInt p_count, GDExtensionVariantPtr r_ret,
	                      GDExtensionCallError *r_error);
	static void bind_ptrcall(void *p_bind, GDExtensionClassInstancePtr p_instance,
	                         const GDExtensionConstTypePtr *p_args, GDExtensionTypePtr r_ret);
};

namespace internal {

template <class M> class MethodBindOf : public MethodBind {
	using Traits = MethodTraits<M>;
	M method;

	static typename Traits::Class *instance_of(void *p_instance) {
		if constexpr (std::is_void_v<typename Traits::Class>) {
			return nullptr;
		} else {
			return static_cast<typename Traits::Class *>(static_cast<Wrapped *>(p_instance));
		}
	}

	template <class... P> void describe_arguments(std::tuple<P...> *) {
		argument_infos = {GetTypeInfo<P>::get_class_info()...};
		argument_metadata = {GetTypeInfo<P>::METADATA...};
	}

protected:
	void call_variants(void *p_instance, const Variant *const *p_args, Variant &r_ret,
	                   GDExtensionCallError &r_error) const override {
		call_with_variants(method, instance_of(p_instance), p_args, r_ret, r_error);
	}
	void call_pointers(void *p_instance, const GDExtensionConstTypePtr *p_args,
	                   GDExtensionTypePtr r_ret) const override {
		call_with_pointers(method, instance_of(p_instance), p_args, r_ret);
	}

public:
	explicit MethodBindOf(M p_method) : method(p_method) {
		describe_arguments(static_cast<typename Traits::Arguments *>(nullptr));
		if constexpr (!std::is_void_v<typename Traits::Return>) {
			returns = true;
			return_info = GetTypeInfo<typename Traits::Return>::get_class_info();
			return_metadata = GetTypeInfo<typename Traits::Return>::METADATA;
		}
		if constexpr (std::is_void_v<typename Traits::Class>) {
			flags |= GDEXTENSION_METHOD_FLAG_STATIC;
		} else {
			instance_class = Traits::Class::get_class_static();
			flags |= Traits::is_const ? uint32_t(GDEXTENSION_METHOD_FLAG_CONST) : 0u;
		}
	}
	MethodBindOf(const StringName &p_class, M p_method) : MethodBindOf(p_method) { instance_class = p_class; }
};

} // namespace internal
} // namespace godot
