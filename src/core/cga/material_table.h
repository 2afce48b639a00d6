#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "core/base/hash_index.h"
#include "core/cga/look.h"
#include "core/cga/text_pool.h"
#include "core/geometry/material.h"

namespace pcg::cga {

// The materials of a model: each look, on each material of an inserted asset, once, in order of first use.
class MaterialTable {
public:
	void begin();
	std::vector<Material> take() { return std::move(_materials); }

	// For GeometryFace::material, also after begin(): assets are kept. 0 if there are too many.
	uint16_t asset_material(const Material &material);
	// What a GeometryFace::material names; nullptr: nothing, the face has its shape's look.
	const Material *asset(uint16_t asset_material) const;
	// The same, until begin(), of what a look says of faces with that material: faces that keep it when their shape gets another look.
	uint16_t look_material(const Look &look, uint16_t asset_material);
	// There is no name left for another.
	bool is_full() const { return _asset_materials.size() + _look_materials.size() >= most_names; }
	// Of a shape's own faces (0) and of those with an asset's material: that one, with what rules have set themselves.
	uint32_t index_of(const Look &look, uint16_t asset_material);
	TextPool &texts() { return _texts; }
	const TextPool &texts() const { return _texts; }

private:
	struct Known {
		Look look;
		uint16_t asset_material = 0;
		uint32_t material = 0;
	};
	bool is(const Known &known, const Look &look, uint16_t asset_material) const {
		return known.asset_material == asset_material && is_same(known.look, look);
	}
	static constexpr uint32_t most_names = UINT16_MAX;
	Material make(const Look &look, uint16_t asset_material) const;
	void set_textures(Material &material, const Look &look, bool is_asset) const;
	uint32_t add(Material material);

	TextPool _texts;
	std::vector<Material> _materials;
	std::vector<Material> _asset_materials; // named 1, 2 ..
	std::vector<Material> _look_materials; // named from the largest number down: what assets are called does not depend on them
	HashIndex _index_of_looks;
	HashIndex _index_of_materials;
	std::vector<Known> _known;
	std::deque<TextureSlots> _known_textures; // the known looks point into it
	HashIndex _index_of_known;
	uint32_t _last = 0; // in _known
};

} // namespace pcg::cga
