#include "core/navigation/landmarks.h"

#include <algorithm>
#include <cmath>
#include <queue>

#include <glm/geometric.hpp>

namespace pcg {

namespace {

glm::vec3 middle(const NavLink &link) { return (link.left + link.right) / 2.0f; }

} // namespace

// The first landmark is as far as possible from the first link, each other one as far as possible from those before it.
Landmarks::Landmarks(const NavMesh &mesh) : _links(mesh.links().size()) {
	if (_links.empty()) {
		return;
	}
	std::vector<float> nearest(_links.size(), INFINITY);
	uint32_t farthest = 0;
	for (size_t round = 0; round <= count; ++round) {
		const size_t landmark = round == 0 ? 0 : round - 1; // round 0 only looks for the first
		measure(mesh, farthest, landmark);
		farthest = 0;
		for (uint32_t i = 0; i < _links.size(); ++i) {
			const float cost = _links[i].to[landmark];
			nearest[i] = round == 0 ? INFINITY : std::min(nearest[i], cost);
			const float rank = round == 0 ? cost : nearest[i];
			const float best = round == 0 ? _links[farthest].to[landmark] : nearest[farthest];
			farthest = rank > best ? i : farthest;
		}
	}
}

void Landmarks::measure(const NavMesh &mesh, uint32_t from_link, size_t landmark) {
	// What cannot be reached keeps 0: there it tells nothing.
	std::vector<float> costs(_links.size(), INFINITY);
	using Open = std::pair<float, uint32_t>;
	std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
	costs[from_link] = 0.0f;
	open.emplace(0.0f, from_link);
	while (!open.empty()) {
		const auto [cost, link] = open.top();
		open.pop();
		if (cost > costs[link]) {
			continue;
		}
		const uint32_t polygon = mesh.links()[link].target;
		const glm::vec3 here = middle(mesh.links()[link]);
		for (uint32_t i = mesh.first_link(polygon); i < mesh.first_link(polygon + 1); ++i) {
			const float next = cost + mesh.cost(polygon) * glm::distance(here, middle(mesh.links()[i]));
			if (next < costs[i]) {
				costs[i] = next;
				open.emplace(next, i);
			}
		}
	}
	for (uint32_t i = 0; i < _links.size(); ++i) {
		_links[i].to[landmark] = std::isfinite(costs[i]) ? costs[i] : 0.0f;
	}
}

Landmarks::Costs Landmarks::of_point(const NavMesh &mesh, const NavPoint &point) const {
	Costs costs;
	std::fill_n(costs.to, count, INFINITY);
	for (uint32_t i = mesh.first_link(point.polygon); i < mesh.first_link(point.polygon + 1); ++i) {
		const float metres = mesh.cost(point.polygon) * glm::distance(point.position, middle(mesh.links()[i]));
		for (size_t k = 0; k < count; ++k) {
			costs.to[k] = std::min(costs.to[k], _links[i].to[k] + metres);
		}
	}
	return costs;
}

} // namespace pcg
