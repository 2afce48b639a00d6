#include "core/agenda/agenda_edit.h"

#include <algorithm>

namespace pcg {

namespace {

bool is_same(const Task &a, const Task &b) {
	return a.start_ms == b.start_ms && a.end_ms == b.end_ms && a.target == b.target && a.kind == b.kind && a.days == b.days &&
			a.generation == b.generation && a.name == b.name && a.requirement == b.requirement && a.is_start_cut == b.is_start_cut;
}

// The household's agendas, taken out of the set and put back.
class HouseholdEdit {
public:
	HouseholdEdit(AgendaSet &set, const Household &household) : _set(set), _household(household) {
		_agendas.reserve(household.member_count);
		for (uint32_t i = 0; i < household.member_count; ++i) {
			_agendas.emplace_back(set.tasks_of(member(i)));
			_pointers.push_back(&_agendas.back());
		}
	}

	// In the state before the change: what is not lived already is no news.
	std::vector<NamedTask> named_tasks() const {
		std::vector<NamedTask> named;
		for (uint32_t i = 0; i < _household.member_count; ++i) {
			for (const Task &task : _agendas[i].tasks()) {
				if (task.name != 0) {
					named.push_back({ member(i), task });
				}
			}
		}
		return named;
	}

	Agenda &agenda_of(PersonId person) { return _agendas[index_of(person) - index_of(_household.first_member)]; }

	HouseholdAgendas view() const { return { _household.first_member, _pointers, _set.groups }; }

	std::vector<PersonId> put_back() {
		std::vector<PersonId> changed;
		for (uint32_t i = 0; i < _household.member_count; ++i) {
			const std::span<const Task> before = _set.tasks_of(member(i));
			const std::vector<Task> &now = _agendas[i].tasks();
			if (!std::equal(before.begin(), before.end(), now.begin(), now.end(), is_same)) {
				_set.changed[index_of(member(i))] = now;
				changed.push_back(member(i));
			}
		}
		return changed;
	}

private:
	PersonId member(uint32_t i) const { return PersonId(index_of(_household.first_member) + i); }

	AgendaSet &_set;
	const Household &_household;
	std::vector<Agenda> _agendas;
	std::vector<Agenda *> _pointers;
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

AgendaChange insert_task(AgendaSet &agendas, const Population &population, PersonId person, Task task) {
	AgendaChange change;
	if (index_of(person) >= population.persons.size() || index_of(person) >= agendas.person_count()) {
		return change;
	}
	HouseholdEdit edit(agendas, population.household(population.person(person).household));
	std::vector<NamedTask> named = edit.named_tasks();
	task.origin = origin_without_rule(agendas);
	if (!edit.agenda_of(person).insert(task)) {
		return change;
	}
	if (task.name != 0) {
		named.push_back({ person, normalized(task) });
	}
	change.is_inserted = true;
	if (!agendas.requirements.empty()) {
		change.dropped = drop_unmet(edit.view(), named, agendas.requirements);
	}
	change.changed = edit.put_back();
	return change;
}

} // namespace pcg
