#include "core/io/gltf_material.h"

#include <algorithm>
#include <cmath>

#include "core/lang/source.h"

namespace pcg {

namespace {

float to_srgb(double linear) {
	const double value = std::clamp(linear, 0.0, 1.0);
	return float(value <= 0.0031308 ? value * 12.92 : 1.055 * std::pow(value, 1.0 / 2.4) - 0.055);
}

float number_of(const std::vector<double> &list, size_t i, double fallback) {
	return float(i < list.size() && std::isfinite(list[i]) ? list[i] : fallback);
}

// "%20" is a blank.
std::string unescaped(std::string_view uri) {
	const auto digit = [](char c) { return c >= '0' && c <= '9' ? c - '0' : (c | 0x20) >= 'a' && (c | 0x20) <= 'f' ? (c | 0x20) - 'a' + 10 : -1; };
	std::string result;
	for (size_t i = 0; i < uri.size(); ++i) {
		const bool is_escape = uri[i] == '%' && i + 2 < uri.size() && digit(uri[i + 1]) >= 0 && digit(uri[i + 2]) >= 0;
		result += is_escape ? char(digit(uri[i + 1]) * 16 + digit(uri[i + 2])) : uri[i];
		i += is_escape ? 2 : 0;
	}
	return result;
}

std::string file_of(const tinygltf::Model &model, int texture, const std::string &path) {
	const int image = texture >= 0 && size_t(texture) < model.textures.size() ? model.textures[size_t(texture)].source : -1;
	if (image < 0 || size_t(image) >= model.images.size()) {
		return {};
	}
	const std::string &uri = model.images[size_t(image)].uri;
	return uri.empty() ? path + "#" + std::to_string(image) : resolve_import(path, unescaped(uri));
}

} // namespace

std::vector<TexturePlace> textures_of(const tinygltf::Material &material) {
	const tinygltf::PbrMetallicRoughness &pbr = material.pbrMetallicRoughness;
	const auto place = [](TextureUse use, const auto &info) { return TexturePlace{ use, info.index, info.texCoord }; };
	return { place(TextureUse::Color, pbr.baseColorTexture), place(TextureUse::Normal, material.normalTexture),
		place(TextureUse::Emissive, material.emissiveTexture), place(TextureUse::Occlusion, material.occlusionTexture),
		place(TextureUse::Roughness, pbr.metallicRoughnessTexture), place(TextureUse::Metallic, pbr.metallicRoughnessTexture) };
}

Material material_of_gltf(const tinygltf::Model &model, const tinygltf::Material &source, const std::string &path) {
	const tinygltf::PbrMetallicRoughness &pbr = source.pbrMetallicRoughness;
	Material material;
	material.name = source.name;
	for (int i = 0; i < 3; ++i) {
		material.color[i] = to_srgb(number_of(pbr.baseColorFactor, size_t(i), 1.0));
	}
	material.color.a = source.alphaMode == "BLEND" ? std::clamp(number_of(pbr.baseColorFactor, 3, 1.0), 0.0f, 1.0f) : 1.0f;
	material.roughness = std::clamp(float(pbr.roughnessFactor), 0.0f, 1.0f);
	material.metallic = std::clamp(float(pbr.metallicFactor), 0.0f, 1.0f);
	material.is_double_sided = source.doubleSided;
	for (int i = 0; i < 3; ++i) {
		material.emissive[i] = to_srgb(number_of(source.emissiveFactor, size_t(i), 0.0));
	}
	for (const TexturePlace &place : textures_of(source)) {
		const std::string file = file_of(model, place.texture, path);
		if (!file.empty()) {
			material.maps.push_back({ .use = place.use, .file = file });
		}
	}
	std::ranges::sort(material.maps, {}, &TextureMap::use);
	return material;
}

} // namespace pcg
