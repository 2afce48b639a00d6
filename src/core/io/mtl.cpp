#include "core/io/mtl.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/lang/source.h"

namespace pcg {

namespace {

constexpr size_t max_materials = 10'000;

std::string_view next_word(std::string_view &rest) {
	const size_t start = std::min(rest.find_first_not_of(" \t\r"), rest.size());
	const size_t end = std::min(rest.find_first_of(" \t\r", start), rest.size());
	const std::string_view word = rest.substr(start, end - start);
	rest = rest.substr(end);
	return word;
}

std::string_view trimmed(std::string_view text) {
	const size_t start = std::min(text.find_first_not_of(" \t\r"), text.size());
	return text.substr(start, text.find_last_not_of(" \t\r") + 1 - start);
}

float number(std::string_view &rest, float fallback) {
	const std::string_view word = next_word(rest);
	double value = 0.0;
	const std::from_chars_result result = std::from_chars(word.data(), word.data() + word.size(), value);
	return !word.empty() && result.ec == std::errc() && std::isfinite(value) ? float(value) : fallback;
}

bool is_number(std::string_view word) {
	double value = 0.0;
	const std::from_chars_result result = std::from_chars(word.data(), word.data() + word.size(), value);
	return !word.empty() && result.ec == std::errc() && result.ptr == word.data() + word.size();
}

float unit_number(std::string_view &rest, float fallback) {
	return std::clamp(number(rest, fallback), 0.0f, 1.0f);
}

// Blinn-Phong's exponent as roughness, so that both have highlights of the same width (Walter et al. 2007).
float roughness_of(float exponent) {
	return std::sqrt(2.0f / (std::max(exponent, 0.0f) + 2.0f));
}

glm::vec3 color(std::string_view rest, glm::vec3 fallback) {
	const float red = unit_number(rest, fallback.r);
	const float green = unit_number(rest, red); // one number stands for all three
	return { red, green, unit_number(rest, green) };
}

struct MapWord {
	std::string_view keyword;
	TextureUse use;
};
constexpr MapWord map_words[] = { { "map_kd", TextureUse::Color }, { "map_bump", TextureUse::Bump }, { "bump", TextureUse::Bump },
	{ "map_ks", TextureUse::Specular }, { "map_d", TextureUse::Opacity }, { "norm", TextureUse::Normal }, { "map_kn", TextureUse::Normal },
	{ "map_ke", TextureUse::Emissive }, { "map_pr", TextureUse::Roughness }, { "map_pm", TextureUse::Metallic } };

// "-s 2 2 1 -o 0 0 wall one.png": options, then a name that may hold blanks.
void read_map(Material &material, TextureUse use, std::string_view rest, const std::string &path) {
	TextureMap map;
	map.use = use;
	for (std::string_view ahead = rest; trimmed(rest).starts_with('-'); ahead = rest) {
		const std::string_view option = next_word(ahead);
		const bool is_place = option == "-s" || option == "-o" || option == "-t";
		size_t count = option == "-mm" ? 2 : is_place ? 0 : 1;
		if (is_place) {
			const float fallback = option == "-s" ? 1.0f : 0.0f;
			float &u = option == "-s" ? map.scale_u : map.shift_u, &v = option == "-s" ? map.scale_v : map.shift_v;
			std::string_view numbers = ahead;
			const float first = number(numbers, fallback), second = number(numbers, fallback);
			u = option == "-t" ? u : first;
			v = option == "-t" ? v : second;
			for (std::string_view after = ahead; count < 3 && is_number(next_word(after));) {
				++count; // one to three
			}
		}
		for (; count > 0; --count) {
			next_word(ahead);
		}
		rest = ahead;
	}
	const std::string_view file = trimmed(rest);
	if (file.empty() || material.map(use) != nullptr) {
		return;
	}
	map.file = resolve_import(path, file);
	const auto place = std::ranges::lower_bound(material.maps, use, {}, &TextureMap::use);
	material.maps.insert(place, std::move(map));
}

void read_line(Material &material, std::string_view keyword, std::string_view rest, const std::string &path) {
	if (keyword == "Kd") {
		material.color = glm::vec4(color(rest, glm::vec3(material.color)), material.color.a);
	} else if (keyword == "Ka") {
		material.ambient = color(rest, material.ambient);
	} else if (keyword == "Ks") {
		material.specular = color(rest, material.specular);
	} else if (keyword == "Ke") {
		material.emissive = color(rest, material.emissive);
	} else if (keyword == "d") {
		material.color.a = unit_number(rest, 1.0f);
	} else if (keyword == "Tr") {
		material.color.a = 1.0f - unit_number(rest, 0.0f);
	} else if (keyword == "Ns") {
		material.shininess = std::clamp(number(rest, 1.0f), 0.0f, 128.0f);
		material.roughness = roughness_of(material.shininess);
	} else if (keyword == "Pr") {
		material.roughness = unit_number(rest, material.roughness);
	} else if (keyword == "Pm") {
		material.metallic = unit_number(rest, material.metallic);
	} else {
		std::string lower(keyword);
		std::ranges::transform(lower, lower.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
		const auto *found = std::ranges::find(map_words, std::string_view(lower), &MapWord::keyword);
		if (found != std::end(map_words)) {
			read_map(material, found->use, rest, path);
		}
	}
}

} // namespace

std::vector<Material> parse_mtl(std::string_view text, const std::string &path) {
	std::vector<Material> materials;
	for (size_t start = 0; start < text.size();) {
		const size_t end = std::min(text.find('\n', start), text.size());
		std::string_view rest = text.substr(start, end - start);
		start = end + 1;
		const std::string_view keyword = next_word(rest);
		if (keyword == "newmtl") {
			if (materials.size() >= max_materials) {
				break;
			}
			materials.emplace_back().name = trimmed(rest);
		} else if (!materials.empty()) {
			read_line(materials.back(), keyword, rest, path);
		}
	}
	return materials;
}

} // namespace pcg
