#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "core/base/random.h"
#include "core/population/population.h"

// Names and colors that persons refer to by index. Constant tables, the same for every population.
namespace pcg {

struct NamedColor {
	std::string_view name;
	uint8_t red = 0; // sRGB
	uint8_t green = 0;
	uint8_t blue = 0;
};

std::span<const std::string_view> first_names(Gender gender);
std::span<const std::string_view> family_names();
std::span<const NamedColor> hair_colors();
// An index of hair_colors() for a household, any but gray: that is the color of the old, or written by hand.
uint8_t draw_hair_color(Random &random);
std::span<const NamedColor> clothes_colors();

// An index behind the end of the list counts on in Population::names, where names stand that somebody wrote by hand.
std::string_view first_name(const Population &population, PersonId id);
std::string_view family_name(const Population &population, HouseholdId id);

// "Ada Marsh".
std::string full_name(const Population &population, PersonId id);

} // namespace pcg
