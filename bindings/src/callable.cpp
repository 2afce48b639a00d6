#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/core/memory.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>

#include <cstring>

namespace godot {

using namespace internal;

namespace {

const CallableCustom *self(void *p_userdata) {
	return static_cast<const CallableCustom *>(p_userdata);
}

void on_call(void *p_userdata, const GDExtensionConstVariantPtr *p_args, GDExtensionInt p_count,
             GDExtensionVariantPtr r_ret, GDExtensionCallError *r_error) {
	r_error->error = GDEXTENSION_CALL_OK;
	Variant result;
	self(p_userdata)
	        ->call(reinterpret_cast<const Variant **>(const_cast<GDExtensionConstVariantPtr *>(p_args)), int(p_count),
	               result, *r_error);
	*static_cast<Variant *>(r_ret) = std::move(result);
}

GDExtensionBool on_is_valid(void *p_userdata) {
	return self(p_userdata)->is_valid();
}

void on_free(void *p_userdata) {
	memdelete(static_cast<CallableCustom *>(p_userdata));
}

uint32_t on_hash(void *p_userdata) {
	return self(p_userdata)->hash();
}

GDExtensionBool on_equal(void *p_a, void *p_b) {
	auto compare = self(p_a)->get_compare_equal_func();
	return compare == self(p_b)->get_compare_equal_func() && compare(self(p_a), self(p_b));
}

GDExtensionBool on_less(void *p_a, void *p_b) {
	auto compare = self(p_a)->get_compare_less_func();
	return compare == self(p_b)->get_compare_less_func() ? compare(self(p_a), self(p_b)) : p_a < p_b;
}

void on_to_string(void *p_userdata, GDExtensionBool *r_is_valid, GDExtensionStringPtr r_out) {
	*static_cast<String *>(r_out) = self(p_userdata)->get_as_text();
	*r_is_valid = true;
}

GDExtensionInt on_argument_count(void *p_userdata, GDExtensionBool *r_is_valid) {
	bool valid = false;
	const int count = self(p_userdata)->get_argument_count(valid);
	*r_is_valid = valid;
	return count;
}

} // namespace

Callable::Callable(CallableCustom *p_custom) {
	GDExtensionCallableCustomInfo2 info = {};
	info.callable_userdata = p_custom;
	info.token = token;
	info.object_id = p_custom->get_object();
	info.call_func = on_call;
	info.is_valid_func = on_is_valid;
	info.free_func = on_free;
	info.hash_func = on_hash;
	info.equal_func = on_equal;
	info.less_than_func = on_less;
	info.to_string_func = on_to_string;
	info.get_argument_count_func = on_argument_count;
	engine.callable_custom_create2(opaque, &info);
}

CallableCustom *Callable::get_custom() const {
	return static_cast<CallableCustom *>(engine.callable_custom_get_userdata(opaque, token));
}

bool CallableCustom::is_valid() const {
	// A callable without an object is a static one and always valid.
	const ObjectID object = get_object();
	return object.is_null() || engine.object_get_instance_from_id(object) != nullptr;
}

int CallableCustom::get_argument_count(bool &r_is_valid) const {
	r_is_valid = false;
	return 0;
}

uint32_t MethodCallable::hash() const {
	// FNV-1a.
	uint32_t value = 2166136261u;
	for (size_t i = 0; i < identity_size; i++) {
		value = (value ^ static_cast<const uint8_t *>(identity)[i]) * 16777619u;
	}
	return value;
}

namespace {

int compare(const void *p_a, size_t p_size_a, const void *p_b, size_t p_size_b) {
	return p_size_a != p_size_b ? (p_size_a < p_size_b ? -1 : 1) : std::memcmp(p_a, p_b, p_size_a);
}

} // namespace

bool MethodCallable::equal(const CallableCustom *p_a, const CallableCustom *p_b) {
	const auto *a = static_cast<const MethodCallable *>(p_a);
	const auto *b = static_cast<const MethodCallable *>(p_b);
	return compare(a->identity, a->identity_size, b->identity, b->identity_size) == 0;
}

bool MethodCallable::less(const CallableCustom *p_a, const CallableCustom *p_b) {
	const auto *a = static_cast<const MethodCallable *>(p_a);
	const auto *b = static_cast<const MethodCallable *>(p_b);
	return compare(a->identity, a->identity_size, b->identity, b->identity_size) < 0;
}

} // namespace godot
