#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/agenda/agenda.h"
#include "core/agenda/agenda_generator.h"
#include "core/base/diagnostic.h"
#include "core/lang/program.h"
#include "core/lang/vm.h"
#include "core/population/population.h"
#include "core/ports/agent_host.h"
#include "core/ports/path_provider.h"
#include "core/semantics/city_model.h"
#include "core/sim/day_plan.h"
#include "core/sim/event_queue.h"
#include "core/sim/observer.h"
#include "core/sim/party.h"
#include "core/sim/person_record.h"
#include "core/sim/reservations.h"
#include "core/sim/statistics.h"
#include "core/sim/walk_pool.h"

// Lives the agendas of a population (PCG language, sections 5 to 8; paper, "Procedural behavior simulation"). Driven by events: a step costs
// what happens in it, not how many people exist. Everything repeats to the bit for the same seed, whatever the steps.
namespace pcg {

class Behavior;
struct SavedState;
namespace agenda {
struct World;
}

struct SimulationSettings {
	uint64_t seed = 1; // the one that the agendas were generated with, so that attributes keep their values
	Duration patience = Duration::minutes(30); // how long members of a group wait for each other
	std::vector<AttributeOverride> overrides; // as given to the generation
	FileNumbers numbers; // as given to the generation
	bool has_live_bodies = true; // false: AgentHost is never called
};

// Whoever finds no way to where it should be tries again this often, and after every edit of the city.
constexpr Duration retry_pause = Duration::minutes(5);

// What somebody does right now. Spans and references hold until the simulation moves on.
struct PersonView {
	PersonState state = PersonState::Inside;
	Target place; // the building, object or zone where it is; of a walk: where it leads
	uint8_t object_place = Reservations::none; // index in CityObject::places, when using one
	AgentPose pose = AgentPose::Stand;
	glm::vec3 position{ 0.0f };
	glm::vec3 facing{ 0.0f, 0.0f, 1.0f };
	SimTime since;
	SimTime arrival; // of a walk
	float speed = 0.0f; // of a walk, m/s
	std::span<const glm::vec3> path; // of a walk, whole
	PersonId leader = PersonId::Invalid; // of the group that the person is in
	PlannedEntry entry; // under which all this happens; late people may still be busy with one that is over
	Presence presence = Presence::Living; // of somebody who was removed only this holds
};

class Simulation {
public:
	// All that is referred to outlives the simulation. `program` may be null where no agenda has rules to run. Members of one group must be of one
	// household. Nobody lives before start().
	Simulation(const CityModel &city, const PathProvider &paths, const Population &population, const AgendaSet &agendas,
			std::shared_ptr<const Program> program, SimulationSettings settings, AgentHost &host);
	~Simulation();
	Simulation(const Simulation &) = delete;
	Simulation &operator=(const Simulation &) = delete;

	// Places everybody where the agendas want them at that time.
	void start(SimTime time);
	// Handles all that is due up to and including `time`; earlier than now(): nothing.
	void advance_to(SimTime time);
	void step(Duration duration) { advance_to(_now + duration); }
	// Places everybody anew (PCG language, section 8; paper, Algorithm 2), forwards or backwards. The result depends on (seed, time) only.
	void jump_to(SimTime time);
	// Reports everybody's present span to the observers as if it ended now; the life goes on in a new one. For the end of a log.
	void flush_lived();
	SimTime now() const { return _now; }
	// The whole state as bytes, and back into a simulation of the same people, agendas and rules in the same city, started or not: from then on all
	// goes on as it would have. Edits of the city since then are taken in as ever. False, with an error, and nothing changes: the bytes are damaged
	// or of something else. io/state_file.h keeps them in files, with the people.
	std::string save() const;
	bool restore(std::string_view bytes, Diagnostics &diagnostics);

