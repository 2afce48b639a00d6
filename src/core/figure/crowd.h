#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/sim_time.h"
#include "core/figure/body.h"
#include "core/figure/detail_levels.h"
#include "core/figure/looks.h"
#include "core/population/population.h"
#include "core/ports/agent_host.h"
#include "core/ports/path_provider.h"

// Bodies of everybody outdoors: they glide along their paths as time passes, each shown in as much detail as its distance asks for. Figures are
// numbers that a renderer takes whole.
namespace pcg {

// Floats for one figure: a 3 x 4 matrix by rows, colour of the top (RGBA), then metres walked, walks, sits and looks (figure.gdshader).
constexpr size_t crowd_stride = 20;

class Crowd : public AgentHost {
public:
	// `now` tells the simulated time of the call that is being made. `paths`, for ways back to where people should be, may be null. What is referred
	// to must outlive the crowd.
	Crowd(const Population &population, const PathProvider *paths, std::function<SimTime()> now);

	void spawn_agent(PersonId person, glm::vec3 position) override;
	void walk_agent(PersonId person, std::span<const glm::vec3> path, float speed) override;
	void place_agent(PersonId person, glm::vec3 position, glm::vec3 facing, AgentPose pose) override;
	void free_agent(PersonId person) override;
	void clear();

	// Moves everybody to `time` and chooses what is shown for `eye`. Steps back in time, and of more than an hour, put everybody where they belong.
	void update(SimTime time, const Eye &eye, const DetailLimits &limits);
	// Writes the figures that are to be drawn now: those of one kind, crowd_stride floats each.
	void write_figures();
	const std::vector<float> &figures(size_t kind) const { return _figures[kind]; }

	static constexpr uint32_t no_slot = 0xFFFFFFFF;
	// People outdoors; with those who still follow their persons indoors there are as many slots as bodies.
	size_t size() const { return _bodies.size() - _leaving; }
	bool has(PersonId person) const { return slot_of(person) != no_slot; }
	uint32_t slot_of(PersonId person) const { return index_of(person) < _slots.size() ? _slots[index_of(person)] : no_slot; }
	// Slots change whenever anybody comes or goes.
	const Body &body(uint32_t slot) const { return _bodies[slot]; }
	std::span<const Body> bodies() const { return _bodies; }
	DetailLevel level(uint32_t slot) const { return _levels[slot]; }
	// Slots of those who became agents in the last update.
	std::span<const uint32_t> new_agents() const { return _new_agents; }
	float step_seconds() const { return _around.seconds; } // of the last update, in simulated time

	const Population &population() const { return *_population; }

	// Its agent has a scene; without one any more it is a figure again. `moves_itself`: from now on by move_agent() only.
	void set_scene(uint32_t slot, bool moves_itself, bool shows_figure);
	void lose_scene(uint32_t slot);
	// The scene was moved, by itself or by somebody else: the person comes back from there.
	void move_agent(uint32_t slot, glm::vec3 position);

	// Where the person should be, without the step to the side; as of the last update(). The origin if it has no body.
	glm::vec3 position(PersonId person) const;
	// Whose body a ray meets first within `reach` metres; Invalid if nobody's that is shown. `direction` is a unit vector.
	PersonId pick(glm::vec3 origin, glm::vec3 direction, float reach) const;

private:
	Body *find(PersonId person);
	uint32_t find_leaving(PersonId person) const;
	void drop(uint32_t slot);
	void drop_leavers(const Eye &eye, bool is_settled);
	bool is_seen(const Eye &eye, const DetailLimits &limits, glm::vec3 point) const;

	const Population *_population;
	std::function<SimTime()> _now;
	Surroundings _around;
	SimTime _last;
	Eye _eye; // of the last update, as are the limits
	DetailLimits _limits;
	std::vector<Body> _bodies;
	std::vector<glm::vec3> _positions; // of the bodies, flat, and so on
	std::vector<DetailLevel> _levels;
	std::vector<Body> _spare; // keep their memory for whoever comes next
	size_t _leaving = 0;
	std::vector<uint32_t> _slots; // by person
	DetailChooser _chooser;
	std::vector<uint32_t> _new_agents;
	std::array<std::vector<float>, figure_kind_count> _figures;
};

} // namespace pcg
