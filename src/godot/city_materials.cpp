#include "godot/city_materials.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include <godot_cpp/classes/file_access.hpp>
#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/image_texture.hpp>
#include <godot_cpp/classes/mesh.hpp>
#include <godot_cpp/classes/resource_loader.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_color_array.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>
#include <godot_cpp/variant/packed_vector2_array.hpp>

#include "core/geometry/shown_material.h"
#include "core/io/asset_reader.h"
#include "core/io/picture.h"
#include "godot/convert.h"
#include "godot/ports/engine_tree.h"

using namespace godot;

namespace pcg {

namespace {

// Plain surfaces come in three degrees of roughness and as metal or not, so that a lot costs few draw calls; with pictures each is what it says.
float engine_roughness(const Material &material) {
	const float roughness = shown_roughness(material);
	if (!material.maps.empty()) {
		return roughness;
	}
	return roughness >= 0.6f ? 0.9f : roughness >= 0.25f ? 0.45f : 0.15f;
}

float engine_metallic(const Material &material) {
	return material.maps.empty() ? std::round(material.metallic) : material.metallic;
}

bool is_clear(const Material &material) {
	return material.color.a < 1.0f || material.map(TextureUse::Opacity) != nullptr;
}

// Equal for materials that differ by their colour only.
std::string key_of(const Material &material) {
	std::string key;
	const auto add = [&key](float value) { key += std::to_string(value) + " "; };
	add(engine_roughness(material));
	add(engine_metallic(material));
	const glm::vec3 light = shown_emissive(material);
	add(light.r);
	add(light.g);
	add(light.b);
	key += is_clear(material) ? "c" : "s";
	key += material.is_double_sided ? "2" : "1";
	for (const TextureMap &map : material.maps) {
		key += "|" + std::to_string(int(map.use)) + map.file + " ";
		for (const float value : { map.scale_u, map.scale_v, map.shift_u, map.shift_v }) {
			add(value);
		}
	}
	return key;
}

// Of one material, from several surfaces.
struct Arrays {
	PackedVector3Array positions, normals;
	PackedColorArray colors;
	PackedVector2Array uvs, second_uvs;
	PackedFloat32Array tangents;
	PackedInt32Array indices;

	void add(const MeshSurface &surface, const Color &color, bool has_tangents) {
		const int32_t first = int32_t(positions.size());
		positions.append_array(pcg::to_godot(std::span<const glm::vec3>(surface.positions)));
		normals.append_array(pcg::to_godot(std::span<const glm::vec3>(surface.normals)));
		const int64_t count = colors.size();
		colors.resize(positions.size());
		Color *out = colors.ptrw();
		for (int64_t i = count; i < positions.size(); ++i) {
			out[i] = color;
		}
		const std::vector<glm::vec2> &dirt = surface.uvs[size_t(TextureUse::Dirt)];
		add_uvs(uvs, surface.uvs[0], surface.positions.size());
		add_uvs(second_uvs, dirt.empty() ? surface.uvs[0] : dirt, surface.positions.size());
		if (has_tangents) {
			add_tangents(surface);
		}
		const int64_t index_count = indices.size();
		indices.resize(index_count + int64_t(surface.indices.size()));
		int32_t *index = indices.ptrw() + index_count;
		for (size_t i = 0; i + 2 < surface.indices.size(); i += 3) {
			*index++ = first + int32_t(surface.indices[i]);
			*index++ = first + int32_t(surface.indices[i + 2]);
			*index++ = first + int32_t(surface.indices[i + 1]);
		}
	}

	static void add_uvs(PackedVector2Array &target, const std::vector<glm::vec2> &source, size_t count) {
		const int64_t first = target.size();
		target.resize(first + int64_t(count));
		Vector2 *out = target.ptrw() + first;
		for (size_t i = 0; i < count; ++i) {
			out[i] = i < source.size() ? Vector2(source[i].x, 1.0f - source[i].y) : Vector2();
		}
	}

