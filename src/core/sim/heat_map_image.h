#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/sim/heat_map.h"

namespace pcg {

struct RgbImage {
	uint32_t width = 0;
	uint32_t height = 0;
	std::vector<uint8_t> pixels; // red, green, blue; rows from the top
};

using GroundPolygon = std::vector<glm::vec3>;

struct HeatMapStyle {
	uint32_t pixels_per_cell = 2;
	// Person-seconds per cell that get the darkest color; 0: the 97th percentile of the cells that were
	// entered, so that a few benches where people sit for hours do not pale all the ways.
	double darkest = 0.0;
};

// The heat over a plan of the ground: white, `footprints` light grey, heat from pale yellow over orange to dark violet (lightness falls
// evenly, so it reads in grey too), with the square root of the time, since a few doors see most of it.
RgbImage draw_heat_map(const HeatMap &map, std::span<const GroundPolygon> footprints, const HeatMapStyle &style = {});

} // namespace pcg