	// Changes while it runs (simulation_edits.cpp). Edits of the city need no call: they are seen at the next step. Whoever is at, or on the way
	// to, what was moved or removed starts the rule or the walk that led there anew; whose building is gone stands before it and goes home. Where the
	// ground is another one (PathProvider::ground_revision) walks lead round what was put in their way.
	//
	// Takes in the households that were added at the end of the population, with their agendas, groups and floating tasks. They are put where their
	// agendas want them now. False: the agendas do not reach as far as the population.
	bool take_in_people();
	// Must be called for everybody whose agenda in the AgendaSet became another one (agenda/agenda_edit.h): goes on with what the new one says, at
	// once where its time has come.
	void take_in_agenda(PersonId id);
	// Everybody's agenda becomes another one, and so does the program that the rules in them are of: `change` replaces what is in the AgendaSet, for the
	// same people, and gives that program; `overrides` as given to the generation of the new ones. What anybody does ends, and all go on from where they
	// are with what the new agendas say now. Groups on the way that the new agendas have, too, walk on. Floating tasks that were done today are not done again.
	void change_agendas(const std::function<std::shared_ptr<const Program>()> &change, std::vector<AttributeOverride> overrides = {});
	// The game has the person from now on: it leaves its rule, group, seat and building; its body is freed, for the game shows it. It counts as
	// waiting outdoors. False: it is not there, or was taken already.
	bool take_over(PersonId id);
	// Where the game has a person whom it took over. False: it did not.
	bool place_taken(PersonId id, glm::vec3 position);
	// Gives it back: it gets a body where it is and goes on with its agenda from there; who is where nobody can walk goes straight to the nearest
	// point where people can. False: the game does not have it.
	bool release(PersonId id);
	// Gone for good; its id stays. False: it is not there.
	bool remove_person(PersonId id);

	size_t person_count() const { return _persons.size(); }
	PersonState state(PersonId id) const { return _persons[index_of(id)].state; }
	glm::vec3 position(PersonId id) const;
	PersonView view(PersonId id) const;
	bool is_outside(PersonId id) const { return state(id) != PersonState::Inside; }
	uint32_t outside_count() const { return _statistics.outside; }
	// Persons inside a building, by count, and by name in order of id (takes time proportional to the population).
	uint32_t inside_count(BuildingId building) const;
	std::vector<PersonId> persons_inside(BuildingId building) const;
	std::vector<PersonId> persons_outside() const;
	// Stands outdoors without a rule or a group that wants it to: there is no way to where it should be.
	bool is_stranded(PersonId id) const;
	bool is_living(PersonId id) const { return index_of(id) < _persons.size() && !record(id).is_absent(); }
	// The entry or hole of its agenda that holds at that time.
	PlannedEntry plan_at(PersonId id, SimTime time) const { return planned_entry_at(_agendas.agenda_of(id), time); }
	bool is_place_free(ObjectId object) const { return _reservations.is_free(_city, object); }
	// Who has that place, on the way there included; Invalid: nobody.
	PersonId place_holder(ObjectId object, uint8_t place) const { return _reservations.holder(object, place); }
	// False: the city was edited since the last step, which people hear of with the next one.
	bool knows_city() const { return _city_revision == _city.revision(); }

	const SimulationStatistics &statistics() const { return _statistics; }
	// Run-time errors of delayed rules and the like: a missing type once, everything else once for each place in the rules.
	const Diagnostics &diagnostics() const { return _diagnostics; }

	// Told in the order of adding. Must outlive the simulation or be removed.
	void add_observer(SimulationObserver &observer) { _observers.push_back(&observer); }
	void remove_observer(SimulationObserver &observer);

	const CityModel &city() const { return _city; }
	const PathProvider &paths() const { return _paths; }
	const Population &population() const { return _population; }
	const SimulationSettings &settings() const { return _settings; } // seed, patience and overrides as restored
	const AgendaSet &agendas() const { return _agendas; }

private:
	friend class Behavior;

