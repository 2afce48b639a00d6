#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "core/city/lot_ground.h"

namespace pcg {

// Tells the nodes of lots which others stand on the same ground.
class CityOverlaps {
public:
	// All lots that stand in the scene, by their PCGLot. Those at home overlap as the layout says.
	void mark(const Layout &layout, const std::vector<PlacedLot> &lots);
	void clear() { _marked.clear(); }

private:
	std::set<uint64_t> _marked; // objects
};

} // namespace pcg