	// Along u, made perpendicular to the normal; the sign says whether v runs as the normal map expects.
	void add_tangents(const MeshSurface &surface) {
		std::vector<glm::vec3> along_u(surface.positions.size(), glm::vec3(0.0f)), along_v(along_u);
		for (size_t i = 0; i + 2 < surface.indices.size() && !surface.uvs[0].empty(); i += 3) {
			const uint32_t a = surface.indices[i], b = surface.indices[i + 1], c = surface.indices[i + 2];
			const glm::vec3 p = surface.positions[b] - surface.positions[a], q = surface.positions[c] - surface.positions[a];
			const glm::vec2 s = surface.uvs[0][b] - surface.uvs[0][a], t = surface.uvs[0][c] - surface.uvs[0][a];
			const float area = s.x * t.y - s.y * t.x;
			if (std::abs(area) > 1e-12f) {
				for (const uint32_t corner : { a, b, c }) {
					along_u[corner] += (p * t.y - q * s.y) / area;
					along_v[corner] += (q * s.x - p * t.x) / area;
				}
			}
		}
		for (size_t i = 0; i < along_u.size(); ++i) {
			const glm::vec3 normal = surface.normals[i];
			glm::vec3 tangent = along_u[i] - normal * glm::dot(normal, along_u[i]);
			tangent = glm::dot(tangent, tangent) > 1e-12f ? glm::normalize(tangent) : glm::vec3(1.0f, 0.0f, 0.0f);
			for (const float value : { tangent.x, tangent.y, tangent.z, glm::dot(glm::cross(normal, tangent), along_v[i]) < 0.0f ? -1.0f : 1.0f }) {
				tangents.push_back(value);
			}
		}
	}

