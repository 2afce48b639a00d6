#pragma once

#include "core/city/city.h"

namespace pcg {

// The pieces of Layout::ground that each GroundBuild is made of: one list for a tile's streets or a block's pavements.
struct GroundGroups {
	std::vector<std::vector<uint32_t>> streets, blocks;
};
GroundGroups group_ground(const Layout &layout);

// A piece as a plain surface at y = 0: asphalt, paving, white bars on crossings with four corners. Faces that no rule made do not count.
cga::DerivationResult plain_ground(const Ground &ground);
// Grass below the lots of a block, a little lower so that floors and yards at 0 cover it.
cga::DerivationResult lot_ground(const Layout &layout, const CityBlock &block);

} // namespace pcg
