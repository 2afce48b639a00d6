// The base of every class: the tie between a C++ object and its engine object, and the GDCLASS macro.
//
// A C++ object and an engine object come in pairs. An *engine class* (Node3D) has a wrapper, made when its engine
// object is first seen here and freed with it. An *extension class* (GDCLASS) has an instance, made together with its
// engine object, whoever asks for it, and freed by it. Either way the engine object owns the C++ object.
#pragma once

#include <godot_cpp/core/memory.hpp>
#include <godot_cpp/core/property_info.hpp>
#include <godot_cpp/templates/list.hpp>

namespace godot {

class ClassDB;
class Object;
typedef void GodotObject;

namespace internal {

const StringName &make_static_name(const char *p_name);

} // namespace internal

class Wrapped {
protected:
	// An object of a new pair; p_engine_class is the nearest class of the engine.
	explicit Wrapped(const StringName &p_engine_class);
	// A wrapper of an engine object that is there already.
	explicit Wrapped(GodotObject *p_owner) : _owner(p_owner) {}
	// Virtual so that every class of the tree begins with the same word: `this` is one address for all of them.
	virtual ~Wrapped() = default;

	// What an extension class may define; these stand for "not defined".
	void _notification(int) {}
	bool _set(const StringName &, const Variant &) { return false; }
	bool _get(const StringName &, Variant &) const { return false; }
	void _get_property_list(List<PropertyInfo> *) const {}
	bool _property_can_revert(const StringName &) const { return false; }
	bool _property_get_revert(const StringName &, Variant &) const { return false; }
	void _validate_property(PropertyInfo &) const {}
	String _to_string() const { return String(); }
	static void _bind_methods() {}

public:
	Wrapped(const Wrapped &) = delete;
	Wrapped &operator=(const Wrapped &) = delete;

	// Must be public, but are not for use outside the bindings.
	GodotObject *_owner = nullptr;
	static constexpr auto _gde_bind_methods() { return &Wrapped::_bind_methods; }
};

namespace internal {

// The engine's hooks of an extension class, defined in core/class_hooks.hpp.
template <class T> struct ClassHooks;

template <class T> struct EngineClassBinding {
	static void *create(void *, void *p_engine_object) {
		return new (AllocationTag{}) T(static_cast<GodotObject *>(p_engine_object));
	}
	static void free(void *, void *, void *p_wrapper) {
		static_cast<T *>(p_wrapper)->~T();
		Memory::free_static(p_wrapper);
	}
	static GDExtensionBool reference(void *, void *, GDExtensionBool) { return true; }
	static constexpr GDExtensionInstanceBindingCallbacks callbacks = {create, free, reference};
};

struct ExtensionClassBinding {
	// An extension object without an instance is an editor placeholder: there is nothing to wrap.
	static void *create(void *, void *) { return nullptr; }
	// The instance goes with the engine object's `free_instance`.
	static void free(void *, void *, void *) {}
	static GDExtensionBool reference(void *, void *, GDExtensionBool) { return true; }
	static constexpr GDExtensionInstanceBindingCallbacks callbacks = {create, free, reference};
};

} // namespace internal
} // namespace godot

// Opens a class of ours. `_bind_methods` must be declared in it, as in upstream.
#define GDCLASS(m_class, m_inherits)                                                                                   \
private:                                                                                                               \
	friend class ::godot::ClassDB;                                                                                     \
	template <class> friend struct ::godot::internal::ClassHooks;                                                      \
	void operator=(const m_class &) = delete;                                                                          \
                                                                                                                       \
public:                                                                                                                \
	using self_type = m_class;                                                                                         \
	using parent_type = m_inherits;                                                                                    \
	static const ::godot::StringName &get_class_static() {                                                             \
		static const ::godot::StringName &name = ::godot::internal::make_static_name(#m_class);                        \
		return name;                                                                                                   \
	}                                                                                                                  \
	static const ::godot::StringName &get_parent_class_static() {                                                      \
		return m_inherits::get_class_static();                                                                         \
	}                                                                                                                  \
	static constexpr auto _gde_bind_methods() { return &m_class::_bind_methods; }                                      \
	static const ::godot::internal::ClassDescription *_gde_description() {                                             \
		static const ::godot::internal::ClassDescription description = {                                               \
		        &get_class_static(), &::godot::internal::ExtensionClassBinding::callbacks};                            \
		return &description;                                                                                           \
	}                                                                                                                  \
                                                                                                                       \
private:

// Opens a generated class of the engine.
#define GODOT_CPP_ENGINE_CLASS(m_class, m_inherits)                                                                    \
protected:                                                                                                             \
	friend struct ::godot::internal::EngineClassBinding<m_class>;                                                      \
	explicit m_class(const ::godot::StringName &p_engine_class) : m_inherits(p_engine_class) {}                        \
	explicit m_class(::godot::GodotObject *p_owner) : m_inherits(p_owner) {}                                           \
	~m_class() = default;                                                                                              \
                                                                                                                       \
public:                                                                                                                \
	m_class() : m_class(get_class_static()) {}                                                                         \
	using self_type = m_class;                                                                                         \
	using parent_type = m_inherits;                                                                                    \
	using _gde_engine_class = m_class;                                                                                 \
	static const ::godot::StringName &get_class_static() {                                                             \
		static const ::godot::StringName &name = ::godot::internal::make_static_name(#m_class);                        \
		return name;                                                                                                   \
	}                                                                                                                  \
	static const GDExtensionInstanceBindingCallbacks *_gde_callbacks() {                                               \
		return &::godot::internal::EngineClassBinding<m_class>::callbacks;                                             \
	}                                                                                                                  \
	static const ::godot::internal::ClassDescription *_gde_description() {                                             \
		static const ::godot::internal::ClassDescription description = {nullptr, _gde_callbacks()};                    \
		return &description;                                                                                           \
	}                                                                                                                  \
                                                                                                                       \
private:
