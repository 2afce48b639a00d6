#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "core/city/layout.h"

namespace pcg {

// Tells the nodes of lots which others stand on the same ground.
class CityOverlaps {
public:
	struct PlacedLot {
		uint64_t object = 0; // a PCGLot
		LotId lot = LotId::Invalid;
		bool is_at_home = true; // where the layout has it
		std::vector<glm::vec3> polygon; // in the city
	};

	// All lots that stand in the scene. Those at home overlap as the layout says.
	void mark(const Layout &layout, const std::vector<PlacedLot> &lots);
	void clear() { _marked.clear(); }

private:
	std::set<uint64_t> _marked; // objects
};

} // namespace pcg
