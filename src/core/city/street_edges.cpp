#include "core/city/street_edges.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>

#include <glm/geometric.hpp>

namespace pcg {

namespace {

constexpr double least_angle = 25.0 * std::numbers::pi / 180.0; // below it corners run far away from their node
constexpr double least_free_length = 1.0; // metres of a street between its junctions

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

glm::dvec2 left_of(glm::dvec2 direction) { return { -direction.y, direction.x }; }

// Seen from the node. Streets that go straight on have no corner: there it is the end of the square line across them.
glm::dvec2 corner_between(const StreetEdges::Arm &arm, const StreetEdges::Arm &next) {
	const double sine = cross(arm.direction, next.direction);
	if (std::abs(sine) < 1e-6) {
		return left_of(arm.direction) * ((arm.half_width + next.half_width) / 2.0);
	}
	return (next.direction * arm.half_width + arm.direction * next.half_width) / sine;
}

} // namespace

StreetEdges::StreetEdges(const StreetPlan &plan) : _plan(plan), _first(plan.nodes.size() + 1), _arms(plan.streets.size() * 2) {
	for (const StreetPlan::Street &street : plan.streets) {
		++_first[street.from + 1];
		++_first[street.to + 1];
	}
	std::partial_sum(_first.begin(), _first.end(), _first.begin());
	std::vector<uint32_t> next(_first.begin(), _first.end() - 1);
	const auto add = [&](uint32_t street, uint32_t node, uint32_t other) {
		const glm::dvec2 along = plan.nodes[other] - plan.nodes[node];
		Arm arm;
		arm.street = street;
		arm.other = other;
		arm.angle = std::atan2(along.y, along.x);
		arm.half_width = double(plan.streets[street].width) / 2.0;
		arm.direction = along / std::max(glm::length(along), 1e-9);
		_arms[next[node]++] = arm;
	};
	for (uint32_t i = 0; i < plan.streets.size(); ++i) {
		add(i, plan.streets[i].from, plan.streets[i].to);
		add(i, plan.streets[i].to, plan.streets[i].from);
	}
	for (uint32_t node = 0; node < plan.nodes.size(); ++node) {
		find_corners(node);
	}
}

void StreetEdges::find_corners(uint32_t node) {
	const std::span<Arm> around{ _arms.data() + _first[node], _first[node + 1] - _first[node] };
	std::sort(around.begin(), around.end(), [](const Arm &a, const Arm &b) { return a.angle < b.angle; });
	for (Arm &arm : around) {
		arm.cut = 0.0;
	}
	for (size_t i = 0; i < around.size(); ++i) {
		Arm &arm = around[i], &next = around[(i + 1) % around.size()];
		const glm::dvec2 corner = corner_between(arm, next);
		arm.corner = _plan.nodes[node] + corner;
		arm.cut = std::max(arm.cut, glm::dot(corner, arm.direction));
		next.cut = std::max(next.cut, glm::dot(corner, next.direction));
	}
}

const StreetEdges::Arm &StreetEdges::arm(uint32_t node, uint32_t other) const {
	const std::span<const Arm> around = arms(node);
	return *std::find_if(around.begin(), around.end(), [&](const Arm &arm) { return arm.other == other; });
}

double StreetEdges::free_length(uint32_t street) const {
	const auto [from, to, width] = _plan.streets[street];
	return glm::distance(_plan.nodes[from], _plan.nodes[to]) - arm(from, to).cut - arm(to, from).cut;
}

std::vector<glm::dvec2> StreetEdges::outline() const {
	// The westernmost node lies on it, and the country there between its last arm and its first.
	const auto west = std::min_element(_plan.nodes.begin(), _plan.nodes.end(), [](glm::dvec2 a, glm::dvec2 b) { return a.x < b.x; });
	const uint32_t start = uint32_t(west - _plan.nodes.begin());
	std::vector<glm::dvec2> points;
	uint32_t node = start;
	const Arm *leaving = &arms(start).back();
	do {
		points.push_back(leaving->corner);
		const uint32_t came_from = node;
		node = leaving->other;
		const std::span<const Arm> around = arms(node);
		const size_t arrived = size_t(&arm(node, came_from) - around.data());
		leaving = &around[(arrived + around.size() - 1) % around.size()];
	} while (node != start && points.size() <= 2 * _plan.streets.size());
	return points;
}

std::vector<uint32_t> StreetEdges::bad_nodes() const {
	std::set<uint32_t> bad;
	for (uint32_t node = 0; node < _plan.nodes.size(); ++node) {
		const std::span<const Arm> around = arms(node);
		for (size_t i = 0; i < around.size(); ++i) {
			const double turn = i + 1 < around.size() ? around[i + 1].angle - around[i].angle
													  : around[0].angle + 2.0 * std::numbers::pi - around[i].angle;
			if (!(turn >= least_angle)) {
				bad.insert(node);
			}
		}
	}
	for (uint32_t i = 0; i < _plan.streets.size(); ++i) {
		if (!(free_length(i) >= least_free_length)) {
			bad.insert({ _plan.streets[i].from, _plan.streets[i].to });
		}
	}
	return { bad.begin(), bad.end() };
}

} // namespace pcg
