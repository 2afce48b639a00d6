#include <godot_cpp/core/wrapper_registry.hpp>

#include <godot_cpp/classes/object.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/core/engine_call.hpp>
#include <godot_cpp/core/object.hpp>

#include <mutex>
#include <unordered_map>
#include <vector>

namespace godot::internal {

namespace {

struct KnownClass {
	StringName name;
	const GDExtensionInstanceBindingCallbacks *callbacks;
};

// By the identity of the interned name. Engine classes that were not generated are entered when first met, with their
// nearest known ancestor's wrapper.
struct Registry {
	std::mutex mutex;
	std::unordered_map<const void *, KnownClass> classes;
	std::vector<Object *> singletons;
};

Registry &registry() {
	static Registry *instance = new Registry;
	return *instance;
}

StringName parent_of(const StringName &p_class) {
	static const GDExtensionMethodBindPtr method = find_method("ClassDB", "get_parent_class", get_parent_class_hash);
	GDExtensionObjectPtr class_db = engine.global_get_singleton(make_static_name("ClassDB")._native_ptr());
	return call_method<StringName>(method, class_db, p_class);
}

const GDExtensionInstanceBindingCallbacks *find_callbacks(const StringName &p_class) {
	const std::lock_guard lock(registry().mutex);
	auto &classes = registry().classes;
	StringName known = p_class;
	auto found = classes.find(known._identity());
	while (found == classes.end() && !known.is_empty()) {
		known = parent_of(known);
		found = classes.find(known._identity());
	}
	const GDExtensionInstanceBindingCallbacks *callbacks =
	        found == classes.end() ? Object::_gde_callbacks() : found->second.callbacks;
	classes.emplace(p_class._identity(), KnownClass{p_class, callbacks});
	return callbacks;
}

} // namespace

void register_engine_class(const StringName &p_class, const GDExtensionInstanceBindingCallbacks *p_callbacks) {
	const std::lock_guard lock(registry().mutex);
	registry().classes.insert_or_assign(p_class._identity(), KnownClass{p_class, p_callbacks});
}

void register_extension_class(const StringName &p_class) {
	register_engine_class(p_class, &ExtensionClassBinding::callbacks);
}

void unregister_extension_class(const StringName &p_class) {
	const std::lock_guard lock(registry().mutex);
	registry().classes.erase(p_class._identity());
}

void release_singletons() {
	for (Object *singleton : registry().singletons) {
		engine.object_free_instance_binding(singleton->_owner, token);
	}
	registry().singletons.clear();
}

void clear_wrapper_registry() {
	registry().classes.clear();
}

Object *find_singleton(const char *p_name, Object *&r_cached) {
	if (likely(r_cached)) {
		return r_cached;
	}
	r_cached = get_object_instance_binding(engine.global_get_singleton(make_static_name(p_name)._native_ptr()));
	if (r_cached) {
		const std::lock_guard lock(registry().mutex);
		registry().singletons.push_back(r_cached);
	}
	return r_cached;
}

Object *get_object_instance_binding(GDExtensionObjectPtr p_engine_object) {
	if (!p_engine_object) {
		return nullptr;
	}
	if (void *wrapper = engine.object_get_instance_binding(p_engine_object, token, nullptr)) {
		return static_cast<Object *>(static_cast<Wrapped *>(wrapper));
	}
	StringName class_name;
	if (!engine.object_get_class_name(p_engine_object, library, class_name._native_ptr())) {
		return nullptr;
	}
	void *wrapper = engine.object_get_instance_binding(p_engine_object, token, find_callbacks(class_name));
	return static_cast<Object *>(static_cast<Wrapped *>(wrapper));
}

} // namespace godot::internal
