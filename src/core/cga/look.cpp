#include "core/cga/look.h"

#include <bit>

#include "core/base/random.h"

namespace pcg::cga {

namespace {

bool has_same_textures(const Look &a, const Look &b) {
	if (a.textures == b.textures) {
		return true;
	}
	for (size_t i = 0; i < texture_use_count; ++i) {
		if (a.texture(TextureUse(i)) != b.texture(TextureUse(i))) {
			return false;
		}
	}
	return true;
}

} // namespace

bool is_same(const Look &a, const Look &b) {
	return a.color == b.color && a.parts == b.parts && a.ambient == b.ambient && a.specular == b.specular && a.emissive == b.emissive &&
			a.shininess == b.shininess && a.reflectivity == b.reflectivity && a.bump_value == b.bump_value && a.metallic == b.metallic &&
			a.roughness == b.roughness && a.name == b.name && a.shader == b.shader && a.is_double_sided == b.is_double_sided && has_same_textures(a, b);
}

// Of what differs most often.
uint64_t hash_of(const Look &look) {
	uint64_t result = look.parts;
	for (const float value : { look.color.r, look.color.g, look.color.b, look.color.a, look.roughness, look.metallic }) {
		result = derive_seed(result, std::bit_cast<uint32_t>(value));
	}
	result = derive_seed(result, (uint64_t(look.name) << 32) | look.texture(TextureUse::Color).file);
	return derive_seed(result, look.texture(TextureUse::Dirt).file);
}

} // namespace pcg::cga
