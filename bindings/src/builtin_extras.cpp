// The hand-written members of the generated built-in types.
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/callable_custom.hpp>
#include <godot_cpp/variant/variant.hpp>

namespace godot {

using namespace internal;

// String

String::String(const char *p_from) {
	engine.string_new_with_latin1_chars(opaque, p_from ? p_from : "");
}

String::String(const char16_t *p_from) {
	engine.string_new_with_utf16_chars(opaque, p_from ? p_from : u"");
}

String::String(const char32_t *p_from) {
	engine.string_new_with_utf32_chars(opaque, p_from ? p_from : U"");
}

String::String(const wchar_t *p_from) {
	engine.string_new_with_wide_chars(opaque, p_from ? p_from : L"");
}

String String::utf8(const char *p_from, int64_t p_len) {
	String result;
	result.parse_utf8(p_from, p_len);
	return result;
}

int64_t String::parse_utf8(const char *p_from, int64_t p_len) {
	String parsed;
	const int64_t error = engine.string_new_with_utf8_chars_and_len2(parsed.opaque, p_from ? p_from : "", p_len);
	*this = std::move(parsed);
	return error;
}

String String::utf16(const char16_t *p_from, int64_t p_len) {
	String result;
	engine.string_new_with_utf16_chars_and_len2(result.opaque, p_from ? p_from : u"", p_len, true);
	return result;
}

String String::num_real(double p_num, bool p_trailing) {
	String text = num(p_num, 6);
	return p_trailing && !text.contains(".") ? text + ".0" : text;
}

namespace {

// Asks for the length first, then for the text.
template <class T, class Write> CharStringT<T> encode(const String &p_string, Write p_write) {
	const int64_t length = p_write(p_string._native_ptr(), nullptr, 0);
	std::basic_string<T> text(size_t(length), T(0));
	p_write(p_string._native_ptr(), text.data(), length);
	return CharStringT<T>(text.c_str());
}

} // namespace

CharString String::utf8() const {
	return encode<char>(*this, engine.string_to_utf8_chars);
}

CharString String::ascii() const {
	return encode<char>(*this, engine.string_to_latin1_chars);
}

Char16String String::utf16() const {
	return encode<char16_t>(*this, engine.string_to_utf16_chars);
}

Char32String String::utf32() const {
	return encode<char32_t>(*this, engine.string_to_utf32_chars);
}

const char32_t *String::ptr() const {
	return is_empty() ? U"" : engine.string_operator_index_const(opaque, 0);
}

char32_t *String::ptrw() {
	return is_empty() ? nullptr : engine.string_operator_index(opaque, 0);
}

int64_t String::resize(int64_t p_size) {
	return engine.string_resize(opaque, p_size);
}

const char32_t &String::operator[](int64_t p_index) const {
	return *engine.string_operator_index_const(opaque, p_index);
}

char32_t &String::operator[](int64_t p_index) {
	return *engine.string_operator_index(opaque, p_index);
}

String &String::operator=(const char *p_from) {
	return *this = String(p_from);
}

String &String::operator+=(const String &p_other) {
	engine.string_operator_plus_eq_string(opaque, p_other.opaque);
	return *this;
}

String &String::operator+=(const char *p_other) {
	engine.string_operator_plus_eq_cstr(opaque, p_other);
	return *this;
}

String &String::operator+=(char32_t p_char) {
	engine.string_operator_plus_eq_char(opaque, p_char);
	return *this;
}

String String::operator+(const char *p_other) const {
	String result(*this);
	return result += p_other;
}

String String::operator+(char32_t p_char) const {
	String result(*this);
	return result += p_char;
}

String operator+(const char *p_left, const String &p_right) {
	return String(p_left) + p_right;
}

String String::operator%(const Variant &p_values) const {
	Variant result;
	bool valid = false;
	Variant::evaluate(Variant::OP_MODULE, *this, p_values, result, valid);
	return valid ? result.operator String() : *this;
}

bool String::operator==(const char *p_other) const {
	return *this == String(p_other);
}

bool String::operator==(const char32_t *p_other) const {
	return *this == String(p_other);
}

String itos(int64_t p_val) {
	return String::num_int64(p_val);
}

String uitos(uint64_t p_val) {
	return String::num_uint64(int64_t(p_val));
}

String rtos(double p_val) {
	return String::num(p_val);
}

String rtoss(double p_val) {
	return String::num_scientific(p_val);
}

// StringName and NodePath

StringName::StringName(const char *p_from, bool p_static) {
	engine.string_name_new_with_latin1_chars(opaque, p_from ? p_from : "", p_static);
}

StringName::StringName(const char16_t *p_from) : StringName(String(p_from)) {}
StringName::StringName(const char32_t *p_from) : StringName(String(p_from)) {}
StringName::StringName(const wchar_t *p_from) : StringName(String(p_from)) {}

NodePath::NodePath(const char *p_from) : NodePath(String(p_from)) {}
NodePath::NodePath(const char16_t *p_from) : NodePath(String(p_from)) {}
NodePath::NodePath(const char32_t *p_from) : NodePath(String(p_from)) {}
NodePath::NodePath(const wchar_t *p_from) : NodePath(String(p_from)) {}

// Array and Dictionary

const Variant &Array::operator[](int64_t p_index) const {
	return *static_cast<const Variant *>(engine.array_operator_index_const(opaque, p_index));
}

Variant &Array::operator[](int64_t p_index) {
	return *static_cast<Variant *>(engine.array_operator_index(opaque, p_index));
}

const Variant *Array::ptr() const {
	return is_empty() ? nullptr : static_cast<const Variant *>(engine.array_operator_index_const(opaque, 0));
}

Variant *Array::ptrw() {
	return is_empty() ? nullptr : static_cast<Variant *>(engine.array_operator_index(opaque, 0));
}

void Array::set_typed(uint32_t p_type, const StringName &p_class_name, const Variant &p_script) {
	// Typing is refused, with an error, once there are elements; "any" is what an Array starts as.
	if (p_type != Variant::NIL) {
		engine.array_set_typed(opaque, GDExtensionVariantType(p_type), p_class_name._native_ptr(),
		                       p_script._native_ptr());
	}
}

void Array::_ref(const Array &p_from) {
	*this = p_from;
}

const Variant &Dictionary::operator[](const Variant &p_key) const {
	return *static_cast<const Variant *>(engine.dictionary_operator_index_const(opaque, p_key._native_ptr()));
}

Variant &Dictionary::operator[](const Variant &p_key) {
	return *static_cast<Variant *>(engine.dictionary_operator_index(opaque, p_key._native_ptr()));
}

void Dictionary::set_typed(uint32_t p_key_type, const StringName &p_key_class_name, const Variant &p_key_script,
                           uint32_t p_value_type, const StringName &p_value_class_name, const Variant &p_value_script) {
	engine.dictionary_set_typed(opaque, GDExtensionVariantType(p_key_type), p_key_class_name._native_ptr(),
	                            p_key_script._native_ptr(), GDExtensionVariantType(p_value_type),
	                            p_value_class_name._native_ptr(), p_value_script._native_ptr());
}

} // namespace godot
