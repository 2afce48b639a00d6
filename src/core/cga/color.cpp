#include "core/cga/color.h"

#include <cstddef>

namespace pcg::cga {

namespace {

int digit(char c) {
	if (c >= '0' && c <= '9') {
		return c - '0';
	}
	const char lower = char(c | 0x20);
	return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

} // namespace

bool parse_color(std::string_view text, glm::vec4 &color) {
	if (!text.empty() && text[0] == '#') {
		text.remove_prefix(1);
	}
	if (text.size() != 6 && text.size() != 8) {
		return false;
	}
	glm::vec4 result = color;
	for (size_t i = 0; i < text.size(); i += 2) {
		const int high = digit(text[i]), low = digit(text[i + 1]);
		if (high < 0 || low < 0) {
			return false;
		}
		result[int(i / 2)] = float(16 * high + low) / 255.0f;
	}
	color = result;
	return true;
}

} // namespace pcg::cga
