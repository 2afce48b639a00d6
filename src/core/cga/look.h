#pragma once

#include <cstddef>
#include <cstdint>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "core/geometry/material.h"

// Material of a shape while it is being derived: plain data, shared until a shape changes it. Names and files are ids of the TextPool.
namespace pcg::cga {

// Bits of Look::parts: what rules have set themselves wins over what an inserted asset brings. Those of the textures come behind these.
enum class LookPart : uint32_t {
	Name,
	Shader,
	Color,
	Opacity,
	Ambient,
	Specular,
	Emissive,
	Shininess,
	Reflectivity,
	BumpValue,
	Metallic,
	Roughness,
	DoubleSided,
	FirstTexture,
};
constexpr uint32_t bit_of(LookPart part) { return 1u << uint32_t(part); }
constexpr uint32_t bit_of(TextureUse use) { return 1u << (uint32_t(LookPart::FirstTexture) + uint32_t(use)); }

struct TextureSlot {
	uint32_t file = 0; // as the rule names it; 0: none
	uint32_t path = 0; // where the host found it; 0: nowhere
	float scale_u = 1.0f, scale_v = 1.0f;
	float shift_u = 0.0f, shift_v = 0.0f;
	float turn = 0.0f;
	uint32_t is_placed = 0; // 1: rules have set one of these numbers, of a picture that a model may bring

	friend bool operator==(const TextureSlot &, const TextureSlot &) = default;
};

struct TextureSlots {
	TextureSlot slots[texture_use_count];

	friend bool operator==(const TextureSlots &, const TextureSlots &) = default;
};

struct Look {
	glm::vec4 color{ 1.0f };
	glm::vec3 ambient{ 0.0f }, specular{ 0.0f }, emissive{ 0.0f };
	float shininess = 1.0f;
	float reflectivity = 0.0f;
	float bump_value = 1.0f;
	float metallic = 0.0f;
	float roughness = 1.0f;
	uint32_t name = 0, shader = 0;
	uint32_t parts = 0; // set by rules
	bool is_double_sided = true;
	const TextureSlots *textures = nullptr; // nullptr: none

	const TextureSlot &texture(TextureUse use) const {
		static constexpr TextureSlot nothing;
		return textures != nullptr ? textures->slots[size_t(use)] : nothing;
	}
	void mark(LookPart part) { parts |= bit_of(part); }
};

static_assert(offsetof(Look, is_double_sided) == 21 * sizeof(float)); // is_same() compares what stands in front of it as bytes

// By what they say, wherever their textures lie.
bool is_same(const Look &a, const Look &b);
uint64_t hash_of(const Look &look);

} // namespace pcg::cga
