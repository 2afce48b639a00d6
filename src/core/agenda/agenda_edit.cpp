#include "core/agenda/agenda_edit.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <span>

#include "core/agenda/renumbering.h"

namespace pcg {

namespace {

constexpr int64_t days_around = 3; // with the day itself a week: each day of it stands for the single day that it is

DayMask mask_of(int64_t day) { return DayMask(1u << SimTime::at(day, {}).weekday()); }

// But for what insertions elsewhere leave behind.
bool is_same(const Task &a, const Task &b) {
	return a.start_ms == b.start_ms && a.end_ms == b.end_ms && a.target == b.target && a.kind == b.kind && a.days == b.days && a.name == b.name &&
			a.requirement == b.requirement && a.is_start_cut == b.is_start_cut;
}

bool are_same(std::span<const Task> a, std::span<const Task> b) { return std::equal(a.begin(), a.end(), b.begin(), b.end(), is_same); }

// Those of a week that begin on one day, with that day alone.
std::vector<Task> tasks_on(std::span<const Task> week, int64_t day) {
	std::vector<Task> result;
	for (Task task : week) {
		if (task.days & mask_of(day)) {
			task.days = mask_of(day);
			result.push_back(task);
		}
	}
	return result;
}

std::vector<Task> week_around(const AgendaView &agenda, int64_t day) {
	std::vector<Task> result;
	for (int64_t date = day - days_around; date <= day + days_around; ++date) {
		const std::vector<Task> tasks = tasks_on(agenda.on(date), date);
		result.insert(result.end(), tasks.begin(), tasks.end());
	}
	return result;
}

// One week of a household.
class HouseholdWeek {
public:
	HouseholdWeek(const Household &household, std::vector<std::vector<Task>> weeks) : _first(household.first_member) {
		_agendas.reserve(weeks.size());
		for (const std::vector<Task> &week : weeks) {
			_agendas.emplace_back(week);
			_pointers.push_back(&_agendas.back());
		}
	}

	// Nothing if it cannot be inserted.
	std::optional<std::vector<DroppedTask>> insert(const AgendaSet &set, PersonId person, const Task &task) {
		std::vector<NamedTask> named = named_tasks();
		if (!_agendas[index_of(person) - index_of(_first)].insert(task)) {
			return std::nullopt;
		}
		if (task.name != 0) {
			named.push_back({ person, normalized(task) });
		}
		return drop_unmet({ _first, _pointers, set.groups }, named, set.requirements);
	}

	std::span<const Task> tasks_of(size_t member) const { return _agendas[member].tasks(); }

private:
	// In the state before the change: what is not lived already is no news.
	std::vector<NamedTask> named_tasks() const {
		std::vector<NamedTask> named;
		for (size_t i = 0; i < _agendas.size(); ++i) {
			for (const Task &task : _agendas[i].tasks()) {
				if (task.name != 0) {
					named.push_back({ PersonId(index_of(_first) + uint32_t(i)), task });
				}
			}
		}
		return named;
	}

	PersonId _first;
	std::vector<Agenda> _agendas;
	std::vector<Agenda *> _pointers;
};

class Insertion {
public:
	Insertion(AgendaSet &set, const Household &household, PersonId person) : _set(set), _household(household), _person(person) {}

	AgendaChange on(Task task, int64_t day) {
		task.days = mask_of(day);
		const Task there = normalized(task);
		day += (int64_t(task.start_ms) - there.start_ms) / one_day.ms;
		insert_on(there, day, {});
		return finish();
	}

	AgendaChange every_week(Task task) {
		const Task there = normalized(task);
		const std::vector<int64_t> singles = single_days();
		std::vector<int64_t> days; // of the entry that can meet what is for single days
		for (int64_t day : singles) {
			days.insert(days.end(), { day - 1, day, day + 1 });
		}
		std::sort(days.begin(), days.end());
		days.erase(std::unique(days.begin(), days.end()), days.end());
		for (int64_t day : days) {
			if (there.days & mask_of(day)) {
				insert_on(there, day, singles);
			}
		}
		insert_in_week(task);
		return finish();
	}

private:
	PersonId member(size_t i) const { return PersonId(index_of(_household.first_member) + uint32_t(i)); }

