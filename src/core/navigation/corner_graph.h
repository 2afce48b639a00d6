#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/navigation/corners.h"
#include "core/navigation/packed_walks.h"
#include "core/navigation/plan.h"
#include "core/navigation/sight.h"

// The straight walks between corners that shortest walks are made of, and estimates of how far it still is, from a few far-off corners to which all
// distances are known (ALT: Goldberg and Harrelson 2005). In a city of blocks the straight line is a poor guess; with this one a search looks at a
// small part of the map only.
namespace pcg {

class CornerGraph {
public:
	static constexpr size_t landmark_count = 16;

	CornerGraph() = default;
	CornerGraph(const NavMesh &mesh, const Corners &corners, const CornerPolygons &polygons);
	// The same out of the graph from before polygons in some places came, went or changed: corners that saw none of them keep their walks. Where others
	// do not, a walk may stand for itself that is made of shorter ones otherwise.
	CornerGraph(const NavMesh &mesh, const Corners &corners, const CornerPolygons &polygons, const NavMesh &before, std::span<const PlanBox> changed);

	const Corners &corners() const { return _corners; }
	// How many corners saw too much to look at all of it (Sight::is_cut_short()): there walks may be longer than they need be. 0 for most cities.
	size_t cut_short_count() const;
	// Both directions are there. Where a third corner lies all but on the line, the walk to it and the one from there stand for the long one.
	const PackedWalks &walks() const { return _walks; }
	// What it costs at least to walk from each landmark, in whole units; `beyond` if it is more or if there is no way.
	using Far = std::array<int16_t, landmark_count>;
	static constexpr int16_t beyond = 0x7FFF;
	// Where walks end that come by one of some corners.
	struct Goal {
		Far least, most; // by what is known of those corners; such that differences need no more bits
	};
	Goal goal(std::span<const SeenCorner> seen) const;
	// At least so much costs a walk from the corner to the goal.
	float estimate(uint32_t corner, const Goal &goal) const {
		const Far &far = _far[corner];
		int16_t units = 0;
		for (size_t k = 0; k < landmark_count; ++k) { // as whole numbers of 16 bits processors compare eight at once
			const auto ahead = int16_t(goal.least[k] - far[k]), behind = int16_t(far[k] - goal.most[k]);
			units = std::max(units, std::max(ahead, behind));
		}
		return _unit * float(units);
	}

private:
	struct Builder;
	struct Updater;
	// What a corner's walks depend on: how far it reaches from the corner in the four directions of the plan. Coarse, for there are many corners.
	struct Extent {
		uint8_t min_x = 0, min_z = 0, max_x = 0, max_z = 0; // steps of a scale, see the source
		bool is_cut_short = false;

		Extent() = default;
		Extent(glm::vec3 corner, const Sight &sight); // after a look
		PlanBox box(glm::vec3 corner) const;
	};
	// What the far costs are rounded down from, in parts of a unit, two landmarks a byte. Estimates do without; what is mended after an edit begins with it.
	using FarParts = std::array<uint8_t, landmark_count / 2>;
	static constexpr uint32_t parts = 16;
	using Measure = std::function<std::vector<float>(const CornerWalks &walks, size_t index, uint32_t landmark)>;

	void set_walks(const NavMesh &mesh, const CornerPolygons &polygons, CornerWalks walks, const Measure &measure);
	void set_far(uint32_t corner, size_t index, float cost);
	float far_cost(uint32_t corner, size_t index) const; // parts; infinity if it is beyond

	Corners _corners;
	PackedWalks _walks;
	std::vector<Extent> _extents; // by corner
	std::vector<Far> _far; // by corner
	std::vector<FarParts> _far_parts; // by corner
	float _unit = 1.0f; // cost
	std::array<glm::vec3, landmark_count> _landmarks{};
};

} // namespace pcg
