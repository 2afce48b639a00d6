#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

// Characters of UTF-8 text. Columns count them, and no text is cut inside of one.
namespace pcg {

inline bool starts_character(char c) { return (uint8_t(c) & 0xC0) != 0x80; }

inline size_t count_characters(std::string_view text) { return size_t(std::count_if(text.begin(), text.end(), starts_character)); }

// Where the character of that number, from 0, begins; the end of the text for larger numbers.
inline size_t byte_of_character(std::string_view text, size_t character) {
	size_t at = 0;
	while (at < text.size() && !(starts_character(text[at]) && character-- == 0)) {
		++at;
	}
	return at;
}

// Whole characters only, at most so many bytes of them.
inline std::string_view first_bytes(std::string_view text, size_t most) {
	while (most < text.size() && most > 0 && !starts_character(text[most])) {
		--most;
	}
	return text.substr(0, most);
}

} // namespace pcg
