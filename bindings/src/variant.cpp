#include <godot_cpp/variant/variant.hpp>

#include <godot_cpp/classes/object.hpp>
#include <godot_cpp/core/object.hpp>

namespace godot {

namespace internal {

namespace {

GDExtensionVariantFromTypeConstructorFunc from_type[Variant::VARIANT_MAX];
GDExtensionTypeFromVariantConstructorFunc to_type[Variant::VARIANT_MAX];

} // namespace

void init_variant() {
	for (int i = Variant::NIL + 1; i < Variant::VARIANT_MAX; i++) {
		from_type[i] = engine.get_variant_from_type_constructor(GDExtensionVariantType(i));
		to_type[i] = engine.get_variant_to_type_constructor(GDExtensionVariantType(i));
	}
}

} // namespace internal

using namespace internal;

Variant::Variant(GDExtensionConstVariantPtr p_native) {
	engine.variant_new_copy(opaque, p_native);
}

Variant::Variant(const Variant &p_other) {
	engine.variant_new_copy(opaque, p_other.opaque);
}

Variant::Variant(Variant &&p_other) {
	std::swap(opaque, p_other.opaque);
}

Variant::Variant(bool p_value) {
	GDExtensionBool encoded = p_value;
	from_type[BOOL](opaque, &encoded);
}

Variant::Variant(int64_t p_value) {
	from_type[INT](opaque, &p_value);
}

Variant::Variant(double p_value) {
	from_type[FLOAT](opaque, &p_value);
}

Variant::Variant(const Object *p_value) {
	GDExtensionObjectPtr owner = p_value ? p_value->_owner : nullptr;
	from_type[OBJECT](opaque, &owner);
}

Variant::~Variant() {
	engine.variant_destroy(opaque);
}

Variant::operator int64_t() const {
	int64_t result;
	to_type[INT](&result, _native_ptr());
	return result;
}

Variant::operator double() const {
	double result;
	to_type[FLOAT](&result, _native_ptr());
	return result;
}

Variant::operator ObjectID() const {
	if (get_type() == INT) {
		return ObjectID(operator uint64_t());
	}
	return get_type() == OBJECT ? ObjectID(uint64_t(engine.variant_get_object_instance_id(opaque))) : ObjectID();
}

Variant::operator Object *() const {
	GDExtensionObjectPtr owner = nullptr;
	to_type[OBJECT](&owner, _native_ptr());
	return get_object_instance_binding(owner);
}

namespace {

template <class T> T convert_to(Variant::Type p_type, GDExtensionVariantPtr p_variant) {
	// The engine constructs the value in place, so it wants raw memory.
	alignas(T) uint8_t memory[sizeof(T)];
	to_type[p_type](memory, p_variant);
	T *value = reinterpret_cast<T *>(memory);
	T result(std::move(*value));
	value->~T();
	return result;
}

} // namespace

#define GODOT_CPP_CONVERSIONS(m_type, m_variant)                                                                       \
	Variant::Variant(const m_type &p_value) {                                                                          \
		from_type[m_variant](opaque, const_cast<m_type *>(&p_value));                                                  \
	}                                                                                                                  \
	Variant::operator m_type() const {                                                                                 \
		return convert_to<m_type>(m_variant, _native_ptr());                                                           \
	}
GODOT_CPP_VARIANT_TYPES(GODOT_CPP_CONVERSIONS)
#undef GODOT_CPP_CONVERSIONS

Object *Variant::get_validated_object() const {
	return get_type() == OBJECT ? ObjectDB::get_instance(engine.variant_get_object_instance_id(opaque)) : nullptr;
}

Variant &Variant::operator=(const Variant &p_other) {
	if (this != &p_other) {
		clear();
		engine.variant_new_copy(opaque, p_other.opaque);
	}
	return *this;
}

Variant &Variant::operator=(Variant &&p_other) {
	std::swap(opaque, p_other.opaque);
	return *this;
}

// Values of different types are never equal here, not even 1 and 1.0; GDScript's `==` converts first.
bool Variant::operator==(const Variant &p_other) const {
	if (get_type() != p_other.get_type()) {
		return false;
	}
	Variant result;
	bool valid = false;
	evaluate(OP_EQUAL, *this, p_other, result, valid);
	return valid && result.operator bool();
}

bool Variant::operator<(const Variant &p_other) const {
	if (get_type() != p_other.get_type()) {
		return get_type() < p_other.get_type();
	}
	Variant result;
	bool valid = false;
	evaluate(OP_LESS, *this, p_other, result, valid);
	return valid && result.operator bool();
}

void Variant::callp(const StringName &p_method, const Variant **p_args, int p_argcount, Variant &r_ret,
                    GDExtensionCallError &r_error) {
	r_ret.clear();
	engine.variant_call(opaque, p_method._native_ptr(), reinterpret_cast<const GDExtensionConstVariantPtr *>(p_args),
	                    p_argcount, r_ret.opaque, &r_error);
}

void Variant::evaluate(const Operator &p_op, const Variant &p_a, const Variant &p_b, Variant &r_ret, bool &r_valid) {
	GDExtensionBool valid = false;
	r_ret.clear();
	engine.variant_evaluate(GDExtensionVariantOperator(p_op), p_a.opaque, p_b.opaque, r_ret.opaque, &valid);
	r_valid = valid;
}

void Variant::set(const Variant &p_key, const Variant &p_value, bool *r_valid) {
	GDExtensionBool valid = false;
	engine.variant_set(opaque, p_key.opaque, p_value.opaque, &valid);
	if (r_valid) {
		*r_valid = valid;
	}
}

void Variant::set_named(const StringName &p_name, const Variant &p_value, bool &r_valid) {
	GDExtensionBool valid = false;
	engine.variant_set_named(opaque, p_name._native_ptr(), p_value.opaque, &valid);
	r_valid = valid;
}

void Variant::set_indexed(int64_t p_index, const Variant &p_value, bool &r_valid, bool &r_oob) {
	GDExtensionBool valid = false;
	GDExtensionBool out_of_bounds = false;
	engine.variant_set_indexed(opaque, p_index, p_value.opaque, &valid, &out_of_bounds);
	r_valid = valid;
	r_oob = out_of_bounds;
}

void Variant::set_keyed(const Variant &p_key, const Variant &p_value, bool &r_valid) {
	GDExtensionBool valid = false;
	engine.variant_set_keyed(opaque, p_key.opaque, p_value.opaque, &valid);
	r_valid = valid;
}

Variant Variant::get(const Variant &p_key, bool *r_valid) const {
	Variant result;
	GDExtensionBool valid = false;
	engine.variant_get(opaque, p_key.opaque, result.opaque, &valid);
	if (r_valid) {
		*r_valid = valid;
	}
	return result;
}

Variant Variant::get_named(const StringName &p_name, bool &r_valid) const {
	Variant result;
	GDExtensionBool valid = false;
	engine.variant_get_named(opaque, p_name._native_ptr(), result.opaque, &valid);
	r_valid = valid;
	return result;
}

Variant Variant::get_indexed(int64_t p_index, bool &r_valid, bool &r_oob) const {
	Variant result;
	GDExtensionBool valid = false;
	GDExtensionBool out_of_bounds = false;
	engine.variant_get_indexed(opaque, p_index, result.opaque, &valid, &out_of_bounds);
	r_valid = valid;
	r_oob = out_of_bounds;
	return result;
}

Variant Variant::get_keyed(const Variant &p_key, bool &r_valid) const {
	Variant result;
	GDExtensionBool valid = false;
	engine.variant_get_keyed(opaque, p_key.opaque, result.opaque, &valid);
	r_valid = valid;
	return result;
}

bool Variant::iter_init(Variant &r_iter, bool &r_valid) const {
	GDExtensionBool valid = false;
	r_iter.clear();
	const bool has_first = engine.variant_iter_init(opaque, r_iter.opaque, &valid);
	r_valid = valid;
	return has_first;
}

bool Variant::iter_next(Variant &r_iter, bool &r_valid) const {
	GDExtensionBool valid = false;
	const bool has_next = engine.variant_iter_next(opaque, r_iter.opaque, &valid);
	r_valid = valid;
	return has_next;
}

Variant Variant::iter_get(const Variant &r_iter, bool &r_valid) const {
	Variant result;
	GDExtensionBool valid = false;
	engine.variant_iter_get(opaque, r_iter._native_ptr(), result.opaque, &valid);
	r_valid = valid;
	return result;
}

Variant::Type Variant::get_type() const {
	return Type(engine.variant_get_type(opaque));
}

bool Variant::has_method(const StringName &p_method) const {
	return engine.variant_has_method(opaque, p_method._native_ptr());
}

bool Variant::has_key(const Variant &p_key, bool *r_valid) const {
	GDExtensionBool valid = false;
	const bool found = engine.variant_has_key(opaque, p_key.opaque, &valid);
	if (r_valid) {
		*r_valid = valid;
	}
	return found;
}

uint32_t Variant::hash() const {
	return uint32_t(engine.variant_hash(opaque));
}

bool Variant::hash_compare(const Variant &p_other) const {
	return engine.variant_hash_compare(opaque, p_other.opaque);
}

bool Variant::booleanize() const {
	return engine.variant_booleanize(opaque);
}

String Variant::stringify() const {
	String result;
	engine.variant_stringify(opaque, result._native_ptr());
	return result;
}

Variant Variant::duplicate(bool p_deep) const {
	Variant result;
	engine.variant_duplicate(opaque, result.opaque, p_deep);
	return result;
}

String Variant::get_type_name(Type p_type) {
	String result;
	engine.variant_get_type_name(GDExtensionVariantType(p_type), result._native_ptr());
	return result;
}

bool Variant::can_convert(Type p_from, Type p_to) {
	return engine.variant_can_convert(GDExtensionVariantType(p_from), GDExtensionVariantType(p_to));
}

bool Variant::can_convert_strict(Type p_from, Type p_to) {
	return engine.variant_can_convert_strict(GDExtensionVariantType(p_from), GDExtensionVariantType(p_to));
}

void Variant::clear() {
	// Destruction leaves the memory as it was; a Variant that stays must be empty.
	engine.variant_destroy(opaque);
	engine.variant_new_nil(opaque);
}

} // namespace godot
