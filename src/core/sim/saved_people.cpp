#include "core/sim/saved_people.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/base/bytes.h"
#include "core/population/names.h"

namespace pcg {

namespace {

constexpr int64_t most_days = 1'000'000'000; // away from the first

template <typename Archive, typename Record> void visit_person(Archive &archive, Record &person) {
	archive.values(person.household, person.name, person.walking_speed, person.age);
	archive.choice(person.gender, 2);
	archive.values(person.clothes_color);
}

template <typename Archive, typename Record> void visit_household(Archive &archive, Record &household) {
	archive.values(household.home, household.first_member, household.member_count, household.pattern, household.family_name, household.hair_color);
}

template <typename Archive, typename Record> void visit_task(Archive &archive, Record &task) {
	uint16_t name = task.name, days_later = task.days_later; // bit fields have no address
	archive.values(task.start_ms, task.end_ms, task.target, task.origin, task.generation);
	archive.choice(task.kind, task_kind_count);
	archive.values(task.days, name, days_later, task.requirement, task.is_start_cut);
	if constexpr (Archive::is_reading) {
		task.name = name & (max_task_names - 1);
		task.days_later = days_later % 7;
	}
}

template <typename Archive, typename Tasks> void visit_tasks(Archive &archive, Tasks &tasks) {
	archive.list(tasks, [](auto &inner, auto &task) { visit_task(inner, task); });
}

template <typename Archive, typename Offsets> void visit_offsets(Archive &archive, Offsets &offsets) {
	archive.list(offsets, [](auto &inner, auto &offset) { inner.values(offset); });
}

template <typename Archive, typename Agendas> void visit_agendas(Archive &archive, Agendas &agendas) {
	visit_tasks(archive, agendas.tasks);
	visit_offsets(archive, agendas.first_task);
	archive.list(agendas.floating_tasks,
			[](auto &inner, auto &task) { inner.values(task.rule, task.duration_ms, task.priority, task.days); });
	visit_offsets(archive, agendas.first_floating_task);
	archive.list(agendas.groups, [](auto &inner, auto &group) {
		inner.values(group.leader, group.goal, group.start_ms, group.end_ms, group.days);
		visit_offsets(inner, group.joiners);
	});
	archive.list(agendas.origins, [](auto &inner, auto &origin) {
		inner.text(origin.rule);
		inner.text(origin.file);
		inner.values(origin.line);
	});
	archive.list(agendas.names, [](auto &inner, auto &name) { inner.text(name); });
	archive.list(agendas.requirements,
			[](auto &inner, auto &requirement) { inner.values(requirement.name, requirement.is_after, requirement.outer); });
}

using PersonsAgenda = std::pair<uint32_t, ChangedAgenda>;

template <typename Archive, typename List> void visit_changed(Archive &archive, List &changed) {
	archive.list(changed, [](auto &inner, auto &agenda) {
		inner.values(agenda.first);
		visit_tasks(inner, agenda.second.week);
		inner.list(agenda.second.single_days, [](auto &innermost, auto &single) {
			innermost.whole(single.day, most_days);
			visit_tasks(innermost, single.tasks);
		});
	});
}

template <typename Archive, typename Record> void visit_population(Archive &archive, Record &population) {
	archive.list(population.persons, [](auto &inner, auto &person) { visit_person(inner, person); });
	archive.list(population.households, [](auto &inner, auto &household) { visit_household(inner, household); });
	archive.list(population.names, [](auto &inner, auto &name) { inner.text(name); });
	archive.text(population.home_type);
}

bool is_sound(const Population &population) {
	uint64_t next = 0;
	for (size_t i = 0; i < population.households.size(); ++i) {
		const Household &household = population.households[i];
		if (index_of(household.first_member) != next || next + household.member_count > population.persons.size() ||
				household.family_name >= family_names().size() + population.names.size() || household.hair_color >= hair_colors().size()) {
			return false;
		}
		for (uint32_t member = 0; member < household.member_count; ++member, ++next) {
			const Person &person = population.persons[next];
			if (index_of(person.household) != i || !(person.walking_speed > 0.0f) || !std::isfinite(person.walking_speed) ||
					!std::isfinite(person.age) || person.name >= first_names(person.gender).size() + population.names.size() ||
					person.clothes_color >= clothes_colors().size()) {
				return false;
			}
		}
	}
	return next == population.persons.size();
}

bool are_offsets_sound(const std::vector<uint32_t> &offsets, size_t persons, size_t count) {
	return offsets.size() == persons + 1 && offsets.front() == 0 && offsets.back() == count && std::is_sorted(offsets.begin(), offsets.end());
}

bool are_tasks_sound(std::span<const Task> tasks, const AgendaSet &agendas) {
	return std::all_of(tasks.begin(), tasks.end(), [&](const Task &task) {
		const int64_t length = int64_t(task.end_ms) - task.start_ms;
		return task.start_ms >= 0 && task.start_ms < one_day.ms && length > 0 && length <= one_day.ms && task.days <= all_days &&
				(task.name == 0 || task.name < agendas.names.size()) &&
				(task.requirement == 0 || task.requirement < agendas.requirements.size()) &&
				(task.kind != TaskKind::Accompany || task.target < agendas.groups.size());
	});
}

bool is_changed_sound(const ChangedAgenda &changed, const AgendaSet &agendas) {
	const auto is_not_before = [](const SingleDay &a, const SingleDay &b) { return a.day >= b.day; };
	return are_tasks_sound(changed.week, agendas) &&
			std::adjacent_find(changed.single_days.begin(), changed.single_days.end(), is_not_before) == changed.single_days.end() &&
			std::all_of(changed.single_days.begin(), changed.single_days.end(),
					[&](const SingleDay &single) { return are_tasks_sound(single.tasks, agendas); });
}

bool are_requirements_sound(const AgendaSet &agendas) {
	for (size_t i = 0; i < agendas.requirements.size(); ++i) {
		size_t steps = 0;
		for (size_t number = i; number != 0; number = agendas.requirements[number].outer) {
			if (number >= agendas.requirements.size() || agendas.requirements[number].name >= agendas.names.size() ||
					++steps > agendas.requirements.size()) {
				return false; // names nothing, or goes round in a circle
			}
		}
	}
	return agendas.requirements.size() <= max_task_requirements && agendas.names.size() <= max_task_names;
}

bool is_sound(const AgendaSet &agendas, size_t persons) {
	const auto exists = [persons](PersonId id) { return index_of(id) < persons; };
	const bool are_groups_sound = std::all_of(agendas.groups.begin(), agendas.groups.end(), [&](const Group &group) {
		return exists(group.leader) && std::all_of(group.joiners.begin(), group.joiners.end(), exists);
	});
	const bool are_floating_sound = std::all_of(agendas.floating_tasks.begin(), agendas.floating_tasks.end(),
			[](const FloatingTask &task) { return task.days <= all_days && !std::isnan(task.priority); });
	const bool are_changed_sound = std::all_of(agendas.changed.begin(), agendas.changed.end(),
			[&](const auto &agenda) { return agenda.first < persons && is_changed_sound(agenda.second, agendas); });
	return are_groups_sound && are_floating_sound && are_changed_sound && are_requirements_sound(agendas) &&
			are_tasks_sound(agendas.tasks, agendas) && are_offsets_sound(agendas.first_task, persons, agendas.tasks.size()) &&
			are_offsets_sound(agendas.first_floating_task, persons, agendas.floating_tasks.size());
}

} // namespace

std::string people_to_bytes(const Population &population, const AgendaSet &agendas) {
	ByteWriter writer;
	visit_population(writer, population);
	visit_agendas(writer, agendas);
	std::vector<PersonsAgenda> changed(agendas.changed.begin(), agendas.changed.end());
	std::sort(changed.begin(), changed.end(), [](const PersonsAgenda &a, const PersonsAgenda &b) { return a.first < b.first; });
	visit_changed(writer, changed);
	return writer.take();
}

bool people_from_bytes(std::string_view bytes, SavedPeople &people) {
	ByteReader reader(bytes);
	visit_population(reader, people.population);
	visit_agendas(reader, people.agendas);
	std::vector<PersonsAgenda> changed;
	visit_changed(reader, changed);
	people.agendas.changed = { std::make_move_iterator(changed.begin()), std::make_move_iterator(changed.end()) };
	return reader.is_good() && reader.is_at_end() && is_sound(people.population) && is_sound(people.agendas, people.population.persons.size());
}

} // namespace pcg
