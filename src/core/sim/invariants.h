#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "core/sim/observer.h"
#include "core/sim/simulation.h"

// Checks the promises of PCG language, section 8, while a simulation runs: from what observers hear and from the positions that anybody can
// ask for, against the agendas and the city, not from the simulation's own books.
namespace pcg {

enum class Promise : uint8_t {
	NoTeleport, // no two positions further apart than elapsed time x walking speed, other than across a jump
	NoWalkToNowhere, // every walk has a path, and the path ends where it should
	NoDoubleSeat, // no place of an object holds two persons, or is held by somebody who is neither there nor on the way
	NoTwoPlaces, // nobody enters a building while inside one, or leaves one that it is not in
	NoChildAlone, // who is under 18 and walks in a group has its leader beside it all the way, and goes alone only after waiting in vain
	DayCovered, // everybody's life is without gaps
	RightBuilding, // whom the agenda wants inside a building is in it or on the way, if there is one; nobody is in one that is gone; they count right
};
constexpr size_t promise_count = size_t(Promise::RightBuilding) + 1;
// "teleports", "walks_to_nowhere" ..: the name under which breaks are counted.
std::string_view promise_name(Promise promise);

// Attach before start(). Costs time proportional to the population at each check(); events and spans are checked as they come.
class InvariantChecker : public SimulationObserver {
public:
	explicit InvariantChecker(Simulation &simulation); // adds itself as an observer
	~InvariantChecker() override;
	InvariantChecker(const InvariantChecker &) = delete;
	InvariantChecker &operator=(const InvariantChecker &) = delete;

	// Looks at everybody now. Call it after steps, as often as wanted.
	void check();
	// At the end, after Simulation::flush_lived(): everybody's day must reach to now().
	void finish();

	uint64_t broken(Promise promise) const { return _broken[size_t(promise)]; }
	uint64_t broken_total() const;
	// Walks of children to the goal of a group for which they had waited in vain (PCG language, section 5): no broken promise. Those count that are the
	// first after waiting, under whatever entry: the group's may be over by then.
	uint64_t children_alone_after_waiting() const { return _excused; }
	// The first few, in words.
	const std::vector<std::string> &examples() const { return _examples; }

	void on_event(const SimEvent &event) override;
	void on_lived(const LivedSpan &span) override;
	void on_jump(SimTime from, SimTime to) override;

private:
	static constexpr double tolerance = 0.02; // metres: positions are floats, times whole milliseconds
	static constexpr SimTime long_ago{ std::numeric_limits<int64_t>::min() };

	struct Life {
		glm::vec3 seen_position{ 0.0f };
		SimTime seen_time = never;
		BuildingId seen_building = BuildingId::Invalid;
		SimTime span_end = never;
		glm::vec3 span_position{ 0.0f };
		PersonState span_state = PersonState::Inside;
		BuildingId span_building = BuildingId::Invalid;
		glm::vec3 left_by{ 0.0f }; // the door, while that was where it is
		BuildingId inside = BuildingId::Invalid; // as far as events tell
		SimTime set_out; // of the walk that it is on
		bool walks_alone = false; // that walk is its own, although it may be in a group by now
		SimTime goal_changed = long_ago;
		SimTime gave_up_waiting = long_ago; // for a group
		Target missed_goal; // of that group, until it sets out for anywhere
		SimTime without_way = long_ago; // when it was known last that there was none to where it should be
		SimTime begin; // of the life; it may have set out before
		bool is_taken = false; // by the game, which may do with it what it likes
		bool is_gone = false;
	};

	void begin_life_of(PersonId id, SimTime time);
	void note_presence(const SimEvent &event);
	Life &life(PersonId id) { return _lives[index_of(id)]; }
	void complain(Promise promise, PersonId id, SimTime time, std::string text);
	void begin_life(SimTime time);
	void check_door(const SimEvent &event);
	void check_walk(const SimEvent &event);
	bool ends_at(const Target &goal, glm::vec3 end) const;
	bool is_near_door(BuildingId building, glm::vec3 position, double metres) const;
	void check_continuity(const LivedSpan &span, Life &known);
	void note_walk_begin(const SimEvent &event);
	bool is_child(PersonId id) const;
	void note_child(const LivedSpan &span);
	bool has_way(const PersonView &from, BuildingId to) const;
	void check_position(PersonId id, const PersonView &view);
	void check_building(PersonId id, const PersonView &view);
	void check_seats();
	void check_holders();
	void check_counts();
	void check_child(PersonId id, PersonId leader, glm::vec3 position, SimTime time);

	Simulation &_simulation;
	bool _is_alive = false;
	SimTime _life_start;
	std::vector<Life> _lives;
	uint64_t _excused = 0;
	std::array<uint64_t, promise_count> _broken{};
	std::vector<std::string> _examples;
};

} // namespace pcg
