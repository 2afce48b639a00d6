#pragma once

#include <cstdint>
#include <cstring>
#include <string>

namespace godot {

class String;

// Text in a C encoding, made by String::utf8(), ascii() and the like. `size()` counts the terminating zero.
template <typename T> class CharStringT {
	friend class String;
	std::basic_string<T> text;
	bool is_set = false;

public:
	CharStringT() = default;
	CharStringT(const T *p_text) : text(p_text ? p_text : std::basic_string<T>().c_str()), is_set(p_text != nullptr) {}

	const T *get_data() const { return text.c_str(); }
	const T *ptr() const { return text.c_str(); }
	T *ptrw() { return text.data(); }
	operator const T *() const { return text.c_str(); }
	int64_t length() const { return int64_t(text.size()); }
	int64_t size() const { return is_set ? length() + 1 : 0; }
	T operator[](int64_t p_index) const { return text.c_str()[p_index]; }

	bool operator<(const CharStringT &p_other) const { return text < p_other.text; }
};

typedef CharStringT<char> CharString;
typedef CharStringT<char16_t> Char16String;
typedef CharStringT<char32_t> Char32String;
typedef CharStringT<wchar_t> CharWideString;

String operator+(const char *p_left, const String &p_right);
String itos(int64_t p_val);
String uitos(uint64_t p_val);
String rtos(double p_val);
String rtoss(double p_val);

} // namespace godot
