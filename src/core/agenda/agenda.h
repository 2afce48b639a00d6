#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/agenda/task.h"
#include "core/base/ids.h"
#include "core/base/untouched_allocator.h"

// A person's tasks, in order and without overlap on every day of the week; the newest wins (paper, "Generation of the agendas").
namespace pcg {

// Works on one person's tasks while they are written. Kept sorted by (start, days).
class Agenda {
public:
	Agenda() = default;
	// Goes on where another one ended: `tasks` as tasks() gave them.
	explicit Agenda(std::span<const Task> tasks);

	// Inserts `task` whole. What it overlaps is split in two, trimmed or dropped, on the days of its mask only, the days before and after
	// included where one of both runs past midnight. A start outside [0, 24 h) is moved with its days (PCG language, section 5); the week
	// is a circle. False, and nothing changes: end <= start, no days, or longer than 24 h. Pieces of one entry that end up equal on
	// different days are one entry.
	bool insert(const Task &task);
	// Takes the entry of this index out on these days.
	void remove(size_t index, DayMask days);
	void clear();
	const std::vector<Task> &tasks() const { return _tasks; }
	// All entries are of all days and end by midnight; may be false although it is so.
	bool is_same_every_day() const { return _is_same_every_day; }
	// The task that holds at this time of that week day, one that began the day before included; null in a hole.
	const Task *at(int weekday, Duration time_of_day) const;

private:
	void insert_same_every_day(const Task &task);
	void replace(size_t first, size_t last, size_t count, const Task &filler);
	void insert_day_by_day(const Task &task);

	std::vector<Task> _tasks;
	std::vector<Task> _scratch; // kept between insertions, so that they do not allocate
	uint16_t _generation = 0; // stays at its largest value once that is reached
	bool _is_same_every_day = true;
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

// The days on which the group sets out whose walk this entry, or what newer entries left of it, is a part of: what begins behind midnight may be of the
// evening before.
inline DayMask set_out_days(const Group &group, const Task &walk) {
	return walk.start_ms < group.start_ms ? rotate_days(walk.days, -1) : walk.days;
}

// Whether the entry is the walk of this group, or what newer entries left of it.
inline bool is_walk(const Task &task, uint32_t group) { return task.kind == TaskKind::Accompany && task.target == group; }

// Where an entry came from: the call in the rule file. For the inspector's "why".
struct TaskOrigin {
	std::string rule;
	std::string file;
	uint32_t line = 0;
};

// What has to be lived for an entry to make sense; see requirement.h.
struct Requirement {
	uint16_t name = 0; // of the required entry, in AgendaSet::names
	bool is_after = false; // it has to be over before
	uint8_t outer = 0; // one more that has to hold, in AgendaSet::requirements; 0: none
	friend bool operator==(const Requirement &, const Requirement &) = default;
};

// What begins on one day, all of it, in place of what the week says.
struct SingleDay {
	int64_t day = 0; // as SimTime counts them
	std::vector<Task> tasks; // in order, each with the day of the week of `day` alone
};

// An agenda that was changed after it was generated (agenda_edit.h).
struct ChangedAgenda {
	std::vector<Task> week;
	std::vector<SingleDay> single_days; // ascending
};

// One person's agenda. Holds until it is changed.
struct AgendaView {
	std::span<const Task> week;
	std::span<const SingleDay> single_days;

	// What begins on that day is among these: those with its day of the week.
	std::span<const Task> on(int64_t day) const { return single_days.empty() ? week : changed_on(day); }

	std::span<const Task> changed_on(int64_t day) const; // the same; the slow way
};

// Agendas of a whole population, one behind the other.
struct AgendaSet {
	std::vector<Task, UntouchedAllocator<Task>> tasks; // as generated
	std::vector<uint32_t> first_task; // person_count + 1 offsets
	std::vector<FloatingTask> floating_tasks;
	std::vector<uint32_t> first_floating_task; // person_count + 1 offsets
	std::vector<Group> groups; // Task::target of Accompany
	std::vector<TaskOrigin> origins;
	std::vector<std::string> names; // of entries, for requirements; the first is empty. Empty if no rule names any
	std::vector<Requirement> requirements; // the first means none. Empty if no rule has any
	std::unordered_map<uint32_t, ChangedAgenda> changed; // by person

	AgendaView agenda_of(PersonId id) const {
		const uint32_t i = index_of(id);
		if (!changed.empty()) [[unlikely]] {
			const auto found = changed.find(i);
			if (found != changed.end()) {
				return { found->second.week, found->second.single_days };
			}
		}
		return { { tasks.data() + first_task[i], first_task[i + 1] - first_task[i] }, {} };
	}
	// Of every week.
	std::span<const Task> tasks_of(PersonId id) const { return agenda_of(id).week; }
	std::span<const FloatingTask> floating_tasks_of(PersonId id) const {
		const uint32_t i = index_of(id);
		return { floating_tasks.data() + first_floating_task[i], first_floating_task[i + 1] - first_floating_task[i] };
	}
	size_t person_count() const { return first_task.empty() ? 0 : first_task.size() - 1; }
};

// Those who walk with the leader of a group on any of these days of its setting out; newer entries may have called joiners away. `first`: whom the set
// counts from.
std::vector<PersonId> joiners_on(const AgendaSet &agendas, uint32_t group, DayMask days, PersonId first = PersonId{ 0 });
// Those who walk with it where it sets out on this day, as SimTime counts, with what is for single days.
std::vector<PersonId> joiners_on_day(const AgendaSet &agendas, uint32_t group, int64_t day);

} // namespace pcg
