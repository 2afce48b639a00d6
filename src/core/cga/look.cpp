#include "core/cga/look.h"

#include <cstring>

namespace pcg::cga {

namespace {

bool has_same_textures(const Look &a, const Look &b) {
	static constexpr TextureSlots nothing;
	static_assert(sizeof(TextureSlots) == texture_use_count * 8 * sizeof(float));
	const TextureSlots &of_a = a.textures != nullptr ? *a.textures : nothing, &of_b = b.textures != nullptr ? *b.textures : nothing;
	return &of_a == &of_b || std::memcmp(&of_a, &of_b, sizeof(TextureSlots)) == 0;
}

} // namespace

bool is_same(const Look &a, const Look &b) {
	return std::memcmp(&a, &b, offsetof(Look, is_double_sided)) == 0 && a.is_double_sided == b.is_double_sided && has_same_textures(a, b);
}

uint64_t hash_of(const Look &look) {
	uint64_t words[(offsetof(Look, is_double_sided) + 7) / 8] = {};
	std::memcpy(words, &look, offsetof(Look, is_double_sided));
	uint64_t result = (uint64_t(look.texture(TextureUse::Dirt).file) << 32) | look.texture(TextureUse::Color).file;
	for (const uint64_t word : words) {
		result = (result ^ word) * 0x9E3779B97F4A7C15ull;
		result ^= result >> 32;
	}
	return result;
}

} // namespace pcg::cga
