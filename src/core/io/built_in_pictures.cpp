#include "core/io/built_in_pictures.h"

#include <algorithm>

#include <glm/gtc/type_precision.hpp>

namespace pcg {

namespace {

using Color = glm::u8vec3;

struct BuiltIn {
	std::string_view name;
	uint32_t fields; // along each side
	uint32_t field_size; // in pixels
	Color (*color)(glm::uvec2 field, glm::uvec2 at); // both from the lower left; `at`: within the field
};

bool is_dark(glm::uvec2 field) {
	return (field.x + field.y) % 2 == 0;
}

Color checker(glm::uvec2 field, glm::uvec2) {
	return is_dark(field) ? Color(0) : Color(255);
}

// Red grows with u and green with v. The lines between the fields are black; the axes, left and below, are red along u and green along v.
Color test_field(glm::uvec2 field, glm::uvec2 at) {
	constexpr uint32_t line = 2;
	if (field.y == 0 && at.y < 4 * line) {
		return { 255, 0, 0 };
	}
	if (field.x == 0 && at.x < 4 * line) {
		return { 0, 255, 0 };
	}
	if (at.x < line || at.y < line) {
		return Color(0);
	}
	const glm::uvec2 shade = glm::uvec2(60) + 25u * field;
	return is_dark(field) ? Color(shade.x, shade.y, 90) : Color(glm::u8vec2(shade / 2u + 120u), 210);
}

constexpr BuiltIn built_ins[] = { { "builtin:default", 16, 8, checker }, { "builtin:uvtest.png", 8, 64, test_field } };

const BuiltIn *find(std::string_view name) {
	const auto *found = std::ranges::find(built_ins, name, &BuiltIn::name);
	return found != std::end(built_ins) ? found : nullptr;
}

} // namespace

glm::uvec2 built_in_picture_size(std::string_view name) {
	const BuiltIn *found = find(name);
	return glm::uvec2(found != nullptr ? found->fields * found->field_size : 0);
}

std::optional<Picture> built_in_picture(std::string_view name) {
	const BuiltIn *found = find(name);
	if (found == nullptr) {
		return std::nullopt;
	}
	Picture picture;
	picture.size = built_in_picture_size(name);
	for (uint32_t row = picture.size.y; row-- > 0;) {
		for (uint32_t x = 0; x < picture.size.x; ++x) {
			const Color color = found->color(glm::uvec2(x, row) / found->field_size, glm::uvec2(x, row) % found->field_size);
			picture.pixels.insert(picture.pixels.end(), { color.r, color.g, color.b, 255 });
		}
	}
	return picture;
}

} // namespace pcg
