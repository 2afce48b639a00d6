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
	NoDoubleSeat, // no place of an object holds two persons
	NoTwoPlaces, // nobody enters a building while inside one, or leaves one that it is not in
	NoChildAlone, // who is under 18 and walks in a group has its leader beside it all the way
	DayCovered, // everybody's life is without gaps
	RightBuilding, // whom the agenda wants inside a building is in it or on the way; buildings count right
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
	// The first few, in words.
	const std::vector<std::string> &examples() const { return _examples; }

	void on_event(const SimEvent &event) override;
	void on_lived(const LivedSpan &span) override;
	void on_jump(SimTime from, SimTime to) override;

private:
	struct Life {
		glm::vec3 seen_position{ 0.0f };
		SimTime seen_time = never;
		PersonState seen_state = PersonState::Inside;
		BuildingId seen_building = BuildingId::Invalid;
		SimTime span_end = never;
		glm::vec3 span_position{ 0.0f };
		PersonState span_state = PersonState::Inside;
		BuildingId span_building = BuildingId::Invalid;
		glm::vec3 left_by{ 0.0f }; // the door, while that was where it is
		BuildingId inside = BuildingId::Invalid; // as far as events tell
		SimTime set_out; // of the walk that it is on
		SimTime released{ std::numeric_limits<int64_t>::min() }; // the last time that the game gave it back
		bool is_taken = false; // by the game, which may do with it what it likes
		bool is_gone = false;
		bool is_stuck = false; // was told that there is no way to where the entry wants it
	};
	struct GroupWalk {
		PersonId person = PersonId::Invalid;
		PersonId leader = PersonId::Invalid; // Invalid: walks alone
		SimTime start, end;
		glm::vec3 position{ 0.0f };
	};

	void begin_life_of(PersonId id, SimTime time);
	void note_presence(const SimEvent &event);
	Life &life(PersonId id) { return _lives[index_of(id)]; }
	void complain(Promise promise, PersonId id, SimTime time, std::string text);
	void begin_life(SimTime time);
	void check_walk(const SimEvent &event);
	bool ends_at(const Target &goal, glm::vec3 end) const;
	bool is_near_door(BuildingId building, glm::vec3 position, double metres) const;
	void check_continuity(const LivedSpan &span, Life &known);
	void check_position(PersonId id, const PersonView &view);
	void check_building(PersonId id, const PersonView &view);
	void check_seats();
	void check_counts();
	void check_children();
	void note_group_walk(const LivedSpan &span);

	Simulation &_simulation;
	bool _is_alive = false;
	SimTime _life_start;
	std::vector<Life> _lives;
	std::vector<GroupWalk> _leaders_walks, _childrens_walks; // since the last check
	std::array<uint64_t, promise_count> _broken{};
	std::vector<std::string> _examples;
};

} // namespace pcg
