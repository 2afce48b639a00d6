#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/agenda/task.h"
#include "core/base/ids.h"

// A person's tasks, in order and without overlap on every day of the week; the newest wins (paper, "Generation of the agendas").
namespace pcg {

// Works on one person's tasks while they are written. Kept sorted by (start, days).
class Agenda {
public:
	// Inserts `task` whole. What it overlaps is split in two, trimmed or dropped, on the days of its mask only, the days before and after
	// included where one of both runs past midnight. A start outside [0, 24 h) is moved with its days (PCG language, section 5); the week
	// is a circle. False, and nothing changes: end <= start, no days, or longer than 24 h. Pieces of one entry that end up equal on
	// different days are one entry.
	bool insert(Task task);
	void clear();
	const std::vector<Task> &tasks() const { return _tasks; }
	// The task that holds at this time of that week day, one that began the day before included; null in a hole.
	const Task *at(int weekday, Duration time_of_day) const;

private:
	std::vector<Task> _tasks;
	std::vector<Task> _scratch; // kept between insertions, so that they do not allocate
	uint16_t _generation = 0; // stays at its largest value once that is reached
};

// A task without a time, waiting for a floating slot (paper, "Floating tasks").
struct FloatingTask {
	RuleId rule = RuleId::Invalid;
	int32_t duration_ms = 0;
	float priority = 0.0f; // larger first
	DayMask days = all_days;
};

// A walk together: leader and joiners set out from the joiners' place when the leader is there (PCG language, section 5, accompany).
struct Group {
	PersonId leader = PersonId::Invalid;
	std::vector<PersonId> joiners; // ascending
	BuildingId goal = BuildingId::Invalid;
	int32_t start_ms = 0; // copied from the first joiner's entry
	int32_t end_ms = 0;
	DayMask days = all_days;
};

// Where an entry came from: the call in the rule file. For the inspector's "why".
struct TaskOrigin {
	std::string rule;
	std::string file;
	uint32_t line = 0;
};

// Agendas of a whole population, one behind the other.
struct AgendaSet {
	std::vector<Task> tasks;
	std::vector<uint32_t> first_task; // person_count + 1 offsets
	std::vector<FloatingTask> floating_tasks;
	std::vector<uint32_t> first_floating_task; // person_count + 1 offsets
	std::vector<Group> groups; // Task::target of Accompany
	std::vector<TaskOrigin> origins;

	std::span<const Task> tasks_of(PersonId id) const {
		const uint32_t i = index_of(id);
		return { tasks.data() + first_task[i], first_task[i + 1] - first_task[i] };
	}
	std::span<const FloatingTask> floating_tasks_of(PersonId id) const {
		const uint32_t i = index_of(id);
		return { floating_tasks.data() + first_floating_task[i], first_floating_task[i + 1] - first_floating_task[i] };
	}
	size_t person_count() const { return first_task.empty() ? 0 : first_task.size() - 1; }
};

} // namespace pcg
