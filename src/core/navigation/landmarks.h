#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/navigation/sight.h"

// Far-off corners to which all distances are known: CornerGraph estimates from them how far it still is.
namespace pcg {

// `count` corners, as far from each other as the crow flies as can be, all on the ground on which most corners are.
std::vector<uint32_t> choose_landmarks(const NavMesh &mesh, const Corners &corners, const CornerPolygons &polygons, size_t count);

// What it costs to walk from one corner to each; infinity where there is no way.
std::vector<float> walk_costs(const CornerWalks &walks, uint32_t from);

// The same out of the costs before walks between the corners `changed` came or went: to the bit what walk_costs() says, at the price of the corners
// for which it changes. New corners cost infinity before. Of costs in whole numbers; walks may cost nothing.
void repair_walk_costs(const CornerWalks &walks, uint32_t from, std::span<const uint32_t> changed, std::vector<float> &costs);

} // namespace pcg