	// simulation.cpp: the loop
	PersonRecord &record(PersonId id) { return _persons[index_of(id)]; }
	const PersonRecord &record(PersonId id) const { return _persons[index_of(id)]; }
	void run_due(const Due &due);
	void wake(PersonId id);
	void on_due(PersonId id);
	void schedule(PersonId id);
	bool take_in_city_edits();
	void make_room();

	// simulation_report.cpp: what observers and the host hear
	void emit(PersonId id, SimEventKind kind, Target place = {});
	void note(Diagnostic diagnostic);
	void close_span(PersonId id);
	void change_outside(int change);
	bool has_bodies() const { return _settings.has_live_bodies && !_is_replaying; }
	void show_standing(PersonId id);
	void show_walking(PersonId id);
	void show_person(PersonId id);

	// simulation_walk.cpp: being somewhere and getting elsewhere
	bool go_to_building(PersonId id, BuildingId building, Purpose purpose);
	bool go_to_point(PersonId id, Target goal, glm::vec3 point, Purpose purpose);
	bool has_just_come_in(PersonId id) const;
	void find_starts(PersonId id, std::span<const PersonId> companions);
	void find_shortest_way(std::span<const glm::vec3> goals);
	const std::vector<glm::vec3> &find_way(PersonId id, std::span<const glm::vec3> goals, std::span<const PersonId> companions = {});
	void set_out(PersonId id, uint32_t walk, Target goal, Purpose purpose);
	void find_doors(BuildingId building, std::vector<glm::vec3> &doors) const;
	void stop_walk(PersonId id);
	void arrive(PersonId id);
	void end_walk(PersonId id);
	void leave_building(PersonId id, glm::vec3 door);
	void enter_building(PersonId id, BuildingId building, glm::vec3 door);
	void stand(PersonId id, PersonState state, Target place, glm::vec3 position);
	void use_place(PersonId id, AgentPose pose);
	bool reserve_place(PersonId id, ObjectId object);
	void release_place(PersonId id);

	// simulation_tasks.cpp: entries of the agenda
	BuildingId home_of(PersonId id) const { return _population.home_of(id); }
	PlannedEntry entry_of(PersonId id) const;
	void begin_entry(PersonId id, bool is_renewed = false);
	void begin_stay(PersonId id, BuildingId building);
	void begin_rule(PersonId id, RuleId rule, SimTime end);
	void begin_slot(PersonId id);
	void resume_rule(PersonId id);
	void end_rule(PersonId id, SimEventKind how);
	BuildingId resting_place(PersonId id) const;
	void try_again(PersonId id);
	BuildingId place_until_next(PersonId id) const;
	void idle_until_next(PersonId id);
	void note_lateness(PersonId id);
	uint32_t choose_floating_task(PersonId id) const;
	uint32_t borrow_behavior();

	// simulation_groups.cpp: walking together
	void begin_accompany(PersonId id, uint32_t group);
	uint32_t call_party(uint32_t group, PersonId caller);
	bool is_expected(PersonId id, uint32_t group, PersonId caller) const;
	bool waits_in_vain(PersonId id) const;
	void lead_on(uint32_t party);
	void lead_on_or_end(uint32_t party);
	bool is_with_leader(PersonId leader, PersonId joiner) const;
	void collect_here(Party &party);
	PersonId nearest_pending(const Party &party) const;
	void wait_for_pending(Party &party);
	void fetch(uint32_t party, PersonId joiner);
	bool walk_together(Party &party, Target goal, std::span<const glm::vec3> points, Purpose purpose);
	void follow(const Party &party, uint32_t walk, Target goal, Purpose purpose);
	void group_walk_ended(PersonId leader, Purpose purpose);
	void enter_together(Party &party, BuildingId building, glm::vec3 door);
	void lose_patience(PersonId id);
	void go_alone(PersonId id);
	void end_party(uint32_t party);
	void go_on_after_group(PersonId id);
	void leave_party(PersonId id);

