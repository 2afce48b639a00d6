#pragma once

#include <cstdint>
#include <vector>

#include "core/city/layout.h"
#include "core/geometry/overlay.h"

namespace pcg {

// Where a block meets its streets.
struct BlockBorder {
	Loop2 outline; // in plan, counter-clockwise
	std::vector<uint32_t> streets; // by side; indices in Layout::streets
	Loops2 yards = {}; // no building land
	Loops2 inner = {}; // blocks that stand in the yards
};

// Adds a block: pavements along its border, lots without types on what they leave; a square where that has no room for a lot. Yards are squares, to each
// of which a passage leads from the street. With `has_rows` land
// that has four corners is divided into as many lots as the parameters say.
void add_block(Layout &layout, const BlockBorder &border, const LayoutParameters &parameters, bool has_rows);

// Adds a piece of public ground, in convex parts. A `block` has it among its pavements.
void add_ground(Layout &layout, GroundKind kind, const Loop2 &loop, BlockId block, uint32_t street);

} // namespace pcg
