#include "core/io/gltf_materials.h"

#include <bit>
#include <cmath>

#include <nlohmann/json.hpp>

#include "core/geometry/shown_material.h"
#include "core/io/asset_reader.h"
#include "core/io/utf8.h"

namespace pcg {

namespace {

constexpr double degree = 0.017453292519943295;
constexpr const char *transform_extension = "KHR_texture_transform";
constexpr const char *unreadable = "this picture cannot be read; surfaces that have it are plain in the file";
constexpr size_t most_bytes = size_t(256) << 20; // of one picture

// glTF's factors are linear.
double to_linear(float srgb) {
	const double value = std::fmin(1.0, std::fmax(0.0, double(srgb)));
	return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

double unit(float value) {
	return std::fmin(1.0, std::fmax(0.0, double(value)));
}

template <typename T> void append(std::string &key, const T &value) {
	key.append(reinterpret_cast<const char *>(&value), sizeof(value));
}
void append_text(std::string &key, const std::string &text) {
	append(key, text.size());
	key += text;
}

// Equal materials give equal keys.
std::string key_of(const Material &material, uint32_t sets) {
	std::string key;
	append_text(key, material.name);
	append(key, material.color);
	append(key, material.specular);
	append(key, material.emissive);
	for (const float value : { material.roughness, material.metallic, material.shininess, material.reflectivity }) {
		append(key, value);
	}
	append(key, material.is_double_sided);
	append(key, sets);
	for (const TextureMap &map : material.maps) {
		append(key, map.use);
		append_text(key, map.file);
		for (const float value : { map.scale_u, map.scale_v, map.shift_u, map.shift_v, map.turn }) {
			append(key, value);
		}
	}
	return key;
}

const char *mime_type(const std::string &bytes) {
	if (bytes.starts_with("\x89PNG")) {
		return "image/png";
	}
	return bytes.starts_with("\xFF\xD8\xFF") ? "image/jpeg" : nullptr;
}

// Coordinates in files run down the picture: v is 1 - v there, and so is the way they are scaled, turned and shifted.
tinygltf::Value transform_of(const TextureMap &map) {
	const double cosine = std::cos(double(map.turn) * degree), sine = std::sin(double(map.turn) * degree);
	const auto pair = [](double a, double b) { return tinygltf::Value(tinygltf::Value::Array{ tinygltf::Value(a), tinygltf::Value(b) }); };
	tinygltf::Value::Object transform;
	transform.emplace("offset", pair(double(map.shift_u) - double(map.scale_v) * sine, 1.0 - double(map.scale_v) * cosine - double(map.shift_v)));
	transform.emplace("scale", pair(map.scale_u, map.scale_v));
	transform.emplace("rotation", tinygltf::Value(double(map.turn) * degree));
	return tinygltf::Value(std::move(transform));
}

bool is_moved(const TextureMap &map) {
	return map.scale_u != 1.0f || map.scale_v != 1.0f || map.shift_u != 0.0f || map.shift_v != 0.0f || map.turn != 0.0f;
}

// In the file.
int used_set(const TextureMap &map, uint32_t sets) {
	const size_t own = size_t(map.use);
	return (sets & (1u << own)) != 0 ? file_set(sets, own) : 0;
}

bool lie_alike(const TextureMap &a, const TextureMap &b, uint32_t sets) {
	TextureMap other = b;
	other.use = a.use;
	other.file = a.file;
	return a == other && used_set(a, sets) == used_set(b, sets);
}

std::string file_name(const std::string &path) {
	return path.substr(path.find_last_of("/\\") + 1);
}

} // namespace

uint32_t sets_of(const std::vector<glm::vec2> *uvs) {
	uint32_t sets = 0;
	for (size_t set = 0; set < uv_set_count; ++set) {
		sets |= uvs[set].empty() ? 0u : 1u << set;
	}
	return sets;
}

int file_set(uint32_t sets, size_t set) {
	return std::popcount(sets & ((1u << set) - 1u));
}

GltfMaterials::GltfMaterials(tinygltf::Model &model, const FileTree *pictures, Diagnostics &diagnostics)
		: _model(model), _pictures(pictures != nullptr ? *pictures : _disk), _diagnostics(diagnostics) {}

int GltfMaterials::add(const Material &material, uint32_t sets) {
	const auto [place, is_new] = _materials.emplace(key_of(material, sets), int(_model.materials.size()));
	if (is_new) {
		_model.materials.push_back(to_gltf(material, sets));
	}
	return place->second;
}

tinygltf::Material GltfMaterials::to_gltf(const Material &material, uint32_t sets) {
	tinygltf::Material result;
	result.name = valid_utf8(material.name);
	result.doubleSided = material.is_double_sided;
	result.alphaMode = material.color.a < 1.0f ? "BLEND" : "OPAQUE";
	set_factors(result, material);
	if (sets != 0 && !material.maps.empty()) {
		set_textures(result, material, sets);
	}
	return result;
}

void GltfMaterials::set_factors(tinygltf::Material &target, const Material &material) const {
	tinygltf::PbrMetallicRoughness &pbr = target.pbrMetallicRoughness;
	pbr.baseColorFactor = { to_linear(material.color.r), to_linear(material.color.g), to_linear(material.color.b), unit(material.color.a) };
	pbr.roughnessFactor = unit(shown_roughness(material));
	pbr.metallicFactor = unit(material.metallic);
	const glm::vec3 light = shown_emissive(material);
	target.emissiveFactor = { to_linear(light.r), to_linear(light.g), to_linear(light.b) };
}

void GltfMaterials::set_textures(tinygltf::Material &target, const Material &material, uint32_t sets) {
	const TextureMap *occlusion = material.map(TextureUse::Occlusion);
	const bool has_color = material.map(TextureUse::Color) != nullptr;
	set_color(target, material, sets);
	set_metal(target, material, sets);
	set_texture(target.normalTexture, material.map(TextureUse::Normal), sets);
	set_texture(target.emissiveTexture, material.map(TextureUse::Emissive), sets);
	set_texture(target.occlusionTexture, occlusion != nullptr ? occlusion : has_color ? material.map(TextureUse::Dirt) : nullptr, sets);
}

// Opacity is the alpha channel of the colour's picture: where a rule has it in a picture of its own, a new picture is made of both.
void GltfMaterials::set_color(tinygltf::Material &target, const Material &material, uint32_t sets) {
	const TextureMap *color = material.map(TextureUse::Color), *opacity = material.map(TextureUse::Opacity);
	const TextureMap *base = color != nullptr ? color : material.map(TextureUse::Dirt);
	tinygltf::TextureInfo &info = target.pbrMetallicRoughness.baseColorTexture;
	if (opacity == nullptr || (base != nullptr && base->file == opacity->file)) {
		set_texture(info, base, sets);
		target.alphaMode = opacity != nullptr ? "BLEND" : target.alphaMode;
	} else if (base != nullptr && !lie_alike(*base, *opacity, sets)) {
		set_texture(info, base, sets);
		tell(opacity->file, "glTF lays colour and opacity alike; this opacity map lies otherwise than the colour map and is left out");
	} else {
		const int texture = mixed_texture(base, opacity, "opacity",
				[](const Picture *a, const Picture *b) { return b != nullptr ? with_opacity(a, *b) : *a; });
		place_texture(info, texture, base != nullptr ? *base : *opacity, sets);
		target.alphaMode = texture >= 0 ? "BLEND" : target.alphaMode;
	}
}

// One picture has roughness in green and metal in blue. A roughness map alone is taken as it is where its blue channel cannot show.
void GltfMaterials::set_metal(tinygltf::Material &target, const Material &material, uint32_t sets) {
	const TextureMap *roughness = material.map(TextureUse::Roughness), *metallic = material.map(TextureUse::Metallic);
	tinygltf::TextureInfo &info = target.pbrMetallicRoughness.metallicRoughnessTexture;
	const bool is_one_file = roughness != nullptr && metallic != nullptr && metallic->file == roughness->file;
	if (is_one_file || (metallic == nullptr && material.metallic <= 0.0f)) {
		set_texture(info, roughness, sets);
		return;
	}
	if (roughness != nullptr && metallic != nullptr && !lie_alike(*roughness, *metallic, sets)) {
		tell(metallic->file, "glTF lays roughness and metal alike; this metallic map lies otherwise than the roughness map and is left out");
		metallic = nullptr;
	}
	const TextureMap *place = roughness != nullptr ? roughness : metallic;
	if (place != nullptr) {
		place_texture(info, mixed_texture(roughness, metallic, "surface", metallic_roughness), *place, sets);
	}
}

template <typename Info> void GltfMaterials::set_texture(Info &info, const TextureMap *map, uint32_t sets) {
	if (map != nullptr) {
		place_texture(info, texture_of(map->file), *map, sets);
	}
}

template <typename Info> void GltfMaterials::place_texture(Info &info, int texture, const TextureMap &map, uint32_t sets) {
	info.index = texture;
	if (texture < 0) {
		return;
	}
	info.texCoord = used_set(map, sets);
	if (is_moved(map)) {
		info.extensions.emplace(transform_extension, transform_of(map));
		if (_model.extensionsUsed.empty()) {
			_model.extensionsUsed.push_back(transform_extension);
		}
	}
}

int GltfMaterials::texture_of(const std::string &file) {
	const auto [place, is_new] = _textures.emplace(file, -1);
	if (is_new) {
		place->second = add_file(file);
	}
	return place->second;
}

// -1 if neither picture can be read; what is missing of two is nullptr for `mix`.
template <typename Mix> int GltfMaterials::mixed_texture(const TextureMap *a, const TextureMap *b, const char *kind, Mix mix) {
	const auto name_of = [](const TextureMap *map) { return map != nullptr ? map->file : std::string(); };
	std::string key = kind;
	append_text(key, name_of(a));
	append_text(key, name_of(b));
	const auto [place, is_new] = _textures.emplace(std::move(key), -1);
	if (is_new) {
		const std::optional<Picture> first = decoded(a), second = decoded(b);
		if (first || second) {
			const Picture picture = mix(first ? &*first : nullptr, second ? &*second : nullptr);
			place->second = add_picture(file_name(a != nullptr ? a->file : b->file) + " with " + kind, "image/png", encode_png(picture));
		}
	}
	return place->second;
}

std::optional<Picture> GltfMaterials::decoded(const TextureMap *map) {
	if (map == nullptr) {
		return std::nullopt;
	}
	const Result<std::string> bytes = read_picture(_pictures, map->file, most_bytes);
	std::optional<Picture> picture = bytes ? decode_picture(*bytes) : std::nullopt;
	if (!picture) {
		tell(map->file, unreadable);
	}
	return picture;
}

int GltfMaterials::add_file(const std::string &file) {
	Result<std::string> bytes = read_picture(_pictures, file, most_bytes);
	if (!bytes) {
		tell(file, unreadable);
		return -1;
	}
	const char *type = mime_type(*bytes);
	if (type == nullptr) {
		tell(file, "only PNG and JPEG pictures go into glTF files; surfaces that have this one are plain in the file");
		return -1;
	}
	return add_picture(file_name(file), type, std::move(*bytes));
}

int GltfMaterials::add_picture(const std::string &name, const char *type, std::string bytes) {
	if (_model.samplers.empty()) {
		_model.samplers.emplace_back(); // repeats, as CGA's textures do
	}
	tinygltf::Image image;
	image.name = valid_utf8(name);
	image.mimeType = type;
	tinygltf::Texture texture;
	texture.source = int(_model.images.size());
	texture.sampler = 0;
	_model.images.push_back(std::move(image));
	_model.textures.push_back(std::move(texture));
	_bytes.push_back(std::move(bytes));
	return int(_model.textures.size()) - 1;
}

void GltfMaterials::tell(const std::string &file, const std::string &message) {
	if (_told.insert(file).second) {
		_diagnostics.add({ Severity::Warning, "picture-left-out", file, 0, 0, message, "", {} });
	}
}

void GltfMaterials::finish(tinygltf::Buffer &buffer) {
	for (size_t i = 0; i < _bytes.size(); ++i) {
		tinygltf::BufferView view;
		view.buffer = 0;
		view.byteOffset = buffer.data.size();
		view.byteLength = _bytes[i].size();
		buffer.data.insert(buffer.data.end(), _bytes[i].begin(), _bytes[i].end());
		_bytes[i] = {};
		_model.images[i].bufferView = int(_model.bufferViews.size());
		_model.bufferViews.push_back(std::move(view));
	}
}

} // namespace pcg
