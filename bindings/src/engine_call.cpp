#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/core/engine_call.hpp>
#include <godot_cpp/core/error_macros.hpp>

#include <mutex>
#include <string>
#include <unordered_map>

namespace godot {

namespace internal {

const StringName &make_static_name(const char *p_name) {
	static std::mutex mutex;
	// Never destroyed: the engine keeps static names to its own end, and so must we.
	static auto &names = *new std::unordered_map<std::string, StringName *>;
	const std::lock_guard lock(mutex);
	StringName *&name = names[p_name];
	if (!name) {
		name = new StringName(p_name, true);
	}
	return *name;
}

namespace {

template <class T> T found(T p_function, const char *p_owner, const char *p_name) {
	if (!p_function) {
		report(__FUNCTION__, __FILE__, __LINE__, "This engine lacks a function that the extension was built for",
		       String(p_owner) + "." + p_name);
	}
	return p_function;
}

} // namespace

GDExtensionMethodBindPtr find_method(const char *p_class, const char *p_method, int64_t p_hash) {
	return found(engine.classdb_get_method_bind(make_static_name(p_class)._native_ptr(),
	                                            StringName(p_method)._native_ptr(), p_hash),
	             p_class, p_method);
}

GDExtensionPtrBuiltInMethod find_builtin_method(GDExtensionVariantType p_type, const char *p_method, int64_t p_hash) {
	return found(engine.variant_get_ptr_builtin_method(p_type, StringName(p_method)._native_ptr(), p_hash),
	             "built-in type", p_method);
}

GDExtensionPtrUtilityFunction find_utility(const char *p_name, int64_t p_hash) {
	return found(engine.variant_get_ptr_utility_function(StringName(p_name)._native_ptr(), p_hash), "utility", p_name);
}

Variant call_method_varargs(GDExtensionMethodBindPtr p_method, GDExtensionObjectPtr p_object,
                            const Variant *const *p_args, int64_t p_count) {
	Variant result;
	if (p_method) {
		GDExtensionCallError error;
		// The engine writes its result over ours as into raw memory; an empty Variant owns nothing.
		engine.object_method_bind_call(p_method, p_object, reinterpret_cast<const GDExtensionConstVariantPtr *>(p_args),
		                               p_count, result._native_ptr(), &error);
	}
	return result;
}

} // namespace internal

void *Memory::alloc_static(size_t p_bytes, bool p_pad_align) {
	return internal::engine.mem_alloc2(p_bytes, p_pad_align);
}

void *Memory::realloc_static(void *p_memory, size_t p_bytes, bool p_pad_align) {
	return internal::engine.mem_realloc2(p_memory, p_bytes, p_pad_align);
}

void Memory::free_static(void *p_ptr, bool p_pad_align) {
	internal::engine.mem_free2(p_ptr, p_pad_align);
}

} // namespace godot
