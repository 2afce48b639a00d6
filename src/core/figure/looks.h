#pragma once

#include <cstddef>
#include <cstdint>

#include <glm/vec3.hpp>

#include "core/figure/figure.h"
#include "core/population/population.h"

namespace pcg {

constexpr size_t figure_kind_count = 6;

// How a person looks, from their lasting data alone.
struct Looks {
	uint8_t kind = 0; // of the six figures: a man as child, adult, elder, then a woman
	uint8_t hair = 0; // 0 .. 7
	uint8_t skin = 0; // 0 .. 7
	glm::vec3 top{ 1.0f };
};
Looks looks_of(const Population &population, PersonId person);
Figure make_figure_of_kind(size_t kind);

// The tones that `hair` and `skin` stand for, linear.
glm::vec3 hair_tone(uint8_t hair);
glm::vec3 skin_tone(uint8_t skin);

} // namespace pcg
