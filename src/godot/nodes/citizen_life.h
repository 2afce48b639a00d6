#pragma once

#include <memory>
#include <vector>

#include "core/agenda/agenda.h"
#include "core/figure/crowd.h"
#include "core/lang/attribute_override.h"
#include "core/population/population.h"
#include "core/sim/age_heat.h"
#include "core/sim/invariants.h"
#include "core/sim/lived_log.h"
#include "core/sim/simulation.h"
#include "godot/nodes/city_job.h"

namespace pcg {

// Something that signals tell of. Collected while the simulation moves and told afterwards, because whoever listens may do what he likes.
struct Notice {
	enum class Kind : uint8_t { LeftBuilding, EnteredBuilding, TaskStarted, AgentSpawned, AgentFreed };
	static constexpr size_t kind_count = 5;
	Kind kind = Kind::TaskStarted;
	TaskKind task = TaskKind::StayInside; // of TaskStarted
	PersonId person = PersonId::Invalid;
	BuildingId building = BuildingId::Invalid;
};

// Between a simulation and those who look on: passes bodies to the crowd and writes down what signals are wanted for.
class NoticeBoard : public SimulationObserver, public AgentHost {
public:
	// `simulation` is asked which entry began; it may be set later. `bodies` may be null.
	void set_simulation(const Simulation *simulation) { _simulation = simulation; }
	void set_bodies(AgentHost *bodies) { _bodies = bodies; }
	void want(Notice::Kind kind, bool is_wanted) { _wanted[size_t(kind)] = is_wanted; }
	// Gives what was noted since the last call. `notices` is empty before and lends its memory to those that come.
	void take(std::vector<Notice> &notices) { _notices.swap(notices); }

	void on_event(const SimEvent &event) override;
	void spawn_agent(PersonId person, glm::vec3 position) override;
	void walk_agent(PersonId person, std::span<const glm::vec3> path, float speed) override;
	void place_agent(PersonId person, glm::vec3 position, glm::vec3 facing, AgentPose pose) override;
	void free_agent(PersonId person) override;

private:
	void note(const Notice &notice);

	const Simulation *_simulation = nullptr;
	AgentHost *_bodies = nullptr;
	std::array<bool, Notice::kind_count> _wanted{};
	std::vector<Notice> _notices;
};

// Everything that one running simulation needs, in the order in which it depends on each other.
struct CitizenLife {
	uint64_t city_id = 0; // of the PCGCity
	std::shared_ptr<const CityState> city;
	std::shared_ptr<const Program> program;
	Population population;
	AgendaSet agendas;
	uint64_t seed = 1; // that the agendas were written with, as the next; a loaded life brings its own
	std::vector<AttributeOverride> attributes;
	NoticeBoard notices;
	std::shared_ptr<Crowd> bodies; // shared with whoever shows them, whom the game may free
	std::unique_ptr<Simulation> simulation;
	std::unique_ptr<InvariantChecker> checker; // only if promises are to be checked
	std::unique_ptr<LivedLog> log; // these two only if lives are to be recorded
	std::unique_ptr<AgeHeat> heat;
	bool is_moving = false; // the simulation runs; rules may call scripts meanwhile
};

// What the debugger shows.
struct CitizenLoad {
	double frame_ms = 0.0; // of the last frame that moved
	uint64_t frame = 0;
	double events_per_second = 0.0; // of the game, over the last whole second
	double second = 0.0; // since when `events` are counted
	uint64_t events = 0;
};

} // namespace pcg
