#pragma once

#include <string>
#include <vector>

#include "core/agenda/agenda.h"
#include "core/agenda/context.h"
#include "core/agenda/requirement.h"

namespace pcg::agenda {

// Writes the agendas of one household after the other (paper, Algorithm 1). Buffers are kept between households.
class GenerationContext final : public Context {
public:
	using Context::Context;

	// Forgets what was written and starts on this household. Entries apply to `days` only.
	void begin_household(HouseholdId id, DayMask days = all_days);
	// Starts the same household again for other days, keeping what was written.
	void begin_days(DayMask days);
	// The rules asked which day it is while they wrote several: they have to be run once for each (see `day`).
	bool wants_single_days() const { return _wants_single_days; }

	DayMask days() const { return _days; }
	// Those of the days(..) around; a run may be for fewer.
	DayMask named_days() const { return _named_days; }
	void set_named_days(DayMask days) {
		_named_days = days;
		_days = days & _run_days;
	}
	// Of a days(..) inside of another, in the running call. A rule may be called within several: only where none of its calls in a household leaves a day
	// is that told.
	void note_inner_days(uint32_t address, DayMask outer, DayMask left);
	// What entries are written with: the name that they get, and what they require; numbers as in names() and requirements().
	uint16_t entry_name() const { return _entry_name; }
	void set_entry_name(uint16_t name) { _entry_name = name; }
	uint8_t requirement() const { return _requirement; }
	void set_requirement(uint8_t requirement) { _requirement = requirement; }
	// The number of a name or a requirement, which may be new; 0 and a failed run if there are too many. They are kept between households.
	uint16_t number_of(Vm &vm, std::string_view name);
	uint8_t number_of(Vm &vm, const Requirement &requirement);
	const std::vector<std::string> &names() const { return _names; }
	const std::vector<Requirement> &requirements() const { return _requirements; }
	// When the rules have run: takes out what requires entries that newer ones took away, and walks of leaders from whom others called everybody away, lets
	// joiners without a leader go alone, and reports it and days(..) that left none.
	void finish_household();

	Agenda &agenda_of(PersonId member) { return _members[index_in_household(member)].agenda; }
	const std::vector<FloatingTask> &floating_tasks_of(PersonId member) const { return _members[index_in_household(member)].floating; }
	const std::vector<Group> &groups() const { return _groups; }
	std::vector<Diagnostic> &diagnostics() { return _diagnostics; }

	// An entry for the focused person on the days that hold here; times in seconds. What cannot hold is a warning at the place of the call.
	// Fails the run if nobody is focused. Origins are addresses in the program until all households are done.
	Flow insert(Vm &vm, std::string_view operation, TaskKind kind, double start, double end, uint32_t target);
	// Fails the run when an agenda grows beyond any sense.
	bool insert_task(Vm &vm, PersonId member, const Task &task);
	void add_floating_task(Vm &vm, FloatingTask task);
	uint32_t add_group(Group group);

	bool is_simulating() const override { return false; }
	// Within days("sat") {..} that day. Where several days are written at once the household is run again, once for each day.
	Value day(Vm &vm) override;
	Value time(Vm &vm) override;
	bool present_position(glm::vec3 &position) const override;
	bool has_free_place(ObjectId) const override { return true; }
	void report(Diagnostic diagnostic) override;

private:
	struct Member {
		Agenda agenda;
		std::vector<FloatingTask> floating;
	};

	struct InnerDays {
		uint32_t address;
		DayMask outer, left;
	};

	void insert_named_task(PersonId member, Task task);
	void drop_unmet_tasks();
	void report_empty_days();
	void report_dropped(const DroppedTask &dropped);
	struct DropWords {
		std::string_view id;
		std::string reason, hint;
	};
	DropWords words_of(const DroppedTask &dropped) const;
	bool has_lost_walkers();
	bool has_walk(PersonId member, uint32_t group, DayMask days);
	size_t index_in_household(PersonId member) const { return index_of(member) - index_of(household().first_member); }

	std::vector<Member> _members; // at least as many as the household has
	std::vector<Agenda *> _agendas; // of the household's members
	std::vector<Group> _groups;
	std::vector<Diagnostic> _diagnostics;
	std::vector<std::string> _names{ "" };
	std::vector<Requirement> _requirements{ {} };
	std::vector<NamedTask> _named_tasks; // of this household, as written
	std::vector<InnerDays> _inner_days; // of this household
	DayMask _run_days = all_days, _named_days = all_days;
	DayMask _days = all_days; // both
	uint16_t _entry_name = 0;
	uint8_t _requirement = 0;
	bool _has_requirements = false; // an entry of this household has
	bool _wants_single_days = false;
};

// The context behind an operation that writes agendas, or null where such operations are disregarded (in delayed rules).
inline GenerationContext *writing_context(Vm &vm) {
	Context &context = context_of(vm);
	return context.is_simulating() ? nullptr : static_cast<GenerationContext *>(&context);
}

} // namespace pcg::agenda
