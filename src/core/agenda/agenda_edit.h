#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/agenda/agenda.h"
#include "core/agenda/requirement.h"
#include "core/population/population.h"

// Changes of agendas that were generated already, such as while a simulation lives them: the same rules as while they were written.
namespace pcg {

struct AgendaChange {
	bool is_inserted = false; // false: nothing changed, the entry has no length, no days, no such person, or lasts longer than 24 h
	std::vector<PersonId> changed; // whose agendas are other ones now, ascending; spans of their tasks are void
	std::vector<DroppedTask> dropped; // what required something that the new entry took away
};

// The newest wins: what the entry overlaps is split, trimmed or dropped (PCG language, section 5), and so is, in the whole household, what
// required that. The task's own `name` and `requirement` are numbers of the set; its origin is set to one without a rule.
// Without `day` it holds in every week on the task's days; with one on that day only, counted as in SimTime, and the task's days mean nothing. What
// is in an agenda for a single day stays there under entries of every week that do not overlap it.
AgendaChange insert_task(AgendaSet &agendas, const Population &population, PersonId person, Task task, std::optional<int64_t> day = std::nullopt);
// Changes for single days before that one are forgotten: then the week holds there, should anybody jump back.
void forget_days_before(AgendaSet &agendas, int64_t day);
// Those of persons who come behind the others: groups, names and the like are numbered anew. Views of generated tasks are void.
void append_agendas(AgendaSet &agendas, const AgendaSet &more);
// The number of a name for Task::name, added to the set if it is new; 0 if the set is full.
uint16_t task_name(AgendaSet &agendas, std::string_view name);
// The same of Task::requirement.
uint8_t task_requirement(AgendaSet &agendas, const Requirement &requirement);

} // namespace pcg
