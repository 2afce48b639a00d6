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

struct RgbaImage {
	uint32_t width = 0;
	uint32_t height = 0;
	std::vector<uint8_t> pixels; // red, green, blue, opacity; rows from the top
};

using GroundPolygon = std::vector<glm::vec3>;

// What lies under the heat; later ones cover earlier ones. On streets, which are neither, the paper stays white.
struct GroundPlan {
	std::vector<GroundPolygon> lots; // grey
	std::vector<GroundPolygon> walkable; // pale: what stays grey of a lot are its buildings, trees and benches
};

struct HeatMapStyle {
	uint32_t pixels_per_cell = 2;
	// Person-seconds per cell that get the darkest color; 0: the 97th percentile of the cells that were entered. No cell counts for more than
	// that: a bench where somebody sits for hours is a spot on the map and neither pales nor covers the ways.
	double darkest = 0.0;
};

// The heat over a plan of the ground, from pale yellow over orange to dark violet (lightness falls evenly, so it reads in grey too), with the
// square root of the time, since a few doors see most of it. Between the middles of cells it changes evenly.
RgbImage draw_heat_map(const HeatMap &map, const GroundPlan &plan, const HeatMapStyle &style = {});

// The same heat alone, transparent where nobody was, to be laid over a city. Covers the map's whole grid.
RgbaImage draw_heat_overlay(const HeatMap &map, const HeatMapStyle &style = {});

} // namespace pcg
