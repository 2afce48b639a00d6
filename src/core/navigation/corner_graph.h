#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/navigation/corners.h"
#include "core/navigation/sight.h"

// The straight walks between corners that shortest walks are made of, and estimates of how far it still is, from a few far-off corners to which all
// distances are known (ALT: Goldberg and Harrelson 2005). In a city of blocks the straight line is a poor guess; with this one a search looks at a
// small part of the map only.
namespace pcg {

class CornerGraph {
public:
	static constexpr size_t landmark_count = 16;
	// What it costs to walk from each landmark to a corner; 0 where it cannot be reached.
	using Far = std::array<float, landmark_count>;

	CornerGraph() = default;
	CornerGraph(const NavMesh &mesh, float margin); // as in NavMeshOptions

	const Corners &corners() const { return _corners; }
	// Both directions are there. Where a third corner lies all but on the line, the walk to it and the one from there stand for the long one.
	std::span<const SeenCorner> walks(uint32_t corner) const { return { _walks.data() + _first[corner], _first[corner + 1] - _first[corner] }; }
	// Where walks end that come by one of some corners.
	struct Goal {
		Far least, most; // that it costs from each landmark, by what is known of those corners
	};
	Goal goal(std::span<const SeenCorner> seen) const;
	// At least so much costs a walk from the corner to the goal.
	float estimate(uint32_t corner, const Goal &goal) const {
		const Far &far = _far[corner];
		float cost[4] = {}; // side by side, as processors do it at once
		for (size_t first = 0; first < landmark_count; first += 4) {
			for (size_t k = 0; k < 4; ++k) {
				cost[k] = std::max(cost[k], std::max(goal.least[first + k] - far[first + k], far[first + k] - goal.most[first + k]));
			}
		}
		return std::max(std::max(cost[0], cost[1]), std::max(cost[2], cost[3]));
	}

private:
	struct Builder;

	Corners _corners;
	std::vector<uint32_t> _first; // one more than corners
	std::vector<SeenCorner> _walks;
	std::vector<Far> _far; // by corner
};

} // namespace pcg
