#include <algorithm>

#include "core/sim/behavior.h"
#include "core/sim/simulation.h"

// Other agendas and other rules for people who live.
namespace pcg {

namespace {

constexpr uint32_t none = PersonRecord::none;
constexpr uint32_t not_asked = none - 1;

// A floating task that somebody has taken from today's pool.
struct TakenTask {
	PersonId person = PersonId::Invalid;
	RuleId rule = RuleId::Invalid; // of the old program
	int32_t duration_ms = 0;
};

// But for those that are being done, which a renewal breaks off. `running`: the rule of somebody's.
std::vector<TakenTask> find_taken(const AgendaSet &agendas, std::span<const int32_t> taken, int32_t day, const std::function<RuleId(PersonId)> &running) {
	std::vector<TakenTask> result;
	for (uint32_t i = 0; i < agendas.person_count(); ++i) {
		RuleId broken_off = running(PersonId(i));
		for (uint32_t task = agendas.first_floating_task[i]; task < agendas.first_floating_task[i + 1]; ++task) {
			const FloatingTask &floating = agendas.floating_tasks[task];
			if (taken[task] == day && floating.rule == broken_off) {
				broken_off = RuleId::Invalid; // others of that rule were done
			} else if (taken[task] == day) {
				result.push_back({ PersonId(i), floating.rule, floating.duration_ms });
			}
		}
	}
	return result;
}

// The same tasks, by the names of their rules, out of the new pools.
void take_again(std::span<const TakenTask> tasks, const Program &old, const AgendaSet &agendas, const Program &program, int32_t day,
		std::span<int32_t> taken) {
	std::vector<RuleId> names; // by rule of the old program
	for (const RuleInfo &rule : old.rules) {
		names.push_back(program.find_rule(rule.name));
	}
	for (const TakenTask &task : tasks) {
		if (index_of(task.rule) >= names.size()) {
			continue; // the old program did not have it either
		}
		const uint32_t end = agendas.first_floating_task[index_of(task.person) + 1];
		for (uint32_t i = agendas.first_floating_task[index_of(task.person)]; i < end; ++i) {
			const FloatingTask &floating = agendas.floating_tasks[i];
			if (taken[i] != day && floating.rule == names[index_of(task.rule)] && floating.duration_ms == task.duration_ms) {
				taken[i] = day;
				break;
			}
		}
	}
}

} // namespace

void Simulation::change_agendas(const std::function<std::shared_ptr<const Program>()> &change, std::vector<AttributeOverride> overrides) {
	const std::shared_ptr<const Program> old = _program;
	const int32_t today = int32_t(_now.day());
	const std::vector<TakenTask> taken = find_taken(_agendas, _floating_taken, today, [this](PersonId id) {
		const bool runs = index_of(id) < _persons.size() && record(id).behavior != none && record(id).entry_kind == TaskKind::FloatingSlot;
		return runs ? _behaviors[record(id).behavior]->rule() : RuleId::Invalid;
	});
	std::vector<PersonId> living;
	for (size_t i = 0; _has_started && i < _persons.size(); ++i) {
		if (const PersonId id = PersonId(uint32_t(i)); is_living(id)) {
			record(id).is_in_group() ? close_span(id) : drop_everything(id); // what was lived so far served the old agendas
			living.push_back(id);
		}
	}
	_behaviors.clear(); // they run the old program
	_free_behaviors.clear();
	_rule_stacks.idle.clear(); // rules of the new one may need larger ones
	_program = change();
	_settings.overrides = std::move(overrides);
	_floating_taken.assign(_agendas.floating_tasks.size(), never_taken);
	if (old && _program) {
		take_again(taken, *old, _agendas, *_program, today, _floating_taken);
	}
	_city_revision = _city.revision() - 1; // what rules know of the city is made for their program
	take_in_city_edits();
	keep_parties(living);
	for (const PersonId id : living) {
		if (record(id).entry_end <= _now && !record(id).is_in_group()) {
			begin_entry(id, true);
		}
		schedule(id);
	}
	for (const uint32_t &party : _party_of_group) {
		if (party != none) {
			forget_unexpected(party);
		}
	}
}

// The group in the new agendas that is the one with which the person is on the way: the same leader takes it to the same place. None if there is none.
uint32_t Simulation::find_same_group(PersonId id) const {
	const Party &party = _parties[record(id).party];
	const PlannedEntry entry = plan_at(id, record(id).entry_start);
	if (entry.kind != TaskKind::Accompany || entry.target >= _agendas.groups.size()) {
		return none;
	}
	const Group &group = _agendas.groups[entry.target];
	return group.leader == party.leader && group.goal == party.goal ? entry.target : none;
}

// Groups that all their members have in the new agendas, too, go on, for nobody is left behind on the way; members of others stand where they are.
void Simulation::keep_parties(std::span<const PersonId> living) {
	std::vector<uint32_t> groups(_parties.size(), not_asked); // by party
	for (const PersonId id : living) {
		if (record(id).is_in_group()) {
			uint32_t &group = groups[record(id).party];
			const uint32_t found = find_same_group(id);
			group = group == not_asked || group == found ? found : none;
		}
	}
	_party_of_group.assign(_agendas.groups.size(), none);
	for (uint32_t i = 0; i < groups.size(); ++i) {
		if (groups[i] == none || (groups[i] != not_asked && _party_of_group[groups[i]] != none)) {
			groups[i] = none;
			_free_parties.push_back(i);
		} else if (groups[i] != not_asked) {
			_parties[i].group = groups[i];
			_party_of_group[groups[i]] = i;
		}
	}
	for (const PersonId id : living) {
		PersonRecord &person = record(id);
		if (person.is_in_group() && groups[person.party] == none) {
			person.party = none;
			drop_everything(id);
		} else if (person.is_in_group()) {
			const PlannedEntry entry = plan_at(id, person.entry_start);
			person.entry_start = entry.start;
			person.entry_end = entry.end;
			person.entry_task = entry.task;
		}
		person.entry_end = person.is_in_group() ? person.entry_end : _now; // none of the others has begun anything as yet
	}
}

// Nobody waits for those who have something else to do by the new agendas.
void Simulation::forget_unexpected(uint32_t index) {
	Party &party = _parties[index];
	const auto is_here = [&](PersonId id) { return record(id).party == index; };
	const auto member = std::find_if(party.pending.begin(), party.pending.end(), is_here);
	const PersonId caller = is_here(party.leader) || member == party.pending.end() ? party.leader : *member;
	if (std::erase_if(party.pending, [&](PersonId id) { return !is_here(id) && !is_expected(id, party.group, caller); }) > 0) {
		lead_on_or_end(index);
	}
}

} // namespace pcg