	// Ascending, of anybody in the household; the day after each is one too, for what is cut at midnight goes there.
	std::vector<int64_t> single_days() const {
		std::vector<int64_t> result;
		for (size_t i = 0; i < _household.member_count; ++i) {
			for (const SingleDay &single : _set.agenda_of(member(i)).single_days) {
				result.insert(result.end(), { single.day, single.day + 1 });
			}
		}
		std::sort(result.begin(), result.end());
		result.erase(std::unique(result.begin(), result.end()), result.end());
		return result;
	}

	ChangedAgenda &changed(size_t i) {
		const uint32_t person = index_of(member(i));
		const auto found = _set.changed.find(person);
		if (found != _set.changed.end()) {
			return found->second;
		}
		const std::span<const Task> week = _set.tasks_of(member(i));
		return _set.changed[person] = { { week.begin(), week.end() }, {} };
	}

	// Only on the days in `only`, where all entries become those of a single day because the week is about to change; on all days if that is empty.
	void insert_on(Task task, int64_t day, std::span<const int64_t> only) {
		std::vector<std::vector<Task>> weeks;
		for (size_t i = 0; i < _household.member_count; ++i) {
			weeks.push_back(week_around(_set.agenda_of(member(i)), day));
		}
		HouseholdWeek week(_household, std::move(weeks));
		task.days = mask_of(day);
		const std::optional<std::vector<DroppedTask>> dropped = week.insert(_set, _person, task);
		if (!dropped) {
			return;
		}
		_change.is_inserted = true;
		for (int64_t date = day - days_around; date <= day + days_around; ++date) {
			if (!only.empty() && !std::binary_search(only.begin(), only.end(), date)) {
				continue;
			}
			for (size_t i = 0; i < _household.member_count; ++i) {
				set_single_day(i, date, tasks_on(week.tasks_of(i), date), !only.empty());
			}
			tell_dropped(*dropped, date);
		}
	}

	void set_single_day(size_t i, int64_t day, std::vector<Task> tasks, bool even_if_same) {
		const bool is_other = !are_same(tasks, tasks_on(_set.agenda_of(member(i)).on(day), day));
		if (!is_other && !even_if_same) {
			return;
		}
		if (is_other) {
			note_change(i);
		}
		std::vector<SingleDay> &days = changed(i).single_days;
		const auto place = std::lower_bound(days.begin(), days.end(), day, [](const SingleDay &a, int64_t b) { return a.day < b; });
		if (place != days.end() && place->day == day) {
			place->tasks = std::move(tasks);
		} else {
			days.insert(place, { day, std::move(tasks) });
		}
	}

	void tell_dropped(const std::vector<DroppedTask> &dropped, int64_t day) {
		for (DroppedTask one : dropped) {
			if (one.task.days & mask_of(day)) {
				one.task.days = mask_of(day);
				one.day = day;
				_change.dropped.push_back(one);
			}
		}
	}

	void insert_in_week(const Task &task) {
		std::vector<std::vector<Task>> weeks;
		for (size_t i = 0; i < _household.member_count; ++i) {
			const std::span<const Task> tasks = _set.tasks_of(member(i));
			weeks.emplace_back(tasks.begin(), tasks.end());
		}
		HouseholdWeek week(_household, std::move(weeks));
		const std::optional<std::vector<DroppedTask>> dropped = week.insert(_set, _person, task);
		if (!dropped) {
			return;
		}
		_change.is_inserted = true;
		_change.dropped.insert(_change.dropped.end(), dropped->begin(), dropped->end());
		for (size_t i = 0; i < _household.member_count; ++i) {
			const std::span<const Task> now = week.tasks_of(i);
			if (!are_same(now, _set.tasks_of(member(i)))) {
				changed(i).week.assign(now.begin(), now.end());
				note_change(i);
			}
		}
	}

