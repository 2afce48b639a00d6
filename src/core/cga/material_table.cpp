#include "core/cga/material_table.h"

#include <algorithm>
#include <string>

#include "core/base/random.h"

namespace pcg::cga {

namespace {

glm::vec4 mixed_color(const Material &asset, const Look &look) {
	const glm::vec4 &color = (look.parts & bit_of(LookPart::Color)) != 0 ? look.color : asset.color;
	const glm::vec4 &opacity = (look.parts & bit_of(LookPart::Opacity)) != 0 ? look.color : asset.color;
	return { color.r, color.g, color.b, opacity.a };
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
	_known.clear();
	_known_of_hash.clear();
	_last = 0;
}

uint16_t MaterialTable::asset_material(const Material &material) {
	const auto found = std::ranges::find(_asset_materials, material);
	const size_t index = size_t(found - _asset_materials.begin());
	if (found == _asset_materials.end() && index < 0xFFFF) {
		_asset_materials.push_back(material);
	}
	return index < 0xFFFF ? uint16_t(index + 1) : uint16_t(0);
}

uint32_t MaterialTable::index_of(const Look &look, uint16_t asset_material) {
	if (_last < _known.size() && is(_known[_last], look, asset_material)) {
		return _known[_last].material;
	}
	const uint64_t hash = derive_seed(hash_of(look), asset_material);
	const auto [first, end] = _known_of_hash.equal_range(hash);
	for (auto entry = first; entry != end; ++entry) {
		if (is(_known[entry->second], look, asset_material)) {
			_last = entry->second;
			return _known[_last].material;
		}
	}
	_last = uint32_t(_known.size());
	_known_of_hash.emplace(hash, _last);
	_known.push_back({ look, look.textures != nullptr ? *look.textures : TextureSlots(), asset_material, add(make(look, asset_material)) });
	_known.back().look.textures = look.textures != nullptr ? &_known.back().textures : nullptr;
	return _known.back().material;
}

// Looks that differ only in what set them give one material; there are few where it matters.
uint32_t MaterialTable::add(Material material) {
	constexpr size_t most_compared = 64;
	const size_t first = _materials.size() > most_compared ? _materials.size() - most_compared : 0;
	const auto found = std::find(_materials.begin() + std::ptrdiff_t(first), _materials.end(), material);
	if (found != _materials.end()) {
		return uint32_t(found - _materials.begin());
	}
	_materials.push_back(std::move(material));
	return uint32_t(_materials.size()) - 1;
}

Material MaterialTable::make(const Look &look, uint16_t asset_material) const {
	const bool is_asset = asset_material > 0;
	Material result = is_asset ? _asset_materials[asset_material - 1u] : Material();
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
		if (!is_asset || (look.parts & bit_of(use)) != 0) {
			const TextureSlot &slot = look.texture(use);
			set_map(material.maps, use, slot, _texts.text(slot.path != 0 ? slot.path : slot.file));
		}
	}
}

} // namespace pcg::cga
