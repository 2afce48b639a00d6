#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "core/agenda/task.h"
#include "core/base/sim_time.h"
#include "core/sim/inserted_entries.h"

// Reads an agenda at moments of absolute time: day masks, entries that run past midnight, and the holes between entries, which are spent
// at home (PCG language, section 5).
namespace pcg {

// One entry on one day, or a hole.
struct PlannedEntry {
	static constexpr uint16_t hole = 0xFFFF;
	static constexpr uint16_t inserted = 0xFFFE; // an InsertedEntry

	SimTime start; // of a hole: the end of the entry before it, or a week ago if there is none
	SimTime end; // of a hole: the start of the next entry, or a week later if there is none
	uint32_t target = 0xFFFFFFFF; // as in Task
	uint16_t task = hole; // index in the person's tasks, or `inserted`
	TaskKind kind = TaskKind::StayInside;
	bool is_start_cut = false; // as in Task

	bool is_hole() const { return task == hole; }
};

// The entry or hole that holds at `time`: start <= time < end.
PlannedEntry planned_entry_at(std::span<const Task> tasks, SimTime time);
// The same with what was inserted, which cuts what it overlaps.
PlannedEntry planned_entry_at(std::span<const Task> tasks, std::span<const InsertedEntry> inserted, SimTime time);

} // namespace pcg
