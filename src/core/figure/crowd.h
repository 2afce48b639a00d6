#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/sim_time.h"
#include "core/figure/figure.h"
#include "core/population/population.h"
#include "core/ports/agent_host.h"

// Bodies of everybody outdoors, as numbers that a renderer takes whole: people glide along their paths as time passes.
namespace pcg {

constexpr size_t figure_kind_count = 6;
// Floats for one body: a 3 x 4 matrix by rows, colour of the top (RGBA), then metres walked, walks, sits and looks (figure.gdshader).
constexpr size_t crowd_stride = 20;

// How a person looks, from their lasting data alone. `kind` is the index of one of the six figures.
struct Looks {
	uint8_t kind = 0;
	uint8_t hair = 0; // 0 .. 7
	uint8_t skin = 0; // 0 .. 7
	glm::vec3 top{ 1.0f };
};
Looks looks_of(const Population &population, PersonId person);
Figure make_figure_of_kind(size_t kind);

// Positions are those of the simulation, but for up to 0.45 m to the side of the way, so that a family does not walk inside itself.
class Crowd : public AgentHost {
public:
	// `now` tells the simulated time of the call that is being made. `population` must outlive the crowd.
	Crowd(const Population &population, std::function<SimTime()> now);

	void spawn_agent(PersonId person, glm::vec3 position) override;
	void walk_agent(PersonId person, std::span<const glm::vec3> path, float speed) override;
	void place_agent(PersonId person, glm::vec3 position, glm::vec3 facing, AgentPose pose) override;
	void free_agent(PersonId person) override;
	void clear();

	// Moves everybody to where they are at `time` and writes the numbers below. Steps back in time start each path anew.
	void update(SimTime time);
	// Bodies of one kind, crowd_stride floats each; as of the last update().
	const std::vector<float> &instances(size_t kind) const { return _instances[kind]; }

	size_t size() const { return _bodies.size(); }
	bool has(PersonId person) const { return slot_of(person) != no_slot; }
	// Without the step to the side; as of the last update(). The origin if the person has no body.
	glm::vec3 position(PersonId person) const;

private:
	static constexpr uint32_t no_slot = 0xFFFFFFFF;
	struct Body {
		PersonId person = PersonId::Invalid;
		Looks looks;
		glm::vec3 position{ 0.0f };
		glm::vec3 facing{ 0.0f, 0.0f, 1.0f };
		AgentPose pose = AgentPose::Stand;
		std::vector<glm::vec3> path; // empty unless walking
		SimTime departure;
		float speed = 0.0f;
		uint32_t segment = 0; // path[segment] .. path[segment + 1] is walked now
		float walked_before = 0.0f; // metres up to path[segment]
		float walked = 0.0f;
	};

	uint32_t slot_of(PersonId person) const;
	Body *find(PersonId person);
	static void advance(Body &body, SimTime time);
	void write(const Body &body);

	const Population *_population;
	std::function<SimTime()> _now;
	std::vector<Body> _bodies;
	std::vector<uint32_t> _slots; // by person
	std::array<std::vector<float>, figure_kind_count> _instances;
};

} // namespace pcg
