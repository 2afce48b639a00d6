#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/navigation/corners.h"
#include "core/navigation/plan.h"
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
	// The same out of the graph from before polygons in some places came, went or changed: corners that saw none of them keep their walks. Where others
	// do not, a walk may stand for itself that is made of shorter ones otherwise.
	CornerGraph(const NavMesh &mesh, float margin, const CornerGraph &before, std::span<const PlanBox> changed);

	const Corners &corners() const { return _corners; }
	// How many corners saw too much to look at all of it (Sight::is_cut_short()): there walks may be longer than they need be. 0 for the ground of cities.
	size_t cut_short_count() const;
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
	struct Updater;
	// The box that a corner's walks depend on, in whole units outwards: coarse, for there are many corners.
	struct Extent {
		static constexpr float unit = 2.0f; // metres; ground lies within 65 km, or what is seen counts as anywhere
		int16_t min_x, min_z, max_x, max_z;
		bool is_cut_short = false;

		explicit Extent(const PlanBox &box = {});
		explicit Extent(const Sight &sight); // after a look
		bool is_near(const PlanBox &box) const;
	};
	using Walks = std::vector<std::vector<SeenCorner>>; // by corner

	void set_walks(const Walks &walks);
	void measure_far(const NavMesh &mesh, const CornerPolygons &polygons,
			const std::function<std::vector<float>(size_t index, uint32_t landmark)> &measure);

	Corners _corners;
	std::vector<uint32_t> _first; // one more than corners
	std::vector<SeenCorner> _walks;
	std::vector<Extent> _extents; // by corner
	std::vector<Far> _far; // by corner
	std::array<glm::vec3, landmark_count> _landmarks{};
};

} // namespace pcg
