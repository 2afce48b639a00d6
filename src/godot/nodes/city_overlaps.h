#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include <godot_cpp/variant/transform3d.hpp>

#include "core/city/layout.h"

namespace pcg {

// Tells the nodes of lots which others stand on the same ground.
class CityOverlaps {
public:
	struct PlacedLot {
		uint64_t object = 0; // a PCGLot
		LotId lot = LotId::Invalid;
		godot::Transform3D motion; // in the city, from where the layout has it

		bool is_at_home() const { return motion.is_equal_approx(godot::Transform3D()); }
	};

	// All lots that stand in the scene. Those at home overlap as the layout says.
	void mark(const Layout &layout, const std::vector<PlacedLot> &lots);
	void clear() { _marked.clear(); }

private:
	std::set<uint64_t> _marked; // objects
};

} // namespace pcg
