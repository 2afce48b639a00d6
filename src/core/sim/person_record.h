#pragma once

#include <cstdint>
#include <limits>

#include <glm/vec3.hpp>

#include "core/base/sim_time.h"
#include "core/ports/agent_host.h"
#include "core/sim/observer.h"

namespace pcg {

constexpr SimTime never{ std::numeric_limits<int64_t>::max() };

// Whose wish a walk is: who goes on when it ends.
enum class Purpose : uint8_t {
	Agenda, // an entry; nobody waits for the arrival
	Rule, // a delayed rule: it is resumed
	Pickup, // a group's leader on the way to members
	Group, // a group on the way to its goal
};

enum class Presence : uint8_t {
	Living, // its agenda leads it
	Taken, // the game has it
	Removed, // gone for good; the id stays
};

// What the simulation keeps of each person, on the way or not. A million of them must fit: see the assertion.
struct PersonRecord {
	static constexpr uint32_t none = 0xFFFFFFFF;

	SimTime due = never; // when what the person does by itself is over: an arrival, a wait
	SimTime entry_start;
	SimTime entry_end; // when the next entry begins
	SimTime rule_end = never; // when the running rule is cut short, at most entry_end
	SimTime since; // begin of the present span
	SimTime queued = never; // the moment in the queue that holds; others of this person are out of date
	glm::vec3 position{ 0.0f }; // where it stands, or the door it went in by, or where the walk began
	uint32_t place = none; // index of what it is at, or walks to; see place_kind
	uint32_t walk = none; // in the WalkPool
	uint32_t behavior = none; // of the running rule
	uint32_t party = none; // of the group walk that it takes part in; entries wait until that is over
	float first_metre = 0.0f; // of the walk, at the begin of the present span
	uint16_t entry_task = PlannedEntry::hole;
	PersonState state = PersonState::Inside;
	Target::Kind place_kind = Target::Kind::None;
	Purpose purpose = Purpose::Agenda;
	AgentPose pose = AgentPose::Stand;
	TaskKind entry_kind = TaskKind::StayInside;
	uint8_t object_place = 0xFF; // reserved place of `reserved_object`
	uint32_t reserved_object = none;
	bool can_be_late = false; // the entry says when it wants the person inside, and that was not told yet
	Presence presence = Presence::Living;

	// Called to a group walk and done with everything else: entries begin only after it.
	bool is_in_group() const { return party != none; }
	// With the group to its goal, or with its leader to those who wait for it.
	bool walks_in_group() const { return is_in_group() && state == PersonState::Walking && (purpose == Purpose::Group || purpose == Purpose::Pickup); }
	// Neither a group nor a rule leads it: what it does is what its agenda says.
	bool is_on_its_own() const { return !is_in_group() && behavior == none; }
	bool is_absent() const { return presence != Presence::Living; }
	Target target() const { return { place_kind, place }; }
	bool is_in_hole() const { return entry_task == PlannedEntry::hole; }
};
static_assert(sizeof(PersonRecord) <= 96);

} // namespace pcg
