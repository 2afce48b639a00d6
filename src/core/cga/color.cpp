#include "core/cga/color.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace pcg::cga {

namespace {

// Rules name colours at every second shape: a table, since the branches that tell digits from letters are never foreseen.
constexpr std::array<int8_t, 256> make_digits() {
	std::array<int8_t, 256> digits{};
	digits.fill(-1);
	for (int i = 0; i < 16; ++i) {
		digits[size_t("0123456789abcdef"[i])] = digits[size_t("0123456789ABCDEF"[i])] = int8_t(i);
	}
	return digits;
}
constexpr std::array<int8_t, 256> digits = make_digits();
int digit(char c) { return digits[uint8_t(c)]; }

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