	void note_change(size_t i) {
		if (std::find(_change.changed.begin(), _change.changed.end(), member(i)) == _change.changed.end()) {
			_change.changed.push_back(member(i));
		}
	}

	// Whether the loss of every week says it, too.
	bool is_told_of_week(const DroppedTask &single) const {
		return single.day && std::ranges::any_of(_change.dropped, [&](const DroppedTask &other) {
			Task task = other.task;
			task.days = single.task.days;
			return !other.day && (other.task.days & single.task.days) != 0 && other.person == single.person && other.reason == single.reason &&
					other.name == single.name && is_same(task, single.task);
		});
	}

	// A single day that is as in the week is none.
	AgendaChange finish() {
		std::vector<DroppedTask> told;
		std::ranges::copy_if(_change.dropped, std::back_inserter(told), [this](const DroppedTask &one) { return !is_told_of_week(one); });
		_change.dropped = std::move(told);
		for (size_t i = 0; i < _household.member_count; ++i) {
			const auto found = _set.changed.find(index_of(member(i)));
			if (found == _set.changed.end()) {
				continue;
			}
			const std::vector<Task> &week = found->second.week;
			std::erase_if(found->second.single_days,
					[&](const SingleDay &single) { return are_same(single.tasks, tasks_on(week, single.day)); });
		}
		std::sort(_change.changed.begin(), _change.changed.end());
		return std::move(_change);
	}

	AgendaSet &_set;
	const Household &_household;
	PersonId _person;
	AgendaChange _change;
};

uint32_t origin_without_rule(AgendaSet &set) {
	const auto has_none = [](const TaskOrigin &origin) { return origin.rule.empty() && origin.file.empty(); };
	const auto found = std::find_if(set.origins.begin(), set.origins.end(), has_none);
	if (found != set.origins.end()) {
		return uint32_t(found - set.origins.begin());
	}
	set.origins.emplace_back();
	return uint32_t(set.origins.size() - 1);
}

} // namespace

uint16_t task_name(AgendaSet &agendas, std::string_view name) { return number_in(agendas.names, std::string(name), max_task_names); }

uint8_t task_requirement(AgendaSet &agendas, const Requirement &requirement) {
	return uint8_t(number_in(agendas.requirements, requirement, max_task_requirements));
}

AgendaChange insert_task(AgendaSet &agendas, const Population &population, PersonId person, Task task, std::optional<int64_t> day) {
	if (index_of(person) >= population.persons.size() || index_of(person) >= agendas.person_count()) {
		return {};
	}
	task.origin = origin_without_rule(agendas);
	Insertion insertion(agendas, population.household(population.person(person).household), person);
	return day ? insertion.on(task, *day) : insertion.every_week(task);
}

void append_agendas(AgendaSet &agendas, const AgendaSet &more) {
	const auto first_task = uint32_t(agendas.tasks.size()), first_floating = uint32_t(agendas.floating_tasks.size());
	std::vector<uint32_t> origins(more.origins.size());
	std::iota(origins.begin(), origins.end(), uint32_t(agendas.origins.size()));
	const Renumbering renumbering(agendas, more.names, more.requirements, origins, agendas.groups.size());
	for (const Task &task : more.tasks) {
		agendas.tasks.push_back(renumbering.apply(task));
	}
	agendas.floating_tasks.insert(agendas.floating_tasks.end(), more.floating_tasks.begin(), more.floating_tasks.end());
	agendas.groups.insert(agendas.groups.end(), more.groups.begin(), more.groups.end());
	agendas.origins.insert(agendas.origins.end(), more.origins.begin(), more.origins.end());
	for (size_t i = 1; i < more.first_task.size(); ++i) {
		agendas.first_task.push_back(first_task + more.first_task[i]);
		agendas.first_floating_task.push_back(first_floating + more.first_floating_task[i]);
	}
}

void forget_days_before(AgendaSet &agendas, int64_t day) {
	for (auto &[person, changed] : agendas.changed) {
		std::erase_if(changed.single_days, [day](const SingleDay &single) { return single.day < day; });
	}
}

} // namespace pcg
