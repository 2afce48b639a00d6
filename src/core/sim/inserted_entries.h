#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/agenda/task.h"
#include "core/base/ids.h"
#include "core/base/sim_time.h"

namespace pcg {

// An entry for one day only, which the game put into an agenda while the simulation runs.
struct InsertedEntry {
	PersonId person = PersonId::Invalid;
	SimTime start;
	SimTime end; // > start
	uint32_t target = 0xFFFFFFFF; // as in Task
	TaskKind kind = TaskKind::StayInside;
	bool is_start_cut = false; // as in Task
};

// Those of everybody, by person, then by time, disjoint. They stand before the agenda; among themselves the newest wins.
class InsertedEntries {
public:
	// What it overlaps is split in two, trimmed or dropped.
	void insert(const InsertedEntry &entry);
	// Forgets what is over before that time.
	void drop_before(SimTime time);
	void drop(PersonId person);
	bool is_empty() const { return _entries.empty(); }
	std::span<const InsertedEntry> of(PersonId person) const;
	// The one under which the person is at that time; null if there is none.
	const InsertedEntry *at(PersonId person, SimTime time) const;

	const std::vector<InsertedEntry> &all() const { return _entries; }
	// False, and nothing changes: they are not in order, or overlap.
	bool restore(std::vector<InsertedEntry> entries);

private:
	std::vector<InsertedEntry> _entries;
};

} // namespace pcg
