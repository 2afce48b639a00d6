#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include <glm/vec3.hpp>

#include "core/base/ids.h"
#include "core/base/sim_time.h"
#include "core/sim/day_plan.h"

// What a simulation tells about the lives it runs. Calls come in order of time, then of cause; they must not change the simulation.
namespace pcg {

// PCG language, section 8: one of these, always.
enum class PersonState : uint8_t {
	Inside, // in a building; without a body
	Walking, // on the way: a path, a departure, a speed
	AtPlace, // at an object or inside a zone
	Waiting, // standing outdoors
};

// Something that a person goes to or is at.
struct Target {
	enum class Kind : uint8_t { None, Building, Zone, Object, Person };
	Kind kind = Kind::None;
	uint32_t index = 0xFFFFFFFF;

	bool is_none() const { return kind == Kind::None; }
	BuildingId building() const { return kind == Kind::Building ? BuildingId(index) : BuildingId::Invalid; }
	ZoneId zone() const { return kind == Kind::Zone ? ZoneId(index) : ZoneId::Invalid; }
	ObjectId object() const { return kind == Kind::Object ? ObjectId(index) : ObjectId::Invalid; }
	friend bool operator==(const Target &, const Target &) = default;
};

constexpr Target target_of(BuildingId id) { return { Target::Kind::Building, index_of(id) }; }
constexpr Target target_of(ZoneId id) { return { Target::Kind::Zone, index_of(id) }; }
constexpr Target target_of(ObjectId id) { return { Target::Kind::Object, index_of(id) }; }
constexpr Target target_of(PersonId id) { return { Target::Kind::Person, index_of(id) }; }

enum class SimEventKind : uint8_t {
	TaskStarted, // an entry of the agenda, or a hole, began; `place` = where it leads, if that is known
	LeftBuilding,
	EnteredBuilding,
	SetOut, // a walk began; `place` = its goal
	Arrived, // at a zone, an object or another person
	UsedObject, // sat down on a place of it, or used it standing
	LeftObject,
	FloatingTaskStarted,
	RuleEnded, // a delayed rule or floating task came to its own end
	RuleCut, // .. or its time was over first
	ArrivedLate, // inside, later than the entry said
	PatienceRanOut, // waited in vain for the group and goes alone
	Unreachable, // no way to `place`, or it is gone
	NoFreePlace, // all places of the object are taken
	RuleFailed, // a run-time error, told in Simulation::diagnostics()
	GoalChanged, // `place`, where the person was or walked to, was moved or removed, or the ground on the way there is another one
	Added, // a new person came to live here
	Removed, // it is gone for good
	TakenOver, // by the game, which moves it from now on
	Released, // by the game; `position` is where it goes on
};
constexpr size_t sim_event_kind_count = size_t(SimEventKind::Released) + 1;
// "task-started", "left-building" ..: as in traces.
std::string_view event_name(SimEventKind kind);

struct SimEvent {
	SimTime time;
	PersonId person = PersonId::Invalid;
	SimEventKind kind = SimEventKind::TaskStarted;
	Target place;
	glm::vec3 position{ 0.0f };
};

// A stretch of somebody's life in one state under one entry. The spans of a person follow each other without a gap from the start (or the
// last time jump) on.
struct LivedSpan {
	PersonId person = PersonId::Invalid;
	SimTime start;
	SimTime end; // >= start
	PersonState state = PersonState::Inside;
	Target place; // the building, object or zone; of a walk: where it leads
	glm::vec3 position{ 0.0f }; // at the end of the span
	PlannedEntry entry;
	PersonId leader = PersonId::Invalid; // of the group that the person walks with
	// Of a walk: the whole path, from which the stretch [first_metre, last_metre] was walked. Valid during the call only.
	std::span<const glm::vec3> path;
	double first_metre = 0.0;
	double last_metre = 0.0;
};

class SimulationObserver {
public:
	virtual ~SimulationObserver() = default;
	virtual void on_event(const SimEvent &) {}
	virtual void on_lived(const LivedSpan &) {}
	// Everybody was placed anew, by a time jump or, with `from` equal to `to`, by the start; what follows belongs to a life from `to` on.
	virtual void on_jump(SimTime /*from*/, SimTime /*to*/) {}
};

} // namespace pcg
