#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>

#include "core/city/city.h"
#include "core/geometry/overlay.h"

// Where one walks on lots, as they were laid out and as they stand after edits by hand.
namespace pcg {

// The lot's free ground without what other lots in its courtyards stand on, where they were laid out. Convex pieces.
std::vector<std::vector<glm::vec3>> lot_ground(const City &city, LotId lot);

// A lot that stands in the city.
struct PlacedLot {
	uint64_t object = 0; // what shows it; a lot that was copied is shown twice
	LotId lot = LotId::Invalid;
	glm::mat4 motion{ 1.0f }; // from where it was laid out
	bool is_at_home = true; // there
};

// In plan: its outline counter-clockwise, then its courtyards clockwise, also where it was mirrored or turned over.
Loops2 outline_of(const Layout &layout, const PlacedLot &placed);

// What all lots that stand in the city make of the ground for walking, which was made of them at home: by layer, then by lot where one has left,
// or by object where one stands. Who stands in whose courtyard is as they stand now.
LayeredPatches patches_of_lots(const City &city, std::span<const PlacedLot> lots);

} // namespace pcg
