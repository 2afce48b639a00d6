#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/ids.h"
#include "core/base/sim_time.h"

// One entry of an agenda. 24 bytes: a million persons carry five or six each.
namespace pcg {

enum class TaskKind : uint8_t {
	StayInside, // hidden inside `target` (a BuildingId) from start to end
	GoToBuilding, // leaves for `target` at start, inside on arrival, until end
	Accompany, // walks in the group `target` (a GroupId): see group.h
	DelayedRule, // runs the rule `target` (a RuleId) from start, cut short at end
	FloatingSlot, // free time, filled from the person's pool of floating tasks
};
constexpr size_t task_kind_count = size_t(TaskKind::FloatingSlot) + 1;

// Whether such an entry has the person inside of a building.
constexpr bool is_stay(TaskKind kind) { return kind == TaskKind::StayInside || kind == TaskKind::GoToBuilding; }

struct Task {
	int32_t start_ms = 0; // since 0h of each day of `days`; in [0, 24 h)
	int32_t end_ms = 0; // > start; beyond 24 h it runs on into the next day, at most to start + 24 h
	uint32_t target = 0xFFFFFFFF;
	uint32_t origin = 0; // index in AgendaSet::origins: the operation call that wrote it (rule, file, line), for "why"
	uint16_t generation = 0; // counts insertions of this agenda: the larger is the newer
	TaskKind kind = TaskKind::StayInside;
	DayMask days = all_days;
	uint16_t name : 13 = 0; // index in AgendaSet::names; 0: none
	uint16_t days_later : 3 = 0; // that it starts after the day it was written for, modulo 7; kept of entries with a name or a requirement
	uint8_t requirement = 0; // index in AgendaSet::requirements; 0: none
	bool is_start_cut = false; // a newer entry took its beginning away: `start` is not a time that a rule wrote

	Duration start() const { return { start_ms }; }
	Duration end() const { return { end_ms }; }
};
constexpr size_t max_task_names = 1 << 13;
constexpr size_t max_task_requirements = 1 << 8;
static_assert(sizeof(Task) == 24);

// With the start brought into [0, 24 h) and the days moved along; the week is a circle.
Task normalized(Task task);
// The mask `shift` days later.
DayMask rotate_days(DayMask days, int64_t shift);
// "mon, tue, sun"; "every day".
std::string days_text(DayMask days);
// "stayInside", "goToBuilding", .. as in the rule files.
std::string_view task_kind_name(TaskKind kind);

} // namespace pcg