	void add_to(const Ref<ArrayMesh> &mesh, const CityMaterials::Entry &entry) const {
		Array arrays;
		arrays.resize(godot::Mesh::ARRAY_MAX);
		arrays[godot::Mesh::ARRAY_VERTEX] = positions;
		arrays[godot::Mesh::ARRAY_NORMAL] = normals;
		arrays[godot::Mesh::ARRAY_COLOR] = colors;
		arrays[godot::Mesh::ARRAY_TEX_UV] = uvs;
		arrays[godot::Mesh::ARRAY_TEX_UV2] = second_uvs;
		if (entry.has_normal_map) {
			arrays[godot::Mesh::ARRAY_TANGENT] = tangents;
		}
		arrays[godot::Mesh::ARRAY_INDEX] = indices;
		mesh->add_surface_from_arrays(godot::Mesh::PRIMITIVE_TRIANGLES, arrays);
		mesh->surface_set_material(mesh->get_surface_count() - 1, entry.material);
	}
};

} // namespace

const CityMaterials::Entry &CityMaterials::of(const Material &material) {
	const auto [place, is_new] = _entries.try_emplace(key_of(material));
	if (is_new) {
		place->second = { make(material), material.map(TextureUse::Normal) != nullptr };
	}
	return place->second;
}

Ref<StandardMaterial3D> CityMaterials::make(const Material &material) {
	Ref<StandardMaterial3D> result;
	result.instantiate();
	result->set_flag(BaseMaterial3D::FLAG_ALBEDO_FROM_VERTEX_COLOR, true);
	result->set_flag(BaseMaterial3D::FLAG_SRGB_VERTEX_COLOR, true);
	result->set_roughness(engine_roughness(material));
	result->set_metallic(engine_metallic(material));
	if (is_clear(material)) {
		result->set_transparency(material.color.a < 1.0f ? BaseMaterial3D::TRANSPARENCY_ALPHA : BaseMaterial3D::TRANSPARENCY_ALPHA_DEPTH_PRE_PASS);
	}
	if (material.is_double_sided) {
		result->set_cull_mode(BaseMaterial3D::CULL_DISABLED);
	}
	const glm::vec3 light = shown_emissive(material);
	if (light != glm::vec3(0.0f)) {
		result->set_feature(BaseMaterial3D::FEATURE_EMISSION, true);
		result->set_emission(pcg::to_godot(glm::vec4(light, 1.0f)));
	}
	set_pictures(result, material);
	return result;
}

void CityMaterials::set_pictures(const Ref<StandardMaterial3D> &target, const Material &material) {
	const TextureMap *color = material.map(TextureUse::Color), *dirt = material.map(TextureUse::Dirt);
	const TextureMap *opacity = material.map(TextureUse::Opacity), *base = color != nullptr ? color : dirt;
	if (opacity != nullptr && (base == nullptr || base->file != opacity->file)) {
		target->set_texture(BaseMaterial3D::TEXTURE_ALBEDO, clear_picture(base, *opacity));
		base = base != nullptr ? base : opacity;
	} else {
		set_picture(target, BaseMaterial3D::TEXTURE_ALBEDO, base);
	}
	if (base != nullptr) { // v runs down here
		target->set_uv1_scale(Vector3(base->scale_u, base->scale_v, 1.0f));
		target->set_uv1_offset(Vector3(base->shift_u, 1.0f - base->scale_v - base->shift_v, 0.0f));
	}
	if (color != nullptr && set_picture(target, BaseMaterial3D::TEXTURE_DETAIL_ALBEDO, dirt)) {
		target->set_feature(BaseMaterial3D::FEATURE_DETAIL, true);
		target->set_detail_blend_mode(BaseMaterial3D::BLEND_MODE_MUL);
		target->set_detail_uv(BaseMaterial3D::DETAIL_UV_2);
	}
	if (set_picture(target, BaseMaterial3D::TEXTURE_NORMAL, material.map(TextureUse::Normal))) {
		target->set_feature(BaseMaterial3D::FEATURE_NORMAL_MAPPING, true);
	}
	if (set_picture(target, BaseMaterial3D::TEXTURE_AMBIENT_OCCLUSION, material.map(TextureUse::Occlusion))) {
		target->set_feature(BaseMaterial3D::FEATURE_AMBIENT_OCCLUSION, true);
		target->set_ao_texture_channel(BaseMaterial3D::TEXTURE_CHANNEL_RED);
	}
	if (set_picture(target, BaseMaterial3D::TEXTURE_ROUGHNESS, material.map(TextureUse::Roughness))) {
		target->set_roughness_texture_channel(BaseMaterial3D::TEXTURE_CHANNEL_GREEN);
	}
	if (set_picture(target, BaseMaterial3D::TEXTURE_METALLIC, material.map(TextureUse::Metallic))) {
		target->set_metallic_texture_channel(BaseMaterial3D::TEXTURE_CHANNEL_BLUE);
	}
	if (set_picture(target, BaseMaterial3D::TEXTURE_EMISSION, material.map(TextureUse::Emissive))) {
		target->set_emission_operator(BaseMaterial3D::EMISSION_OP_MULTIPLY);
	}
}

bool CityMaterials::set_picture(const Ref<StandardMaterial3D> &target, BaseMaterial3D::TextureParam slot, const TextureMap *map) {
	const Ref<Texture2D> texture = map != nullptr ? picture(map->file) : Ref<Texture2D>();
	if (texture.is_null()) {
		return false;
	}
	target->set_texture(slot, texture);
	return true;
}

namespace {

// Null, or an empty one, if it cannot be read.
Ref<Image> read_image(const std::string &file) {
	const String path = pcg::to_godot(std::string_view(file));
	if (FileAccess::file_exists(path)) {
		return Image::load_from_file(path);
	}
	constexpr size_t limit = size_t(256) << 20;
	const Result<std::string> bytes = read_picture(EngineTree(), file, limit); // one within a glTF file
	Ref<Image> image;
	if (bytes) {
		const PackedByteArray buffer = to_bytes(*bytes);
		image.instantiate();
		bytes->starts_with("\x89PNG") ? image->load_png_from_buffer(buffer) : image->load_jpg_from_buffer(buffer);
	}
	return image;
}

} // namespace

// Imported pictures of the project as resources; others are read as they are.
Ref<Texture2D> CityMaterials::picture(const std::string &file) {
	const auto [place, is_new] = _pictures.try_emplace(file);
	if (!is_new) {
		return place->second;
	}
	const String path = pcg::to_godot(std::string_view(file));
	ResourceLoader *loader = ResourceLoader::get_singleton();
	if (loader->exists(path, "Texture2D")) {
		place->second = loader->load(path, "Texture2D");
		return place->second;
	}
	const Ref<Image> image = read_image(file);
	if (image.is_valid() && !image->is_empty()) {
		image->generate_mipmaps();
		place->second = ImageTexture::create_from_image(image);
	}
	return place->second;
}

namespace {

// Nothing if there is none or its format cannot be unpacked.
std::optional<Picture> to_picture(const Ref<Image> &image) {
	if (image.is_null() || image->is_empty() || (image->is_compressed() && image->decompress() != OK)) {
		return std::nullopt;
	}
	const bool has_alpha = image->detect_alpha() != Image::ALPHA_NONE;
	image->clear_mipmaps();
	image->convert(Image::FORMAT_RGBA8);
	const PackedByteArray bytes = image->get_data();
	return Picture{ { uint32_t(image->get_width()), uint32_t(image->get_height()) }, { bytes.ptr(), bytes.ptr() + bytes.size() }, has_alpha };
}

Ref<Image> to_image(const Picture &picture) {
	return Image::create_from_data(int32_t(picture.size.x), int32_t(picture.size.y), false, Image::FORMAT_RGBA8, to_bytes(picture.pixels));
}

} // namespace

// The engine takes opacity from the colour's alpha channel: one picture of two.
Ref<Texture2D> CityMaterials::clear_picture(const TextureMap *color, const TextureMap &opacity) {
	const auto [place, is_new] = _pictures.try_emplace((color != nullptr ? color->file : std::string()) + "\n" + opacity.file);
	if (!is_new) {
		return place->second;
	}
	const auto pixels = [this](const std::string &file) {
		const Ref<Texture2D> texture = picture(file);
		return texture.is_valid() ? to_picture(texture->get_image()) : std::nullopt;
	};
	const std::optional<Picture> first = color != nullptr ? pixels(color->file) : std::nullopt, second = pixels(opacity.file);
	if (!second) {
		place->second = color != nullptr ? picture(color->file) : Ref<Texture2D>();
		return place->second;
	}
	const Ref<Image> image = to_image(with_opacity(first ? &*first : nullptr, *second));
	image->generate_mipmaps();
	place->second = ImageTexture::create_from_image(image);
	return place->second;
}

Ref<ArrayMesh> CityMaterials::to_godot(const Mesh &mesh, const std::vector<Material> &materials, bool is_white) {
	std::vector<std::pair<const Entry *, Arrays>> parts; // few; in order of their first surface
	for (const MeshSurface &surface : make_surfaces(mesh)) {
		const Material material = surface.material < materials.size() ? materials[surface.material] : Material();
		const Entry *entry = &of(material);
		size_t part = 0;
		while (part < parts.size() && parts[part].first != entry) {
			++part;
		}
		if (part == parts.size()) {
			parts.emplace_back(entry, Arrays());
		}
		parts[part].second.add(surface, is_white ? Color(1, 1, 1) : pcg::to_godot(material.color), entry->has_normal_map);
	}
	Ref<ArrayMesh> result;
	if (parts.empty()) {
		return result;
	}
	result.instantiate();
	for (const auto &[entry, arrays] : parts) {
		arrays.add_to(result, *entry);
	}
	return result;
}

} // namespace pcg
