#include "core/agenda/requirement.h"

#include <algorithm>

namespace pcg {

namespace {

constexpr bool is_on(DayMask days, int day) { return (days >> day) & 1; }

// The days that it was written for.
DayMask written_days(const Task &task) { return rotate_days(task.days, -int64_t(task.days_later)); }

// Since 0h of the day that it was written for; an entry may be written up to three days away from it.
int64_t since_written_day(const Task &task, int32_t time_ms) {
	const int64_t days = task.days_later > 3 ? int64_t(task.days_later) - 7 : int64_t(task.days_later);
	return days * one_day.ms + time_ms;
}

class Dropping {
public:
	Dropping(const HouseholdAgendas &household, std::span<const NamedTask> named, std::span<const Requirement> requirements) :
			_household(household), _named(named), _requirements(requirements) {}

	// What is dropped may be required itself: until nothing changes any more.
	std::vector<DroppedTask> run() {
		while (drop_deserted() || (!_requirements.empty() && drop_one())) {
		}
		while (release_one()) { // last: what nobody leads is no walk together for those who require it
		}
		return std::move(_dropped);
	}

private:
	PersonId person_of(size_t member) const { return PersonId(index_of(_household.first_member) + uint32_t(member)); }

	bool drop_deserted() {
		for (size_t member = 0; member < _household.members.size(); ++member) {
			const std::vector<Task> &tasks = _household.members[member]->tasks();
			for (size_t i = 0; i < tasks.size(); ++i) {
				const Group *group = group_of(tasks[i]);
				const bool leads = group != nullptr && group->leader == person_of(member);
				const DayMask lonely = leads ? set_out_days(*group, tasks[i]) & deserted_days(*group, tasks[i].target) : DayMask(0);
				if (lonely != 0) {
					DroppedTask dropped{ group->leader, tasks[i], Unmet::Deserted, 0, std::nullopt };
					dropped.task.days = rotate_days(lonely, tasks[i].start_ms < group->start_ms ? 1 : 0);
					_household.members[member]->remove(i, dropped.task.days);
					_dropped.push_back(dropped);
					return true;
				}
			}
		}
		return false;
	}

	bool release_one() {
		for (size_t member = 0; member < _household.members.size(); ++member) {
			const std::vector<Task> &tasks = _household.members[member]->tasks();
			for (size_t i = 0; i < tasks.size(); ++i) {
				const Group *group = group_of(tasks[i]);
				if (group != nullptr && group->leader != person_of(member) && release(member, i, *group)) {
					return true;
				}
			}
		}
		return false;
	}

	// Where nobody leads the joiner it goes alone, and is not who walked together for those who require that.
	bool release(size_t member, size_t index, const Group &group) {
		Agenda &agenda = *_household.members[member];
		Task walk = agenda.tasks()[index];
		const DayMask alone = set_out_days(group, walk) & DayMask(~set_out_days_of(group.leader, group, walk.target));
		if (alone == 0) {
			return false;
		}
		walk.days = rotate_days(alone, walk.start_ms < group.start_ms ? 1 : 0);
		_dropped.push_back({ person_of(member), walk, Unmet::Leaderless, 0, std::nullopt });
		agenda.remove(index, walk.days);
		walk.kind = TaskKind::GoToBuilding;
		walk.target = index_of(group.goal);
		walk.name = 0;
		agenda.insert(walk);
		return true;
	}

	DayMask set_out_days_of(PersonId person, const Group &group, uint32_t number) const {
		DayMask days = 0;
		for (const Task &task : _household.of(person).tasks()) {
			days |= is_walk(task, number) ? set_out_days(group, task) : DayMask(0);
		}
		return days;
	}

	// On which no joiner is left, and one of them walks with another leader in the time.
	DayMask deserted_days(const Group &group, uint32_t number) const {
		DayMask left = 0, called_away = 0;
		for (PersonId joiner : group.joiners) {
			left |= set_out_days_of(joiner, group, number);
			for (const Task &task : _household.of(joiner).tasks()) {
				called_away |= task.kind == TaskKind::Accompany && !is_walk(task, number) ? met_days(group, task) : DayMask(0);
			}
		}
		return called_away & DayMask(~left);
	}

	// On which the group sets out and the entry lies in its time.
	static DayMask met_days(const Group &group, const Task &task) {
		DayMask days = 0;
		for (int shift = -1; shift <= 1; ++shift) {
			const int64_t start = task.start_ms + shift * one_day.ms, end = task.end_ms + shift * one_day.ms;
			days |= start < group.end_ms && group.start_ms < end ? rotate_days(task.days, -shift) : DayMask(0);
		}
		return days;
	}

	bool drop_one() {
		for (size_t member = 0; member < _household.members.size(); ++member) {
			const std::vector<Task> &tasks = _household.members[member]->tasks();
			for (size_t i = 0; i < tasks.size(); ++i) {
				if (tasks[i].requirement != 0 && drop_days(person_of(member), i)) {
					return true;
				}
			}
		}
		return false;
	}

