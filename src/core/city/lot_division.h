#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "core/base/random.h"
#include "core/geometry/overlay.h"

// Cuts the building land of a block into lots. In plan: x east, y north, metres.
namespace pcg {

// A piece of building land: counter-clockwise, with the width of the street on which each edge lies, 0 = none.
struct Parcel {
	Loop2 outline;
	std::vector<float> street_widths;
};

struct LotSize {
	double front = 20.0; // wanted, along the street
	double depth = 20.0;
	double jitter = 0.0; // 0 to 0.25: how far a boundary may move, as a part of the front or the depth
};

// Halves the land until the parts have about the wanted size, but only where both halves keep a street; so every lot has one, and lots in the
// middle of a large block are deep rather than walled in. The parts cover the land; their boundaries are straight, and each begins with its front,
// its longest edge on a street. Nothing if the land is too small or too narrow for a lot.
std::vector<Parcel> divide_land(const Parcel &land, const LotSize &size, Random random);

// For land with four corners: `along` times `deep` (1 or 2) lots, whatever their size; the first row lies along the first edge.
std::vector<Parcel> divide_rows(const Parcel &land, uint32_t along, uint32_t deep);

} // namespace pcg
