#include "core/navigation/landmarks.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/navigation/nav_mesh.h"
#include "core/navigation/open_list.h"

namespace pcg {

namespace {

// Dijkstra from what is open.
void spread_costs(const CornerWalks &walks, OpenList &open, std::vector<float> &costs) {
	while (!open.is_empty()) {
		const OpenList::Entry entry = open.pop();
		if (entry.estimate > costs[entry.node]) {
			continue; // a better way there was found in the meantime
		}
		for (const SeenCorner &next : walks[entry.node]) {
			const float cost = entry.estimate + next.cost;
			if (cost < costs[next.corner]) {
				costs[next.corner] = cost;
				open.push({ cost, next.corner });
			}
		}
	}
}

// By way of neighbours that cost less than `bound`.
float least_cost(const CornerWalks &walks, uint32_t corner, const std::vector<float> &costs, float bound = INFINITY) {
	float least = INFINITY;
	for (const SeenCorner &walk : walks[corner]) {
		if (costs[walk.corner] < bound) {
			least = std::min(least, costs[walk.corner] + walk.cost);
		}
	}
	return least;
}

} // namespace

std::vector<uint32_t> choose_landmarks(const NavMesh &mesh, const Corners &corners, const CornerPolygons &polygons, size_t count) {
	std::vector<uint32_t> count_by_ground(mesh.component_count());
	const auto ground_of = [&](uint32_t corner) { return mesh.component(polygons.of(corner)[0]); };
	for (uint32_t corner = 0; corner < corners.count(); ++corner) {
		++count_by_ground[ground_of(corner)];
	}
	const auto ground = uint32_t(std::max_element(count_by_ground.begin(), count_by_ground.end()) - count_by_ground.begin());
	std::vector<float> nearest(corners.count());
	for (uint32_t corner = 0; corner < corners.count(); ++corner) {
		nearest[corner] = ground_of(corner) == ground ? glm::length(mesh.point(corner)) : -1.0f;
	}
	std::vector<uint32_t> landmarks;
	while (landmarks.size() < count) {
		landmarks.push_back(uint32_t(std::max_element(nearest.begin(), nearest.end()) - nearest.begin()));
		for (uint32_t corner = 0; corner < corners.count(); ++corner) {
			nearest[corner] = std::min(nearest[corner], glm::distance(mesh.point(corner), mesh.point(landmarks.back())));
		}
	}
	return landmarks;
}

std::vector<float> walk_costs(const CornerWalks &walks, uint32_t from) {
	std::vector<float> costs(walks.size(), INFINITY);
	OpenList open;
	costs[from] = 0.0f;
	open.push({ 0.0f, from });
	spread_costs(walks, open, costs);
	return costs;
}

// First, from near to far, costs are forgotten that no nearer neighbour gives any more (Ramalingam and Reps 1996; where walks cost nothing neighbours as
// near may have had theirs from here); then what is left spreads anew.
void repair_walk_costs(const CornerWalks &walks, uint32_t from, std::span<const uint32_t> changed, std::vector<float> &costs) {
	std::vector<uint32_t> unsettled(changed.begin(), changed.end());
	OpenList open;
	for (const uint32_t corner : changed) {
		if (std::isfinite(costs[corner])) {
			open.push({ costs[corner], corner });
		}
	}
	while (!open.is_empty()) {
		const auto [cost, corner] = open.pop();
		if (corner == from || costs[corner] != cost || least_cost(walks, corner, costs, cost) <= cost) {
			continue;
		}
		costs[corner] = INFINITY;
		unsettled.push_back(corner);
		for (const SeenCorner &next : walks[corner]) {
			if (costs[next.corner] == cost + next.cost) {
				open.push({ costs[next.corner], next.corner });
			}
		}
	}
	for (const uint32_t corner : unsettled) {
		const float least = corner == from ? 0.0f : least_cost(walks, corner, costs);
		if (least < costs[corner]) {
			costs[corner] = least;
		}
		if (std::isfinite(costs[corner])) {
			open.push({ costs[corner], corner });
		}
	}
	spread_costs(walks, open, costs);
}

} // namespace pcg
