#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

// How a surface looks: what CityEngine's shapes say of it (CGA reference: attr_material), of which engines and files show as much as they can.
namespace pcg {

// What a picture is for. Map n is laid out by texture coordinate set n, or by set 0 where set n is missing.
enum class TextureUse : uint8_t { Color, Bump, Dirt, Specular, Opacity, Normal, Emissive, Occlusion, Roughness, Metallic };
constexpr size_t texture_use_count = 10;
constexpr size_t uv_set_count = 10;

// Where a picture lies on the surface: coordinates are scaled, then turned about their origin, then shifted.
struct TextureMap {
	TextureUse use = TextureUse::Color;
	std::string file; // as the rule names it, or as the host resolved it; never empty
	float scale_u = 1.0f, scale_v = 1.0f;
	float shift_u = 0.0f, shift_v = 0.0f;
	float turn = 0.0f; // degrees, counter-clockwise

	friend bool operator==(const TextureMap &, const TextureMap &) = default;
};

// Colours are sRGB in 0 .. 1; the alpha of `color` is the opacity. With a colour map the two multiply.
struct Material {
	std::string name = {};
	glm::vec4 color{ 1.0f };
	float roughness = 0.9f; // 0 .. 1
	float metallic = 0.0f; // 0 .. 1
	bool is_double_sided = false;
	glm::vec3 ambient{ 0.0f };
	glm::vec3 specular{ 0.0f };
	glm::vec3 emissive{ 0.0f };
	float shininess = 1.0f; // Phong exponent, 0 .. 128
	float reflectivity = 0.0f; // 0 .. 1
	float bump_value = 1.0f; // height of the bump map
	std::string shader = {}; // CityEngine's name for it; empty: its default
	std::vector<TextureMap> maps = {}; // in order of their use, at most one of each

	// nullptr: there is none.
	const TextureMap *map(TextureUse use) const {
		for (const TextureMap &map : maps) {
			if (map.use == use) {
				return &map;
			}
		}
		return nullptr;
	}

	friend bool operator==(const Material &, const Material &) = default;
};

} // namespace pcg
