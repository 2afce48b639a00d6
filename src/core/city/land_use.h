#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "core/base/diagnostic.h"

// Which lot becomes what: shares of types, for the whole city or by district.
namespace pcg {

// Painted weights over the city's extent: row by row from its north-west corner, 0 (none) to 1 (full).
struct WeightMap {
	uint32_t width = 0, height = 0; // at least 1
	std::vector<float> values;

	// Between the middles of four pixels; `position` in fractions of the extent.
	float at(glm::vec2 position) const;
};

struct LandUse {
	std::string type; // "house", "school" ..: also the name under which the lot's rules are found
	double weight = 1.0; // >= 0, finite; relative to the others
	std::shared_ptr<const WeightMap> map = {}; // the weight is multiplied by it; null: the same everywhere
};

// A rectangle of the city with shares of its own. Fractions of the city's extent, (0, 0) = its north-west corner, (1, 1) = south-east.
struct District {
	glm::vec2 min{ 0.0f };
	glm::vec2 max{ 1.0f };
	std::vector<LandUse> uses;
};

// What a small town needs: mostly houses. Each type is the name of a file in rules/cga.
std::vector<LandUse> default_land_use();
// The paper's structured city: houses top left, workplaces bottom right, shops and schools in the other two quadrants, each with some parks.
std::vector<District> quadrant_districts();

// A type for each of `positions` (fractions of the extent, as above). The first district that contains a position decides, else `uses`. Shares are met
// to the nearest whole lot, and every type with a weight gets at least one lot where there are enough; too few lots: a warning. Wrong weights, types
// without name or no types at all: an error, and nothing is returned. With maps a type stands only where its own is not black, and gets as many lots
// as its weights at all of them add up to; lots where all maps are black follow the weights alone, with a warning. Districts know no maps.
std::vector<std::string> assign_land_use(std::span<const glm::vec2> positions, const std::vector<LandUse> &uses,
		const std::vector<District> &districts, uint64_t seed, Diagnostics &diagnostics);

} // namespace pcg
