#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/ids.h"
#include "core/base/sim_time.h"
#include "core/figure/looks.h"
#include "core/ports/agent_host.h"
#include "core/ports/path_provider.h"

namespace pcg {

constexpr float astray_distance = 1.5f; // metres from its place at which a body looks for a way back
constexpr float back_home = 0.02f; // metres

// The body of somebody outdoors. The simulation says where it should be, its place; where it is may be elsewhere, because somebody pushed it, its
// scene avoids others, or it is stuck. Then it comes back on foot: the small way straight while it walks on, the large one around what stands there.
struct Body {
	PersonId person = PersonId::Invalid;
	Looks looks;
	float natural_speed = 1.3f; // m/s

	// What the simulation wants.
	AgentPose pose = AgentPose::Stand;
	glm::vec3 on_path{ 0.0f }; // without the step aside
	glm::vec3 aim{ 0.0f, 0.0f, 1.0f }; // where it should look
	std::vector<glm::vec3> path; // empty unless walking
	SimTime departure;
	float speed = 0.0f;
	float length = 0.0f; // of the path
	uint32_t segment = 0; // path[segment] .. path[segment + 1] is walked now
	float walked_before = 0.0f; // metres up to path[segment]
	float walked = 0.0f;

	// What is shown.
	AgentPose shown_pose = AgentPose::Stand;
	glm::vec3 place{ 0.0f }; // on the path, with the step aside
	glm::vec3 position{ 0.0f };
	glm::vec3 facing{ 0.0f, 0.0f, 1.0f };
	glm::vec3 heading{ 0.0f, 0.0f, 1.0f }; // of the path, round its corners little by little; the step aside goes to its side
	float strayed = 0.0f; // metres walked beside the path
	glm::vec3 velocity{ 0.0f }; // m/s that would bring it on, in simulated time

	std::vector<glm::vec3> way_back; // empty unless astray
	uint32_t way_next = 0;
	float nearest_gap = 0.0f; // since it is astray, metres
	float stalled = 0.0f; // seconds since it last came nearer
	bool is_carried = false; // it was stuck: moved by the crowd until it is back

	bool has_scene = false;
	bool moves_itself = false; // its scene moves it; the crowd says where to
	bool shows_figure = true; // also as an agent
	bool is_leaving = false; // its person went inside; it follows
	bool was_placed = false; // by the crowd, in the last update, although it moves itself

	void set_out(std::span<const glm::vec3> way, float metres_per_second, SimTime now);
	void stand(glm::vec3 where, glm::vec3 look, AgentPose how);
	// Takes the body to where it belongs, at once.
	void settle();
	// Along the path to where it should be at `time`; `turned` is the share of a turn that it does meanwhile.
	void advance(SimTime time, float turned);
	float gap() const;
	// Whether it must look for a way, had it stayed while its place moved on from `before`.
	bool is_astray(glm::vec3 before) const;
};

// The share of a turn that a body does in so many seconds, 0 .. 1.
float turned_within(float seconds);

// What a body needs to know to find its way back.
struct Surroundings {
	const PathProvider *paths = nullptr; // null: straight ways
	float seconds = 0.0f; // of simulated time since the last step
	float turned = 0.0f; // turned_within(seconds)
	uint32_t ways_left = 0; // to be looked for in this step
};

// One step of a body from its place `before` towards the present one. `is_seen` (of a body that is astray): somebody would see it jump.
void step_body(Body &body, glm::vec3 before, bool is_seen, Surroundings &around);
// It was moved by somebody else.
void move_body(Body &body, glm::vec3 position, const Surroundings &around);

} // namespace pcg
