#include <godot_cpp/core/method_bind.hpp>

#include <godot_cpp/core/class_hooks.hpp>

namespace godot {

void MethodBind::call(void *p_instance, const Variant *const *p_args, int64_t p_count, Variant &r_ret,
                      GDExtensionCallError &r_error) const {
	const int64_t wanted = get_argument_count();
	const int64_t first_default = wanted - int64_t(default_arguments.size());
	if (p_count > wanted) {
		r_error = {GDEXTENSION_CALL_ERROR_TOO_MANY_ARGUMENTS, 0, int32_t(wanted)};
		return;
	}
	if (p_count < first_default) {
		r_error = {GDEXTENSION_CALL_ERROR_TOO_FEW_ARGUMENTS, 0, int32_t(first_default)};
		return;
	}
	if (p_count == wanted) {
		call_variants(p_instance, p_args, r_ret, r_error);
		return;
	}
	std::vector<const Variant *> all(p_args, p_args + p_count);
	for (int64_t i = p_count; i < wanted; i++) {
		all.push_back(&default_arguments[size_t(i - first_default)]);
	}
	call_variants(p_instance, all.data(), r_ret, r_error);
}

void MethodBind::bind_call(void *p_bind, GDExtensionClassInstancePtr p_instance,
                           const GDExtensionConstVariantPtr *p_args, GDExtensionInt p_count,
                           GDExtensionVariantPtr r_ret, GDExtensionCallError *r_error) {
	r_error->error = GDEXTENSION_CALL_OK;
	Variant result;
	static_cast<const MethodBind *>(p_bind)->call(p_instance, reinterpret_cast<const Variant *const *>(p_args), p_count,
	                                              result, *r_error);
	*static_cast<Variant *>(r_ret) = std::move(result);
}

void MethodBind::bind_ptrcall(void *p_bind, GDExtensionClassInstancePtr p_instance,
                              const GDExtensionConstTypePtr *p_args, GDExtensionTypePtr r_ret) {
	static_cast<const MethodBind *>(p_bind)->call_pointers(p_instance, p_args, r_ret);
}

// The rest of type_info.hpp, property_info.hpp and class_hooks.hpp

namespace internal {

StringName enum_class_name(const char *p_qualified_name) {
	const PackedStringArray parts = String(p_qualified_name).split("::", false);
	const int64_t count = parts.size();
	return count < 2 ? parts[0] : parts[count - 2] + "." + parts[count - 1];
}

namespace {

// The list's address is all that comes back; the buffer is found behind it.
struct PublishedHeader {
	PropertyListBuffer *buffer;
};

} // namespace

const GDExtensionPropertyInfo *PropertyListBuffer::publish(PropertyListBuffer *p_buffer, uint32_t *r_count) {
	*r_count = uint32_t(p_buffer->owned.size());
	const size_t size = sizeof(PublishedHeader) + sizeof(GDExtensionPropertyInfo) * *r_count;
	auto *header = static_cast<PublishedHeader *>(Memory::alloc_static(size));
	header->buffer = p_buffer;
	auto *native = reinterpret_cast<GDExtensionPropertyInfo *>(header + 1);
	uint32_t i = 0;
	for (const PropertyInfo &info : p_buffer->owned) {
		native[i++] = info._to_gdextension();
	}
	return native;
}

void PropertyListBuffer::release(const GDExtensionPropertyInfo *p_list) {
	auto *header = reinterpret_cast<PublishedHeader *>(const_cast<GDExtensionPropertyInfo *>(p_list)) - 1;
	memdelete(header->buffer);
	Memory::free_static(header);
}

} // namespace internal

PropertyInfo::PropertyInfo(const GDExtensionPropertyInfo *p_info)
    : type(Variant::Type(p_info->type)), name(*static_cast<const StringName *>(p_info->name)),
      class_name(*static_cast<const StringName *>(p_info->class_name)), hint(p_info->hint),
      hint_string(*static_cast<const String *>(p_info->hint_string)), usage(p_info->usage) {}

PropertyInfo::operator Dictionary() const {
	Dictionary result;
	result["name"] = name;
	result["class_name"] = class_name;
	result["type"] = int64_t(type);
	result["hint"] = hint;
	result["hint_string"] = hint_string;
	result["usage"] = usage;
	return result;
}

PropertyInfo PropertyInfo::from_dict(const Dictionary &p_dict) {
	PropertyInfo info;
	info.type = Variant::Type(p_dict.get("type", int64_t(info.type)).operator int64_t());
	info.name = p_dict.get("name", info.name);
	info.class_name = p_dict.get("class_name", info.class_name);
	info.hint = p_dict.get("hint", info.hint);
	info.hint_string = p_dict.get("hint_string", info.hint_string);
	info.usage = p_dict.get("usage", info.usage);
	return info;
}

void PropertyInfo::_update(GDExtensionPropertyInfo *r_info) const {
	r_info->type = GDExtensionVariantType(type);
	*static_cast<StringName *>(r_info->name) = name;
	*static_cast<StringName *>(r_info->class_name) = class_name;
	r_info->hint = hint;
	*static_cast<String *>(r_info->hint_string) = hint_string;
	r_info->usage = usage;
}

GDExtensionPropertyInfo PropertyInfo::_to_gdextension() const {
	return {GDExtensionVariantType(type), name._native_ptr(),
	        class_name._native_ptr(),     hint,
	        hint_string._native_ptr(),    usage};
}

} // namespace godot