	// Of one entry, all days for the same reason at once.
	bool drop_days(PersonId person, size_t index) {
		const Task task = _household.of(person).tasks()[index];
		DroppedTask dropped{ person, task, Unmet::No, 0, std::nullopt };
		DayMask days = 0; // written for
		for (int day = 0; day < 7; ++day) {
			uint16_t name = 0;
			const Unmet reason = is_on(written_days(task), day) ? unmet(person, task, day, name) : Unmet::No;
			if (reason != Unmet::No && (days == 0 || (reason == dropped.reason && name == dropped.name))) {
				dropped.reason = reason;
				dropped.name = name;
				days |= DayMask(1u << day);
			}
		}
		if (days == 0) {
			return false;
		}
		dropped.task.days = rotate_days(days, task.days_later);
		_household.of(person).remove(index, dropped.task.days);
		drop_companions(dropped);
		_dropped.push_back(dropped);
		return true;
	}

	void drop_companions(const DroppedTask &dropped) {
		const Group *group = group_of(dropped.task);
		if (group == nullptr) {
			return;
		}
		if (dropped.person != group->leader) {
			const DayMask lonely = dropped.task.days & DayMask(~joined_days(*group, dropped.task.target));
			remove_walk(group->leader, dropped.task.target, lonely);
			return;
		}
		for (PersonId joiner : group->joiners) {
			remove_walk(joiner, dropped.task.target, dropped.task.days);
		}
	}

	const Group *group_of(const Task &task) const {
		return task.kind == TaskKind::Accompany && task.target < _household.groups.size() ? &_household.groups[task.target] : nullptr;
	}

	DayMask walking_days(PersonId person, uint32_t group) const {
		DayMask days = 0;
		for (const Task &task : _household.of(person).tasks()) {
			days |= is_walk(task, group) ? task.days : DayMask(0);
		}
		return days;
	}

	// On which any joiner still walks in the group.
	DayMask joined_days(const Group &group, uint32_t number) const {
		DayMask days = 0;
		for (PersonId joiner : group.joiners) {
			days |= walking_days(joiner, number);
		}
		return days;
	}

	void remove_walk(PersonId person, uint32_t group, DayMask days) {
		Agenda &agenda = _household.of(person);
		for (size_t i = agenda.tasks().size(); i-- > 0;) {
			if (is_walk(agenda.tasks()[i], group) && (agenda.tasks()[i].days & days) != 0) {
				agenda.remove(i, days);
			}
		}
	}

	Unmet unmet(PersonId person, const Task &task, int day, uint16_t &name) const {
		for (uint8_t number = task.requirement; number != 0; number = _requirements[number].outer) {
			name = _requirements[number].name;
			const Unmet reason = unmet_one(person, task, day, _requirements[number]);
			if (reason != Unmet::No) {
				return reason;
			}
		}
		return Unmet::No;
	}

	Unmet unmet_one(PersonId person, const Task &task, int day, const Requirement &requirement) const {
		if (requirement.name == 0) {
			return Unmet::No; // what has no name is always there
		}
		bool is_too_early = false;
		for (const bool is_own : { true, false }) {
			bool is_lost = false;
			for (const NamedTask &named : _named) {
				if (named.task.name != requirement.name || (named.person == person) != is_own || !is_on(written_days(named.task), day)) {
					continue;
				}
				if (requirement.is_after && since_written_day(named.task, named.task.end_ms) > since_written_day(task, task.start_ms)) {
					is_too_early = true;
				} else if (is_lived(named, day)) {
					return Unmet::No;
				} else {
					is_lost = true;
				}
			}
			if (is_lost || is_too_early) {
				return is_lost ? Unmet::Lost : Unmet::NotOver;
			}
		}
		return Unmet::Missing;
	}

	// On the day that it was written for.
	bool is_lived(const NamedTask &named, int day) const {
		const int64_t end = since_written_day(named.task, named.task.end_ms);
		const std::vector<Task> &tasks = _household.of(named.person).tasks();
		return std::any_of(tasks.begin(), tasks.end(), [&](const Task &task) {
			return task.name == named.task.name && is_on(written_days(task), day) && since_written_day(task, task.end_ms) == end &&
					has_company(named.person, task, day);
		});
	}

	bool has_company(PersonId person, const Task &task, int day) const {
		const Group *group = group_of(task);
		if (group == nullptr) {
			return true;
		}
		const DayMask others = person == group->leader ? joined_days(*group, task.target) : walking_days(group->leader, task.target);
		return is_on(rotate_days(others, -int64_t(task.days_later)), day);
	}

	const HouseholdAgendas &_household;
	std::span<const NamedTask> _named;
	std::span<const Requirement> _requirements;
	std::vector<DroppedTask> _dropped;
};

} // namespace

std::vector<DroppedTask> drop_unmet(const HouseholdAgendas &household, std::span<const NamedTask> named, std::span<const Requirement> requirements) {
	return Dropping(household, named, requirements).run();
}

} // namespace pcg
