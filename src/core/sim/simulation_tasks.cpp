#include <algorithm>
#include <string>

#include "core/agenda/context.h"
#include "core/sim/behavior.h"
#include "core/sim/simulation.h"

// The entries of the agendas, one after the other (PCG language, sections 5 to 7).
namespace pcg {

namespace {
constexpr Duration lateness_allowed = Duration{ 1000 }; // walks and rule files round
constexpr uint64_t slot_stream = 0x736C6F74; // keeps draws for floating slots apart from those of rules
}

PlannedEntry Simulation::entry_of(PersonId id) const {
	const PersonRecord &person = record(id);
	uint32_t target = PersonRecord::none;
	if (person.is_in_group()) {
		target = _parties[person.party].group;
	} else if (!person.is_in_hole()) {
		const std::span<const Task> tasks = _agendas.agenda_of(id).on(person.entry_start.day());
		target = person.entry_task < tasks.size() ? tasks[person.entry_task].target : target; // it may be gone
	}
	return { person.entry_start, person.entry_end, target, person.entry_task, person.entry_kind };
}

// `is_renewed`: its agenda became another one, maybe in the middle of the entry, for which whoever is inside already is not late.
void Simulation::begin_entry(PersonId id, bool is_renewed) {
	PersonRecord &person = record(id);
	close_span(id);
	if (person.behavior != PersonRecord::none) {
		end_rule(id, SimEventKind::RuleCut);
	}
	const PlannedEntry entry = plan_at(id, _now);
	person.entry_start = entry.start;
	person.entry_end = entry.end;
	person.entry_task = entry.task;
	person.entry_kind = entry.kind;
	person.can_be_late = !entry.is_hole() && entry.kind == TaskKind::StayInside && !entry.is_start_cut &&
			(!is_renewed || entry.start == _now || is_outside(id));
	person.due = person.state == PersonState::Walking ? person.due : never;
	const BuildingId building = building_of(id, entry);
	emit(id, SimEventKind::TaskStarted, is_valid(building) ? target_of(building) : Target{});
	switch (entry.kind) {
		case TaskKind::StayInside: // holes too
		case TaskKind::GoToBuilding:
			begin_stay(id, building);
			break;
		case TaskKind::Accompany:
			begin_accompany(id, entry.target);
			break;
		case TaskKind::DelayedRule:
			begin_rule(id, RuleId(entry.target), entry.end);
			break;
		case TaskKind::FloatingSlot:
			begin_slot(id);
			break;
	}
}

// Inside the building, on foot if need be. Who cannot get there stays where it is.
void Simulation::begin_stay(PersonId id, BuildingId building) {
	PersonRecord &person = record(id);
	if (is_valid(building) && person.target().building() == building && person.state != PersonState::Waiting) {
		person.purpose = Purpose::Agenda; // a walk there goes on
		note_lateness(id);
		return;
	}
	if (go_to_building(id, building, Purpose::Agenda)) {
		return;
	}
	if (person.state == PersonState::Walking) {
		stop_walk(id);
		show_standing(id);
	}
	release_place(id);
	person.due = _to_points.empty() ? never : _now + retry_pause; // its doors: without any, it takes an edit
}

// Where somebody belongs whom neither a rule nor a group leads; Invalid: where it is.
BuildingId Simulation::resting_place(PersonId id) const {
	const TaskKind kind = record(id).entry_kind;
	if (is_stay(kind)) {
		return building_of(id, entry_of(id));
	}
	if (kind == TaskKind::DelayedRule) { // which is over
		return place_until_next(id);
	}
	if (!is_outside(id)) {
		return BuildingId::Invalid;
	}
	return kind == TaskKind::FloatingSlot ? home_of(id) : place_until_next(id);
}

// Whoever found no way there goes now if there is one.
void Simulation::try_again(PersonId id) {
	PersonRecord &person = record(id);
	const bool walks = person.state == PersonState::Walking;
	const BuildingId goal = resting_place(id);
	if (!is_valid(goal) || (walks && !is_stay(person.entry_kind)) || (person.target().building() == goal && person.state != PersonState::Waiting)) {
		return;
	}
	find_doors(goal, _to_points);
	if (!find_way(id, _to_points).empty()) {
		begin_stay(id, goal);
	} else if (!walks && !_to_points.empty()) {
		person.due = _now + retry_pause;
	}
	schedule(id);
}

// See SimulationStatistics::late_arrivals.
void Simulation::note_lateness(PersonId id) {
	PersonRecord &person = record(id);
	const bool is_there = person.can_be_late && person.state == PersonState::Inside && person.place == entry_of(id).target;
	if (is_there && _now > person.entry_start + lateness_allowed) {
		person.can_be_late = false;
		_statistics.late_arrivals += _is_replaying ? 0 : 1;
		emit(id, SimEventKind::ArrivedLate, person.target());
	}
}

uint32_t Simulation::borrow_behavior() {
	if (_free_behaviors.empty()) {
		_behaviors.push_back(std::make_unique<Behavior>(*this, *_rule_world, _settings));
		return uint32_t(_behaviors.size() - 1);
	}
	const uint32_t result = _free_behaviors.back();
	_free_behaviors.pop_back();
	return result;
}

void Simulation::begin_rule(PersonId id, RuleId rule, SimTime end) {
	if (record(id).state == PersonState::Walking) {
		stop_walk(id);
		show_standing(id);
	}
	if (!_program || index_of(rule) >= _program->rules.size()) {
		Diagnostic missing;
		missing.id = "missing-rule";
		missing.message = "an agenda wants a rule that the program of the simulation does not have";
		missing.hint = "run the agendas with the rule file that wrote them";
		note(std::move(missing));
		emit(id, SimEventKind::RuleFailed);
		idle_until_next(id);
		return;
	}
	const uint32_t behavior = borrow_behavior();
	record(id).behavior = behavior;
	record(id).rule_end = end;
	if (_behaviors[behavior]->begin(id, rule) != RunState::Paused) {
		end_rule(id, SimEventKind::RuleEnded);
	}
}

void Simulation::resume_rule(PersonId id) {
	if (_behaviors[record(id).behavior]->resume() != RunState::Paused) {
		end_rule(id, SimEventKind::RuleEnded);
	}
}

void Simulation::end_rule(PersonId id, SimEventKind how) {
	PersonRecord &person = record(id);
	_behaviors[person.behavior]->end();
	_free_behaviors.push_back(person.behavior);
	person.behavior = PersonRecord::none;
	person.rule_end = never;
	emit(id, how);
	if (person.state == PersonState::Walking) {
		stop_walk(id);
		show_standing(id);
	}
	person.due = never;
	release_place(id);
	if (person.entry_end <= _now) {
		return; // the next entry begins at once
	}
	if (person.entry_kind == TaskKind::FloatingSlot) {
		begin_slot(id);
	} else {
		idle_until_next(id);
	}
}

// Where the next entry wants the person, if that follows without a hole and is a place; else home.
BuildingId Simulation::place_until_next(PersonId id) const {
	const BuildingId goal = building_of(id, plan_at(id, record(id).entry_end));
	return is_valid(goal) ? goal : home_of(id);
}

void Simulation::idle_until_next(PersonId id) { begin_stay(id, place_until_next(id)); }

void Simulation::begin_slot(PersonId id) {
	const uint32_t chosen = choose_floating_task(id);
	if (chosen == PersonRecord::none) {
		if (is_outside(id)) {
			begin_stay(id, home_of(id));
		}
		return;
	}
	const FloatingTask &task = _agendas.floating_tasks[chosen];
	_floating_taken[chosen] = int32_t(_now.day());
	emit(id, SimEventKind::FloatingTaskStarted);
	begin_rule(id, task.rule, _now + Duration{ task.duration_ms });
}

// Of the tasks still in today's pool that fit, one of the highest priority; none if none fits.
uint32_t Simulation::choose_floating_task(PersonId id) const {
	const SimTime slot_end = record(id).entry_end;
	const int32_t today = int32_t(_now.day());
	const uint32_t first = _agendas.first_floating_task[index_of(id)];
	const uint32_t end = _agendas.first_floating_task[index_of(id) + 1];
	Random random(derive_seed(derive_seed(_settings.seed, slot_stream), index_of(id)), uint64_t(_now.ms));
	uint32_t best = PersonRecord::none;
	size_t ties = 0;
	for (uint32_t i = first; i < end; ++i) {
		const FloatingTask &task = _agendas.floating_tasks[i];
		const bool is_in_pool = ((task.days >> _now.weekday()) & 1) && _floating_taken[i] != today;
		if (!is_in_pool || _now + Duration{ task.duration_ms } > slot_end || task.duration_ms <= 0) {
			continue;
		}
		const bool is_better = best == PersonRecord::none || task.priority > _agendas.floating_tasks[best].priority;
		const bool is_tie = !is_better && task.priority == _agendas.floating_tasks[best].priority;
		ties = is_better ? 1 : ties + (is_tie ? 1 : 0);
		if (is_better || (is_tie && random.index(ties) == 0)) {
			best = i;
		}
	}
	return best;
}

} // namespace pcg
