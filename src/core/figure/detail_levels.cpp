#include "core/figure/detail_levels.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace pcg {

namespace {

constexpr float body_radius = 2.0f; // metres around the feet: the body, its shadow and a step

float squared_distance(glm::vec3 a, glm::vec3 b) { return glm::dot(a - b, a - b); }

// Squares, so that distances need no roots. Those who are in stay until they are further out.
float squared_reach(float distance, float hysteresis, bool is_in) {
	const float reach = is_in ? distance * (1.0f + hysteresis) : distance;
	return reach * reach;
}

} // namespace

// The rows of the matrix, added and subtracted, are the planes (Gribb and Hartmann, "Fast extraction of viewing frustum planes", 2001).
Eye Eye::at(glm::vec3 position, const glm::mat4 &clip) {
	Eye eye;
	eye.position = position;
	eye.is_open = true;
	const auto row = [&](int i) { return glm::vec4(clip[0][i], clip[1][i], clip[2][i], clip[3][i]); };
	eye.sides = { row(3) + row(0), row(3) - row(0), row(3) + row(1), row(3) - row(1) };
	for (glm::vec4 &side : eye.sides) {
		const float length = glm::length(glm::vec3(side));
		side = length > 0.0f ? side / length : glm::vec4(0.0f);
	}
	return eye;
}

bool Eye::sees(glm::vec3 middle, float radius) const {
	return is_open && std::all_of(sides.begin(), sides.end(), [&](const glm::vec4 &side) { return glm::dot(glm::vec3(side), middle) + side.w >= -radius; });
}

void DetailChooser::keep_nearest(std::vector<Candidate> &candidates, size_t count) {
	if (candidates.size() > count) {
		std::nth_element(candidates.begin(), candidates.begin() + ptrdiff_t(count), candidates.end());
		candidates.resize(count);
	}
}

void DetailChooser::choose(std::span<const glm::vec3> positions, std::span<DetailLevel> levels, const Eye &eye, const DetailLimits &limits) {
	_leavers.clear();
	_comers.clear();
	choose_agents(positions, levels, eye, limits);
	choose_figures(positions, levels, eye, limits);
}

void DetailChooser::choose_agents(std::span<const glm::vec3> positions, std::span<DetailLevel> levels, const Eye &eye, const DetailLimits &limits) {
	const float near = squared_reach(limits.agent_distance, 0.0f, false), kept = squared_reach(limits.agent_distance, limits.hysteresis, true);
	_candidates.clear();
	_changes.clear();
	_is_wanted.assign(positions.size(), 0);
	uint32_t agents = 0;
	for (uint32_t i = 0; i < positions.size(); ++i) {
		const bool is_agent = levels[i] == DetailLevel::Agent;
		const float distance = squared_distance(positions[i], eye.position);
		agents += is_agent;
		if (eye.is_open && distance <= (is_agent ? kept : near)) {
			_candidates.push_back({ is_agent ? distance * near / kept : distance, i });
		}
	}
	keep_nearest(_candidates, limits.agent_limit);
	for (const Candidate &candidate : _candidates) {
		_is_wanted[candidate.index] = 1;
	}
	for (uint32_t i = 0; i < positions.size() && agents > 0; ++i) {
		if (levels[i] == DetailLevel::Agent && !_is_wanted[i]) {
			_changes.push_back({ -squared_distance(positions[i], eye.position), i }); // the furthest first
		}
	}
	keep_nearest(_changes, limits.switch_budget);
	for (const Candidate &leaver : _changes) {
		levels[leaver.index] = DetailLevel::Figure;
		_leavers.push_back(leaver.index);
	}
	agents -= uint32_t(_leavers.size());
	std::erase_if(_candidates, [&](const Candidate &candidate) { return levels[candidate.index] == DetailLevel::Agent; });
	const size_t room = limits.agent_limit > agents ? limits.agent_limit - agents : 0;
	keep_nearest(_candidates, std::min<size_t>(room, limits.switch_budget - _leavers.size()));
	for (const Candidate &comer : _candidates) {
		levels[comer.index] = DetailLevel::Agent;
		_comers.push_back(comer.index);
	}
}

void DetailChooser::choose_figures(std::span<const glm::vec3> positions, std::span<DetailLevel> levels, const Eye &eye, const DetailLimits &limits) {
	const float near = squared_reach(limits.figure_distance, 0.0f, false), kept = squared_reach(limits.figure_distance, limits.hysteresis, true);
	_candidates.clear();
	for (uint32_t i = 0; i < positions.size(); ++i) {
		if (levels[i] == DetailLevel::Agent) {
			continue;
		}
		const bool is_figure = levels[i] == DetailLevel::Figure;
		const float distance = squared_distance(positions[i], eye.position);
		levels[i] = DetailLevel::Data;
		if (distance <= (is_figure ? kept : near) && eye.sees(positions[i], body_radius)) {
			_candidates.push_back({ is_figure ? distance * near / kept : distance, i });
		}
	}
	keep_nearest(_candidates, limits.figure_limit);
	for (const Candidate &candidate : _candidates) {
		levels[candidate.index] = DetailLevel::Figure;
	}
}

} // namespace pcg
