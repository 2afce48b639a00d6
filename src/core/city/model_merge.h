#pragma once

#include <map>

#include "core/cga/derivation.h"

// Makes one model of what was derived piece by piece.
namespace pcg {

// Materials that are equal become one, and so do prototypes that share a mesh and look alike; so a street of many pieces has few surfaces.
// Reports, prints and diagnostics are not taken along.
class ModelMerge {
public:
	void add(const cga::DerivationResult &piece);
	cga::DerivationResult take() { return std::move(_whole); }

private:
	uint32_t add_material(const Material &material);
	uint32_t add_prototype(const cga::ModelPrototype &source, const std::vector<uint32_t> &materials);

	cga::DerivationResult _whole;
	std::multimap<std::string, uint32_t> _materials; // by name: few have the same
};

} // namespace pcg
