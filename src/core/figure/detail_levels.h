#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

// How much is shown of each person outdoors: near the camera a scene of its own, further off a figure, beyond that nothing.
namespace pcg {

enum class DetailLevel : uint8_t { Data, Figure, Agent };

// Who looks, and what lies in the picture. One that is not open sees nothing: everybody is data.
struct Eye {
	glm::vec3 position{ 0.0f };
	std::array<glm::vec4, 4> sides{}; // planes of the picture's left, right, lower and upper edge: unit normal inwards, distance
	bool is_open = false;

	// `clip` takes points to the engine's clip space (projection times view).
	static Eye at(glm::vec3 position, const glm::mat4 &clip);
	// Whether a ball lies in the picture, at least in part.
	bool sees(glm::vec3 middle, float radius) const;
};

struct DetailLimits {
	float agent_distance = 40.0f; // metres from the eye
	uint32_t agent_limit = 48;
	float figure_distance = 600.0f;
	uint32_t figure_limit = 4000;
	float hysteresis = 0.15f; // whoever has a level keeps it until this share further away
	uint32_t switch_budget = 6; // agents that come and go in one call
};

// Chooses levels anew for each picture. The nearest come first where a limit is reached; figures out of the picture are data. Takes no memory once
// its lists have grown.
class DetailChooser {
public:
	// `levels` holds the present ones and gets the new ones, by the index of `positions`.
	void choose(std::span<const glm::vec3> positions, std::span<DetailLevel> levels, const Eye &eye, const DetailLimits &limits);
	// Of the last call: who ceased to be an agent, then who became one.
	std::span<const uint32_t> leavers() const { return _leavers; }
	std::span<const uint32_t> comers() const { return _comers; }

private:
	struct Candidate {
		float distance = 0.0f; // squared; smaller for those who have the level already
		uint32_t index = 0;
		friend bool operator<(const Candidate &a, const Candidate &b) {
			return a.distance != b.distance ? a.distance < b.distance : a.index < b.index;
		}
	};

	static void keep_nearest(std::vector<Candidate> &candidates, size_t count);
	void choose_agents(std::span<const glm::vec3> positions, std::span<DetailLevel> levels, const Eye &eye, const DetailLimits &limits);
	void choose_figures(std::span<const glm::vec3> positions, std::span<DetailLevel> levels, const Eye &eye, const DetailLimits &limits);

	std::vector<Candidate> _candidates, _changes;
	std::vector<uint8_t> _is_wanted;
	std::vector<uint32_t> _leavers, _comers;
};

} // namespace pcg
