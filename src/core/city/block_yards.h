#pragma once

#include "core/geometry/overlay.h"

namespace pcg {

// A block's building land without its yards.
struct LandAroundYards {
	Loops2 land; // outlines without holes
	Loops2 open; // convex pieces of yards and passages
};

// Each yard has a passage of `passage` metres, from the middle of one of its sides straight ahead to where the land ends, the shortest of all: so people
// get into it, and what is left of the land has no holes. Yards that reach over the land end there. What stands in them, `inner`, is not open.
LandAroundYards land_around_yards(const Loop2 &land, const Loops2 &yards, const Loops2 &inner, double passage);

} // namespace pcg
