#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/agenda/generation_context.h"
#include "core/agenda/operations/constant_checks.h"
#include "core/agenda/operations/operations.h"
#include "core/base/small_vector.h"

namespace pcg::agenda {

namespace {

// The entry that a person executes at one moment, as far as a group copies it.
struct Trip {
	BuildingId goal = BuildingId::Invalid; // Invalid: no entry, or one that leads to no building
	int32_t start_ms = 0; // since 0h of `day`
	int32_t end_ms = 0;
	int day = 0; // of the week, on which the entry starts
};

class Accompaniment {
public:
	Accompaniment(Vm &vm, GenerationContext &context, double time) : _vm(vm), _context(context), _leader(context.focus()) {
		const int64_t ms = Duration::seconds(time).ms;
		const SimTime moment{ ms };
		_shift = moment.day();
		_time_of_day = moment.time_of_day();
	}

	// False after a failure.
	bool find_joiners(Chunk predicate) {
		FocusScope scope(_context);
		for (size_t i = 0; i < _context.member_count(); ++i) {
			const PersonId member = _context.member(i);
			if (member == _leader) {
				continue;
			}
			scope.focus(member);
			const Value value = _vm.evaluate(predicate);
			if (!_vm.has_failed() && !value.is_bool()) {
				_vm.fail("wrong-type", "the predicate of 'accompany' has to be true or false, not " + std::string(type_name(value.type)),
						"write a comparison, as in age < 18");
			}
			if (_vm.has_failed()) {
				return false;
			}
			if (value.boolean) {
				_joiners.push_back(member);
			}
		}
		return true;
	}

	// Days may differ: equal groups of several days are one group.
	Flow insert_groups() {
		if (_joiners.empty()) {
			_vm.warn("nobody-to-accompany", "nobody else in the household matches, so nothing is inserted",
					"count(predicate) tells beforehand how many match");
			return Flow::Next;
		}
		add_days();
		if (_groups.empty()) {
			_vm.warn("nothing-to-accompany", "the first person to be accompanied goes to no building at that time, so nothing is inserted",
					"write that person's goToBuilding(..) first");
		}
		for (Group &group : _groups) {
			if (!insert_group(std::move(group))) {
				return Flow::Stop;
			}
		}
		return Flow::Next;
	}

private:
	void add_days() {
		const bool are_equal = _context.days() == all_days && std::all_of(_joiners.begin(), _joiners.end(), [&](PersonId joiner) {
			return _context.agenda_of(joiner).is_same_every_day();
		});
		if (are_equal) { // one day tells all
			add_day(0);
			for (Group &group : _groups) {
				group.days = all_days;
			}
			return;
		}
		for (int day = 0; day < 7; ++day) {
			if ((_context.days() >> day) & 1) {
				add_day(int(((day + _shift) % 7 + 7) % 7));
			}
		}
	}

	Trip trip_of(PersonId member, int day) {
		const Task *task = _context.agenda_of(member).at(day, _time_of_day);
		if (task == nullptr) {
			return {};
		}
		const bool is_since_yesterday = task->start_ms > _time_of_day.ms;
		Trip trip{ BuildingId::Invalid, task->start_ms, task->end_ms, is_since_yesterday ? (day + 6) % 7 : day };
		if (is_stay(task->kind)) {
			trip.goal = BuildingId(task->target);
		} else if (task->kind == TaskKind::Accompany) {
			trip.goal = _context.groups()[task->target].goal;
		}
		return trip;
	}

	void add_day(int day) {
		const Trip first = trip_of(_joiners[0], day);
		if (!is_valid(first.goal)) {
			return;
		}
		Group group{ _leader, {}, first.goal, first.start_ms, first.end_ms, DayMask(1u << first.day) };
		group.joiners.reserve(_joiners.size());
		for (PersonId joiner : _joiners) {
			if (trip_of(joiner, day).goal == first.goal) {
				group.joiners.push_back(joiner);
			}
		}
		for (Group &known : _groups) {
			if (known.goal == group.goal && known.start_ms == group.start_ms && known.end_ms == group.end_ms && known.joiners == group.joiners) {
				known.days |= group.days;
				return;
			}
		}
		_groups.push_back(std::move(group));
	}

	bool insert_group(Group group) {
		Task task;
		task.kind = TaskKind::Accompany;
		task.start_ms = group.start_ms;
		task.end_ms = group.end_ms;
		task.days = group.days;
		task.origin = _vm.address();
		task.target = _context.add_group(std::move(group));
		for (PersonId walker : _context.groups()[task.target].joiners) {
			if (!_context.insert_task(_vm, walker, task)) {
				return false;
			}
		}
		return _context.insert_task(_vm, _leader, task);
	}

	Vm &_vm;
	GenerationContext &_context;
	PersonId _leader;
	int64_t _shift = 0; // days from the day that is written to the one `time` falls on
	Duration _time_of_day;
	SmallVector<PersonId, 8> _joiners; // ascending
	std::vector<Group> _groups;
};

Flow accompany(Vm &vm, const Args &args) {
	GenerationContext *context = writing_context(vm);
	if (context == nullptr) {
		return Flow::Next;
	}
	if (!require_focus(vm, "accompany")) {
		return Flow::Stop;
	}
	if (std::optional<CallProblem> problem = moment_problem("accompany", args.number(0))) {
		warn(vm, std::move(*problem));
		return Flow::Next;
	}
	Accompaniment accompaniment(vm, *context, args.number(0));
	if (!accompaniment.find_joiners(Chunk(args[1].index))) {
		return Flow::Stop;
	}
	return accompaniment.insert_groups();
}

} // namespace

void add_accompany(Dialect &dialect) {
	dialect.operations.push_back({ "accompany", { { "time", ParamKind::Number }, { "predicate", ParamKind::Predicate } }, BlockKind::None, accompany,
			"The focused person leads the other members for whom the predicate is true: all get one group task with the goal, start and end "
			"of the entry that the first of them (lowest id) has at `time`; who goes elsewhere then does not join.",
			Phase::Generation, nullptr, check_moment });
}

} // namespace pcg::agenda
