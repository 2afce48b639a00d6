#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "core/sim/observer.h"

namespace pcg {

// One stretch of a life as it was lived, with the entry of the agenda that it served.
struct LivedEntry {
	PersonId person = PersonId::Invalid;
	SimTime start;
	SimTime end;
	glm::vec3 position{ 0.0f }; // at the end
	float metres = 0.0f; // walked
	Target place;
	PersonId leader = PersonId::Invalid;
	SimTime planned_start;
	SimTime planned_end;
	uint16_t planned_task = PlannedEntry::hole;
	TaskKind planned_kind = TaskKind::StayInside;
	PersonState state = PersonState::Inside;
};

// Keeps every lived stretch of every person, in the order in which they ended. 88 bytes each: some 30 a person and day.
class LivedLog : public SimulationObserver {
public:
	const std::vector<LivedEntry> &entries() const { return _entries; }
	// By person, then by time.
	std::vector<LivedEntry> sorted() const;
	std::vector<LivedEntry> of(PersonId id) const;
	void clear() { _entries.clear(); }

	void on_lived(const LivedSpan &span) override;

private:
	std::vector<LivedEntry> _entries;
};

// "inside", "walking", "at-place", "waiting".
std::string_view state_name(PersonState state);

} // namespace pcg
