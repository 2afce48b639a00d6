#pragma once

#include <cstdint>
#include <string_view>

#include "core/agenda/agenda.h"
#include "core/base/sim_time.h"

// Reads an agenda at moments of absolute time: day masks, entries that run past midnight, and the holes between entries, which are spent
// at home (PCG language, section 5).
namespace pcg {

// One entry on one day, or a hole.
struct PlannedEntry {
	static constexpr uint16_t hole = 0xFFFF;
	static constexpr uint16_t gone = 0xFFFE; // lived, but not in the agenda any more

	SimTime start; // of a hole: the end of the entry before it, or a week ago if there is none
	SimTime end; // of a hole: the start of the next entry, or a week later if there is none
	uint32_t target = 0xFFFFFFFF; // as in Task
	uint16_t task = hole; // index in AgendaView::on(start.day())
	TaskKind kind = TaskKind::StayInside;
	bool is_start_cut = false; // as in Task

	bool is_hole() const { return task == hole; }
};

// The entry or hole that holds at `time`: start <= time < end.
PlannedEntry planned_entry_at(const AgendaView &agenda, SimTime time);

} // namespace pcg