	// simulation_edits.cpp
	uint16_t find_lived_entry(PersonId id) const;
	void mend_goals();
	void mend_ways();
	void mend_way(PersonId id, uint64_t since);
	bool is_led(PersonId id) const;
	bool has_place(const Target &place, const PersonRecord &person, glm::vec3 position) const;
	void mend_goal(PersonId id);
	void put_out(PersonId id);
	void drop_everything(PersonId id);

	// simulation_renewal.cpp
	uint32_t find_same_group(PersonId id) const;
	void keep_parties(std::span<const PersonId> living);
	void forget_unexpected(uint32_t party);

	// simulation_state.cpp
	bool is_sound(const SavedState &state) const;
	bool is_sound(const SavedState &state, PersonId id) const;
	bool are_parties_sound(const SavedState &state) const;
	bool names_a_place(const PersonRecord &person) const;
	bool wake_behaviors(const SavedState &state, std::vector<std::unique_ptr<Behavior>> &behaviors);
	void take_over_state(SavedState &&state, std::vector<std::unique_ptr<Behavior>> &&behaviors);
	void take_in_record(PersonId id);

	// time_jump.cpp
	void place_everybody(SimTime time);
	void replay_household(const Household &household, SimTime time);
	void end_replay(SimTime time, size_t first_person);
	SimTime find_anchor(const Household &household, SimTime time) const;
	bool is_settled(PersonId id, SimTime time, BuildingId &building) const;
	bool is_pool_full(PersonId id, SimTime time, SimTime &before) const;
	BuildingId building_of(PersonId id, const PlannedEntry &entry) const;
	void put_inside(PersonId id, SimTime time);
	void put_into(PersonId id, BuildingId building);
	void forget_everything(SimTime begin);
	void show_everybody();
	void hide_everybody();
	Duration longest_walk() const;

	const CityModel &_city;
	const PathProvider &_paths;
	const Population &_population;
	const AgendaSet &_agendas;
	std::shared_ptr<const Program> _program;
	SimulationSettings _settings;
	AgentHost *_host;

	static constexpr int32_t never_taken = std::numeric_limits<int32_t>::min();

	SimTime _now;
	bool _has_started = false;
	bool _is_replaying = false; // during a jump: nobody is told anything
	Duration _settling; // longer than any walk through this city should take
	uint64_t _city_revision = 0;
	uint64_t _ground_revision = 0; // of PathProvider, that walks know
	EventQueue _queue;
	DueHeap _replay_queue; // in its place while a household is replayed
	std::vector<PersonRecord> _persons;
	std::vector<uint32_t> _inside_counts; // by BuildingId
	std::vector<int32_t> _floating_taken; // by index in AgendaSet::floating_tasks: the day on which it left the pool
	std::vector<uint32_t> _party_of_group; // by group
	std::vector<Party> _parties;
	std::vector<uint32_t> _free_parties;
	WalkPool _walks;
	Reservations _reservations;
	std::unique_ptr<agenda::World> _rule_world; // null without a program
	VmStacks _rule_stacks; // of rules that run right now, one inside of another
	std::vector<std::unique_ptr<Behavior>> _behaviors;
	std::vector<uint32_t> _free_behaviors;
	std::vector<SimulationObserver *> _observers;
	SimTime _last_entry = never; // the last moment at which anybody went into a building, and who did so then
	std::vector<PersonId> _last_to_enter;
	// Scratch, kept so that steps do not allocate.
	struct DoorPair {
		float distance = 0.0f; // as the crow flies
		uint32_t from = 0, to = 0;
		friend auto operator<=>(const DoorPair &, const DoorPair &) = default;
	};
	std::vector<DoorPair> _door_pairs;
	std::vector<glm::vec3> _from_points, _to_points, _way, _best_way;
	SimulationStatistics _statistics;
	Diagnostics _diagnostics;
};

} // namespace pcg
