#include "core/agenda/generation_context.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>

#include "core/agenda/operations/constant_checks.h"
#include "core/lang/diagnostic_at.h"

namespace pcg::agenda {

namespace {

constexpr size_t max_entries = 4096; // of one person; real days have a few dozen
constexpr size_t max_floating_tasks = 4096;
constexpr size_t max_names = 1000; // of entries, for all households that one thread takes at a time; rules have a handful

void fail_names(Vm &vm, std::string_view name) {
	if (name.empty()) {
		vm.fail("empty-name", "the name of an entry is empty", "write what it is for, such as task(\"bring\") { .. }");
	} else {
		vm.fail("too-many-names", "the rules name more than " + std::to_string(max_names) + " different entries, or require more than " + std::to_string(max_task_requirements),
				"give entries that mean the same the same name, whoever they belong to");
	}
}

// Rounded to the nearest millisecond, halves away from zero, as Duration::seconds does; of times that were checked.
int32_t to_ms(double seconds) {
	const double ms = seconds * 1000.0;
	const int32_t whole = int32_t(ms);
	const double rest = ms - double(whole);
	return whole + (rest >= 0.5) - (rest <= -0.5);
}

// Warns of times that cannot hold; an entry of more than a day is cut. False: nothing is to be inserted.
bool are_times_good(Vm &vm, std::string_view operation, double start, double &end) {
	std::optional<CallProblem> problem = times_problem(operation, start, end);
	const bool is_cut = problem && problem->id == too_long_id;
	end = is_cut ? start + day_seconds : end;
	if (problem) {
		warn(vm, std::move(*problem));
	}
	return !problem || is_cut;
}

} // namespace

void GenerationContext::begin_household(HouseholdId id, DayMask days) {
	set_household(id);
	if (_members.size() < member_count()) {
		_members.resize(member_count());
	}
	for (size_t i = 0; i < member_count(); ++i) {
		_members[i].agenda.clear();
		_members[i].floating.clear();
	}
	_groups.clear();
	_named_tasks.clear();
	_inner_days.clear();
	_has_requirements = false;
	begin_days(days);
}

void GenerationContext::begin_days(DayMask days) {
	set_focus(PersonId::Invalid);
	_run_days = days;
	set_named_days(all_days);
	_entry_name = 0;
	_requirement = 0;
	_wants_single_days = false;
}

Flow GenerationContext::insert(Vm &vm, std::string_view operation, TaskKind kind, double start, double end, uint32_t target) {
	if (!require_focus(vm, operation)) {
		return Flow::Stop;
	}
	const bool is_usual = start < end && end - start <= day_seconds && start >= -week_seconds && end <= week_seconds;
	if (!is_usual && !are_times_good(vm, operation, start, end)) {
		return Flow::Next;
	}
	Task task;
	task.start_ms = to_ms(start);
	task.end_ms = to_ms(end);
	task.kind = kind;
	task.target = target;
	task.days = _days;
	task.origin = vm.address();
	return insert_task(vm, focus(), task) ? Flow::Next : Flow::Stop;
}

void GenerationContext::insert_named_task(PersonId member, Task task) {
	task.name = _entry_name;
	task.requirement = _requirement;
	_has_requirements = _has_requirements || _requirement != 0;
	if (agenda_of(member).insert(task) && _entry_name != 0) {
		_named_tasks.push_back({ member, normalized(task) });
	}
}

bool GenerationContext::insert_task(Vm &vm, PersonId member, const Task &task) {
	Agenda &agenda = agenda_of(member);
	if ((_entry_name | _requirement) == 0) [[likely]] {
		agenda.insert(task);
	} else {
		insert_named_task(member, task);
	}
	if (agenda.tasks().size() <= max_entries) [[likely]] {
		return true;
	}
	vm.fail("agenda-too-long", "the agenda of " + name_of(member) + " has more than " + std::to_string(max_entries) + " entries",
			"does a rule call itself without end?");
	return false;
}

void GenerationContext::add_floating_task(Vm &vm, FloatingTask task) {
	std::vector<FloatingTask> &tasks = _members[index_in_household(focus())].floating;
	if (tasks.size() >= max_floating_tasks) {
		vm.fail("pool-too-large", name_of(focus()) + " has more than " + std::to_string(max_floating_tasks) + " floating tasks",
				"does a rule call itself without end?");
		return;
	}
	tasks.push_back(task);
}

uint32_t GenerationContext::add_group(Group group) {
	_groups.push_back(std::move(group));
	return uint32_t(_groups.size() - 1);
}

uint16_t GenerationContext::number_of(Vm &vm, std::string_view name) {
	const uint16_t number = number_in(_names, std::string(name), max_names);
	if (number == 0) {
		fail_names(vm, name);
	}
	return number;
}

uint8_t GenerationContext::number_of(Vm &vm, const Requirement &requirement) {
	const uint8_t number = uint8_t(number_in(_requirements, requirement, max_task_requirements));
	if (number == 0) {
		fail_names(vm, _names[requirement.name]);
	}
	return number;
}

void GenerationContext::note_inner_days(uint32_t address, DayMask outer, DayMask left) {
	const auto found = std::ranges::find(_inner_days, address, &InnerDays::address);
	if (found != _inner_days.end()) {
		found->left |= left;
	} else {
		_inner_days.push_back({ address, outer, left });
	}
}

void GenerationContext::finish_household() {
	drop_unmet_tasks();
	report_empty_days();
}

void GenerationContext::report_empty_days() {
	for (const InnerDays &call : _inner_days) {
		if (call.left == 0) {
			CallProblem problem = no_days(call.outer);
			report(diagnostic_at(*world().program, call.address, Severity::Warning, problem.id, std::move(problem.message), std::move(problem.hint)));
		}
	}
}

void GenerationContext::drop_unmet_tasks() {
	const bool is_called_away = has_lost_walkers();
	if (!_has_requirements && !is_called_away) {
		return;
	}
	_agendas.clear();
	for (size_t i = 0; i < member_count(); ++i) {
		_agendas.push_back(&_members[i].agenda);
	}
	for (const DroppedTask &dropped : drop_unmet({ household().first_member, _agendas, _groups }, _named_tasks, _requirements)) {
		report_dropped(dropped);
	}
	if (!is_called_away) {
		return;
	}
	for (uint32_t number = 0; number < _groups.size(); ++number) {
		std::erase_if(_groups[number].joiners, [&](PersonId joiner) { return !has_walk(joiner, number, 0); });
	}
}

// In one piece on at least these days.
bool GenerationContext::has_walk(PersonId member, uint32_t group, DayMask days) {
	return std::ranges::any_of(agenda_of(member).tasks(), [&](const Task &task) {
		return is_walk(task, group) && (task.days & days) == days;
	});
}

// Whether a newer entry may have called anybody away from its group.
bool GenerationContext::has_lost_walkers() {
	for (uint32_t number = 0; number < _groups.size(); ++number) {
		const Group &group = _groups[number];
		const auto walks = [&](PersonId member) { return has_walk(member, number, group.days); };
		if (!walks(group.leader) || !std::ranges::all_of(group.joiners, walks)) {
			return true;
		}
	}
	return false;
}

void GenerationContext::report_dropped(const DroppedTask &dropped) {
	const std::string entry = "'" + std::string(task_kind_name(dropped.task.kind)) + "' at " + clock_text(dropped.task.start(), false) + " (" +
			days_text(dropped.task.days) + ")";
	const DropWords words = words_of(dropped);
	report(diagnostic_at(*world().program, dropped.task.origin, Severity::Warning, words.id,
			name_of(dropped.person) + (dropped.reason == Unmet::Leaderless ? " goes alone: " : " drops ") + entry + words.reason, words.hint));
}

GenerationContext::DropWords GenerationContext::words_of(const DroppedTask &dropped) const {
	const std::string name = "'" + _names[dropped.name] + "'", quoted = "\"" + _names[dropped.name] + "\"";
	switch (dropped.reason) {
		case Unmet::Deserted:
			return { deserted_id, ": another leader called everybody away who was to come along",
				"what is written later wins: write the walk that is meant last, or for others" };
		case Unmet::Leaderless:
			return { leaderless_id, " has lost its leader, " + name_of(_groups[dropped.task.target].leader) + ", to newer entries",
				"what is written later wins: write the walk last, or let somebody lead it who is free then" };
		case Unmet::Lost:
			return { requirement_unmet_id, ": newer entries took " + name + " away",
				"what is written later wins: write " + name + " last, or at another time" };
		case Unmet::NotOver:
			return { requirement_unmet_id, ": " + name + " is not over by then", "let " + name + " end before, or this begin later" };
		case Unmet::Missing:
		case Unmet::No:
			break;
	}
	return { requirement_unmet_id, ": nobody there has " + name, "write task(" + quoted + ") { .. } for somebody of the household on the same day" };
}

Value GenerationContext::day(Vm &vm) {
	if (std::popcount(_days) == 1) {
		return Value::of(double(std::countr_zero(_days)));
	}
	_wants_single_days = true;
	return vm.fail("day-of-many", "the rules write several days at once here");
}

Value GenerationContext::time(Vm &vm) {
	return vm.fail("no-time", "'time' is known in delayed rules only, while the simulation runs", "agendas are written before any day begins");
}

bool GenerationContext::present_position(glm::vec3 &position) const {
	const BuildingId home = household().home;
	if (!is_valid(home)) {
		return false;
	}
	const EntranceId entrance = city().entrance_of(home);
	if (!is_valid(entrance)) {
		return false;
	}
	position = city().entrance(entrance).position;
	return true;
}

void GenerationContext::report(Diagnostic diagnostic) {
	if (_wants_single_days) {
		return; // the run that asked for the day ends, and starts again for each day
	}
	if (diagnostic.id != missing_type_id) {
		diagnostic.message = name_of(household_id()) + ": " + diagnostic.message;
	} else if (std::any_of(_diagnostics.begin(), _diagnostics.end(), [&](const Diagnostic &told) { return is_repeat(told, diagnostic); })) {
		return;
	}
	_diagnostics.push_back(std::move(diagnostic));
}

} // namespace pcg::agenda
