#include "core/cga/material_table.h"

#include <algorithm>
#include <bit>
#include <string>

#include "core/base/random.h"

namespace pcg::cga {

namespace {

glm::vec4 mixed_color(const Material &asset, const Look &look) {
	const glm::vec4 &color = (look.parts & bit_of(LookPart::Color)) != 0 ? look.color : asset.color;
	const glm::vec4 &opacity = (look.parts & bit_of(LookPart::Opacity)) != 0 ? look.color : asset.color;
	return { color.r, color.g, color.b, opacity.a };
}

// Of what differs most often. Equal materials have equal hashes: -0 is 0.
uint64_t hash_of(const Material &material) {
	uint64_t result = hash_text(material.name);
	for (const float value : { material.color.r, material.color.g, material.color.b, material.color.a, material.roughness, material.metallic }) {
		result = derive_seed(result, std::bit_cast<uint32_t>(value + 0.0f));
	}
	for (const TextureMap &map : material.maps) {
		result = derive_seed(result, hash_text(map.file));
	}
	return result;
}

void set_map(std::vector<TextureMap> &maps, TextureUse use, const TextureSlot &slot, std::string_view file) {
	std::erase_if(maps, [&](const TextureMap &map) { return map.use == use; });
	if (!file.empty()) {
		const auto place = std::ranges::lower_bound(maps, use, {}, &TextureMap::use);
		maps.insert(place, { use, std::string(file), slot.scale_u, slot.scale_v, slot.shift_u, slot.shift_v, slot.turn });
	}
}

} // namespace

void MaterialTable::begin() {
	_materials.clear();
	_index_of_materials.clear();
	_known.clear();
	_known_textures.clear();
	_index_of_known.clear();
	if (!_look_materials.empty()) {
		_look_materials.clear();
		_index_of_looks.clear();
	}
	_last = 0;
}

uint16_t MaterialTable::asset_material(const Material &material) {
	const auto found = std::ranges::find(_asset_materials, material);
	const size_t index = size_t(found - _asset_materials.begin());
	if (found == _asset_materials.end()) {
		if (is_full()) {
			return 0;
		}
		_asset_materials.push_back(material);
	}
	return uint16_t(index + 1);
}

const Material *MaterialTable::asset(uint16_t asset_material) const {
	const size_t look = size_t(most_names - asset_material);
	return asset_material == 0 ? nullptr : look < _look_materials.size() ? &_look_materials[look] : &_asset_materials[asset_material - 1u];
}

uint16_t MaterialTable::look_material(const Look &look, uint16_t asset_material) {
	Material material = make(look, asset_material);
	const uint64_t hash = hash_of(material);
	uint32_t index = _index_of_looks.find(hash, [&](uint32_t known) { return _look_materials[known] == material; });
	if (index == HashIndex::none) {
		if (is_full()) {
			return 0;
		}
		index = _index_of_looks.add(hash);
		_look_materials.push_back(std::move(material));
	}
	return uint16_t(most_names - index);
}

uint32_t MaterialTable::index_of(const Look &look, uint16_t asset_material) {
	if (_last < _known.size() && is(_known[_last], look, asset_material)) {
		return _known[_last].material;
	}
	const uint64_t hash = derive_seed(hash_of(look), asset_material);
	_last = _index_of_known.find(hash, [&](uint32_t known) { return is(_known[known], look, asset_material); });
	if (_last == HashIndex::none) {
		_last = _index_of_known.add(hash);
		_known.push_back({ look, asset_material, add(make(look, asset_material)) });
		if (look.textures != nullptr) {
			_known.back().look.textures = &_known_textures.emplace_back(*look.textures);
		}
	}
	return _known[_last].material;
}

// Looks that differ only in what set them give one material.
uint32_t MaterialTable::add(Material material) {
	const uint64_t hash = hash_of(material);
	uint32_t index = _index_of_materials.find(hash, [&](uint32_t known) { return _materials[known] == material; });
	if (index == HashIndex::none) {
		index = _index_of_materials.add(hash);
		_materials.push_back(std::move(material));
	}
	return index;
}

Material MaterialTable::make(const Look &look, uint16_t asset_material) const {
	const Material *brought = asset(asset_material);
	const bool is_asset = brought != nullptr;
	Material result = is_asset ? *brought : Material();
	const auto is_own = [&](LookPart part) { return !is_asset || (look.parts & bit_of(part)) != 0; };
	const auto take = [&](LookPart part, auto &target, const auto &value) {
		if (is_own(part)) {
			target = value;
		}
	};
	take(LookPart::Name, result.name, _texts.text(look.name));
	take(LookPart::Shader, result.shader, _texts.text(look.shader));
	result.color = is_asset ? mixed_color(result, look) : look.color;
	take(LookPart::Ambient, result.ambient, look.ambient);
	take(LookPart::Specular, result.specular, look.specular);
	take(LookPart::Emissive, result.emissive, look.emissive);
	take(LookPart::Shininess, result.shininess, look.shininess);
	take(LookPart::Reflectivity, result.reflectivity, look.reflectivity);
	take(LookPart::BumpValue, result.bump_value, look.bump_value);
	take(LookPart::Metallic, result.metallic, look.metallic);
	take(LookPart::Roughness, result.roughness, look.roughness);
	take(LookPart::DoubleSided, result.is_double_sided, look.is_double_sided);
	set_textures(result, look, is_asset);
	return result;
}

void MaterialTable::set_textures(Material &material, const Look &look, bool is_asset) const {
	for (size_t i = 0; look.textures != nullptr && i < texture_use_count; ++i) {
		const TextureUse use = TextureUse(i);
		const TextureSlot &slot = look.texture(use);
		const TextureMap *brought = material.map(use);
		if (!is_asset || (look.parts & bit_of(use)) != 0) {
			set_map(material.maps, use, slot, _texts.text(slot.path != 0 ? slot.path : slot.file));
		} else if (brought != nullptr && slot.is_placed) { // rules have moved the model's picture
			set_map(material.maps, use, slot, std::string(brought->file));
		}
	}
}

} // namespace pcg::cga
