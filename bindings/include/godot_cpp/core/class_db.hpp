// Registering our classes with the engine: GDREGISTER_CLASS and what `_bind_methods` calls.
#pragma once

#include <godot_cpp/core/class_hooks.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/core/method_bind.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>

#include <memory>
#include <set>
#include <unordered_map>
#include <vector>

#define DEFVAL(m_defval) (m_defval)

namespace godot {

struct MethodDefinition {
	StringName name;
	std::vector<StringName> args;
	MethodDefinition() = default;
	MethodDefinition(StringName p_name) : name(p_name) {}
};

template <typename... Args> MethodDefinition D_METHOD(StringName p_name, const Args &...p_args) {
	MethodDefinition definition(p_name);
	definition.args = {StringName(p_args)...};
	return definition;
}

namespace internal {

struct NameHash {
	size_t operator()(const StringName &p_name) const { return std::hash<const void *>()(p_name._identity()); }
};
template <class T> using NameMap = std::unordered_map<StringName, T, NameHash>;

} // namespace internal

class ClassDB {
	friend class GDExtensionBinding;

	struct VirtualMethod {
		StringName name;
		uint32_t hash;
		GDExtensionClassCallVirtual call;
	};
	struct MethodBindDeleter {
		void operator()(MethodBind *p_bind) const { memdelete(p_bind); }
	};
	struct Storage;
	struct ClassInfo {
		StringName name;
		ClassInfo *parent = nullptr;
		GDExtensionInitializationLevel level = GDEXTENSION_INITIALIZATION_SCENE;
		internal::NameMap<std::unique_ptr<MethodBind, MethodBindDeleter>> methods;
		std::set<StringName> properties;
		std::set<StringName> signals;
		std::set<StringName> constants;
		// By the identity of the engine's interned name: looked up for every new object.
		std::unordered_map<const void *, VirtualMethod> virtuals;
	};

	struct RegisterOptions {
		bool is_virtual = false;
		bool is_abstract = false;
		bool is_exposed = true;
		bool is_runtime = false;
	};

	static ClassInfo *find_class(const StringName &p_name);
	static ClassInfo &begin_class(const StringName &p_name, const StringName &p_parent,
	                              GDExtensionClassCreationInfo5 &p_info, const RegisterOptions &p_options);
	static MethodBind *add_method(MethodBind *p_bind, const MethodDefinition &p_definition,
	                              std::vector<Variant> p_defaults);
	static void announce_method(const ClassInfo &p_class, MethodBind &p_bind);
	static const MethodBind *find_method(const ClassInfo *p_class, const StringName &p_name);
	static GDExtensionClassCallVirtual get_virtual(void *p_class, GDExtensionConstStringNamePtr p_name,
	                                               uint32_t p_hash);

	static void set_level(GDExtensionInitializationLevel p_level);
	// Takes back the classes of the level, newest first.
	static void deinitialize(GDExtensionInitializationLevel p_level);

	template <class T> static void register_class_as(const RegisterOptions &p_options) {
		static_assert(std::is_same_v<typename T::self_type, T>, "Class not declared properly, please use GDCLASS.");
		static_assert(T::_gde_bind_methods() != T::parent_type::_gde_bind_methods(),
		              "Class must declare 'static void _bind_methods'.");
		GDExtensionClassCreationInfo5 info = internal::ClassHooks<T>::creation_info();
		begin_class(T::get_class_static(), T::get_parent_class_static(), info, p_options);
		T::_bind_methods();
		T::_gde_engine_class::template register_virtuals<T, typename T::_gde_engine_class>();
	}

public:
	template <class T> static void register_class(bool p_virtual = false) {
		static_assert(!std::is_abstract_v<T>, "Class is abstract, please use GDREGISTER_ABSTRACT_CLASS.");
		register_class_as<T>({.is_virtual = p_virtual});
	}
	template <class T> static void register_abstract_class() { register_class_as<T>({.is_abstract = true}); }
	template <class T> static void register_internal_class() { register_class_as<T>({.is_exposed = false}); }
	template <class T> static void register_runtime_class() { register_class_as<T>({.is_runtime = true}); }

	template <class N, class M, typename... Defaults>
	static MethodBind *bind_method(N p_definition, M p_method, Defaults... p_defaults) {
		return add_method(memnew(internal::MethodBindOf<M>(p_method)), p_definition, {Variant(p_defaults)...});
	}
	template <class N, class M, typename... Defaults>
	static MethodBind *bind_static_method(StringName p_class, N p_definition, M p_method, Defaults... p_defaults) {
		return add_method(memnew(internal::MethodBindOf<M>(p_class, p_method)), p_definition, {Variant(p_defaults)...});
	}

	static void add_property_group(const StringName &p_class, const String &p_name, const String &p_prefix);
	static void add_property_subgroup(const StringName &p_class, const String &p_name, const String &p_prefix);
	static void add_property(const StringName &p_class, const PropertyInfo &p_info, const StringName &p_setter,
	                         const StringName &p_getter, int p_index = -1);
	static void add_signal(const StringName &p_class, const MethodInfo &p_signal);
	static void bind_integer_constant(const StringName &p_class, const StringName &p_enum, const StringName &p_constant,
	                                  GDExtensionInt p_value, bool p_is_bitfield = false);
	static void bind_virtual_method(const StringName &p_class, const StringName &p_method,
	                                GDExtensionClassCallVirtual p_call, uint32_t p_hash);
};

namespace internal {

template <class T, auto Method> void bind_virtual(const char *p_name, uint32_t p_hash) {
	auto call = [](GDExtensionClassInstancePtr p_instance, const GDExtensionConstTypePtr *p_args,
	               GDExtensionTypePtr r_ret) {
		using Owner = typename MethodTraits<decltype(Method)>::Class;
		call_with_pointers(Method, static_cast<Owner *>(static_cast<Wrapped *>(p_instance)), p_args, r_ret);
	};
	ClassDB::bind_virtual_method(T::get_class_static(), make_static_name(p_name), call, p_hash);
}

} // namespace internal
} // namespace godot

#define BIND_CONSTANT(m_constant)                                                                                      \
	::godot::ClassDB::bind_integer_constant(get_class_static(), "", #m_constant, m_constant);
#define BIND_ENUM_CONSTANT(m_constant)                                                                                 \
	::godot::ClassDB::bind_integer_constant(get_class_static(),                                                        \
	                                        ::godot::_gde_constant_get_enum_name(m_constant, #m_constant),             \
	                                        #m_constant, m_constant);
#define BIND_BITFIELD_FLAG(m_constant)                                                                                 \
	::godot::ClassDB::bind_integer_constant(get_class_static(),                                                        \
	                                        ::godot::_gde_constant_get_enum_name(m_constant, #m_constant),             \
	                                        #m_constant, m_constant, true);

#define GDREGISTER_CLASS(m_class) ::godot::ClassDB::register_class<m_class>();
#define GDREGISTER_VIRTUAL_CLASS(m_class) ::godot::ClassDB::register_class<m_class>(true);
#define GDREGISTER_ABSTRACT_CLASS(m_class) ::godot::ClassDB::register_abstract_class<m_class>();
#define GDREGISTER_INTERNAL_CLASS(m_class) ::godot::ClassDB::register_internal_class<m_class>();
#define GDREGISTER_RUNTIME_CLASS(m_class) ::godot::ClassDB::register_runtime_class<m_class>();
