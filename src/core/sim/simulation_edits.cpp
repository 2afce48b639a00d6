#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

#include "core/semantics/city_query.h"
#include "core/sim/behavior.h"
#include "core/sim/simulation.h"

// What changes while a simulation runs: the city around people, the people, and whose they are.
namespace pcg {

namespace {
constexpr float arm_length = 0.01f; // metres within which somebody is where it should be
constexpr float zone_margin = 2.0f; // paths end on the navigation mesh, this far from the zone at most
}

// After edits of the city. Costs time proportional to the population.
void Simulation::mend_goals() {
	for (uint32_t i = 0; i < _persons.size(); ++i) {
		const BuildingId building = _persons[i].target().building();
		const bool is_gone = index_of(building) < _city.buildings().size() && _city.building(building).is_removed;
		if (is_gone && _persons[i].state == PersonState::Inside && !_persons[i].is_absent()) {
			put_out(PersonId(i));
		}
	}
	for (uint32_t i = 0; i < _persons.size(); ++i) {
		PersonRecord &person = _persons[i];
		const bool walks = person.state == PersonState::Walking;
		if (person.is_absent() || person.state == PersonState::Inside ||
				has_place(person.target(), person, walks ? _walks[person.walk].points.back() : person.position)) {
			continue;
		}
		if (person.state == PersonState::Waiting) { // stood before a door
			person.place_kind = Target::Kind::None;
			person.place = PersonRecord::none;
		} else {
			mend_goal(PersonId(i));
		}
	}
	for (uint32_t i = 0; i < _persons.size(); ++i) {
		const PersonRecord &person = _persons[i];
		if (!person.is_absent() && person.is_on_its_own()) {
			try_again(PersonId(i)); // perhaps there is a way now
		}
	}
}

// The ground is another one than before. Costs time proportional to the population, and to the walks that lead over what changed.
void Simulation::mend_ways() {
	const uint64_t since = std::exchange(_ground_revision, _paths.ground_revision());
	for (uint32_t i = 0; i < _persons.size(); ++i) {
		const PersonId id = PersonId(i);
		if (_persons[i].state == PersonState::Walking && !is_led(id)) {
			mend_way(id, since);
		} else if (is_stranded(id)) {
			try_again(id);
		}
	}
}

// Round what is in the way now, to where the walk was going; where no way leads there, what led there begins anew.
void Simulation::mend_way(PersonId id, uint64_t since) {
	const Walk &walk = _walks[record(id).walk];
	rest_of(walk, _now, _way);
	if (_paths.is_walkable(_way, since)) {
		return;
	}
	const std::vector<glm::vec3> &path = find_way(id, { &walk.points.back(), 1 });
	if (path.empty()) {
		mend_goal(id);
		return;
	}
	const PersonRecord before = record(id);
	const Target goal = before.target();
	const uint32_t next = _walks.add(path, _now, walk.speed, walk.walkers);
	emit(id, SimEventKind::GoalChanged, goal);
	set_out(id, next, goal, before.purpose);
	schedule(id);
	if (before.walks_in_group()) {
		follow(_parties[before.party], next, goal, before.purpose);
	}
}

// Whether the person walks as a member of a group that somebody else leads.
bool Simulation::is_led(PersonId id) const {
	return record(id).walks_in_group() && _parties[record(id).party].leader != id;
}

// Whether the place is still where somebody is or comes out.
bool Simulation::has_place(const Target &place, const PersonRecord &person, glm::vec3 position) const {
	const auto is_here = [position](glm::vec3 point) { return glm::distance(point, position) <= arm_length; };
	switch (place.kind) {
		case Target::Kind::Building: {
			const std::vector<EntranceId> &doors = _city.building(place.building()).entrances;
			return std::any_of(doors.begin(), doors.end(),
					[&](EntranceId door) { return !_city.entrance(door).is_removed && is_here(_city.entrance(door).position); });
		}
		case Target::Kind::Zone: {
			const Zone &zone = _city.zone(place.zone());
			const glm::vec3 away = nearest_point(zone, position) - position;
			return !zone.is_removed && glm::length(glm::vec3(away.x, 0.0f, away.z)) <= zone_margin;
		}
		case Target::Kind::Object: {
			const CityObject &object = _city.object(place.object());
			return !object.is_removed && person.object_place < object.places.size() && is_here(object.places[person.object_place].position);
		}
		case Target::Kind::Person:
		case Target::Kind::None:
			return true;
	}
	return true;
}

// The place of somebody outdoors is not where it was. What led there begins anew.
void Simulation::mend_goal(PersonId id) {
	PersonRecord &person = record(id);
	const Target place = person.target();
	if (is_led(id)) {
		return; // the leader's is everybody's
	}
	emit(id, SimEventKind::GoalChanged, place);
	if (person.walks_in_group()) {
		stop_walk(id);
		for (PersonId member : _parties[person.party].collected) {
			stop_walk(member);
			show_standing(member);
			schedule(member);
		}
		show_standing(id);
		lead_on(person.party);
		schedule(id);
		return;
	}
	if (person.state == PersonState::Walking) {
		stop_walk(id);
		show_standing(id);
	}
	release_place(id);
	person.due = never;
	if (person.behavior == PersonRecord::none) {
		begin_stay(id, place.building());
		person.due = person.is_in_group() && person.state != PersonState::Walking ? _now + _settings.patience : person.due;
	} else if (_behaviors[person.behavior]->begin_again() != RunState::Paused) {
		end_rule(id, SimEventKind::RuleEnded);
	}
	schedule(id);
}

// Out of a building that is gone. Rules and groups go on outdoors.
void Simulation::put_out(PersonId id) {
	emit(id, SimEventKind::GoalChanged, record(id).target());
	leave_building(id, record(id).position);
	show_standing(id);
	if (record(id).is_on_its_own()) {
		begin_stay(id, home_of(id));
	}
	schedule(id);
}

bool Simulation::take_in_people() {
	const size_t before = _persons.size();
	if (_population.persons.size() != _agendas.person_count()) {
		return false;
	}
	make_room();
	take_in_city_edits();
	if (!_has_started || _persons.size() == before) {
		return true;
	}
	const SimTime now = _now;
	_is_replaying = true;
	for (const Household &household : _population.households) {
		if (index_of(household.first_member) >= before) {
			replay_household(household, now);
		}
	}
	end_replay(now, before);
	for (size_t i = before; i < _persons.size(); ++i) {
		const PersonId id = PersonId(uint32_t(i));
		emit(id, SimEventKind::Added, record(id).target());
		if (is_outside(id)) {
			show_person(id);
		}
	}
	return true;
}

void Simulation::take_in_agenda(PersonId id) {
	if (!_has_started || !is_living(id)) {
		return;
	}
	PersonRecord &person = record(id);
	const PlannedEntry entry = plan_at(id, _now);
	bool goes_on = entry.kind == person.entry_kind && entry.is_hole() == person.is_in_hole(); // its start may have been cut in the past
	if (goes_on && person.behavior != PersonRecord::none && entry.kind == TaskKind::DelayedRule) {
		goes_on = _behaviors[person.behavior]->rule() == RuleId(entry.target);
	} else if (goes_on && person.is_in_group()) {
		goes_on = _parties[person.party].group == entry.target;
	} else if (goes_on && is_valid(building_of(id, entry))) {
		goes_on = person.target().building() == building_of(id, entry);
	}
	person.entry_task = find_lived_entry(id);
	person.entry_end = goes_on ? entry.end : _now;
	if (person.is_in_group() && !goes_on) {
		if (!waits_in_vain(id)) { // not before the group is over
			schedule(id);
			return;
		}
		leave_party(id);
	}
	if (!goes_on) {
		close_span(id); // what was lived so far served the old entry
	}
	person.entry_start = entry.start;
	person.entry_task = entry.task;
	person.entry_kind = entry.kind;
	if (person.behavior != PersonRecord::none) {
		person.rule_end = std::min(person.rule_end, person.entry_end);
	}
	if (!goes_on) {
		begin_entry(id);
	}
	schedule(id);
}

// Where what the person lives is in its new agenda.
uint16_t Simulation::find_lived_entry(PersonId id) const {
	const PersonRecord &person = record(id);
	if (person.is_in_hole()) {
		return PlannedEntry::hole;
	}
	const std::span<const Task> tasks = _agendas.agenda_of(id).on(person.entry_start.day());
	const auto found = std::find_if(tasks.begin(), tasks.end(), [&](const Task &task) {
		return task.kind == person.entry_kind && task.start() == person.entry_start.time_of_day() &&
				((task.days >> person.entry_start.weekday()) & 1);
	});
	return found != tasks.end() ? uint16_t(found - tasks.begin()) : PlannedEntry::gone;
}

// Its rule, group, walk and seat.
void Simulation::drop_everything(PersonId id) {
	PersonRecord &person = record(id);
	close_span(id);
	if (person.behavior != PersonRecord::none) {
		_behaviors[person.behavior]->end();
		_free_behaviors.push_back(person.behavior);
		person.behavior = PersonRecord::none;
		person.rule_end = never;
		emit(id, SimEventKind::RuleCut);
	}
	if (person.state == PersonState::Walking) {
		stop_walk(id);
		show_standing(id);
	}
	leave_party(id);
	release_place(id);
	person.due = never;
	person.queued = never;
	person.entry_start = _now;
	person.entry_end = never;
	person.entry_task = PlannedEntry::hole;
	person.entry_kind = TaskKind::StayInside;
}

bool Simulation::take_over(PersonId id) {
	if (!_has_started || !is_living(id)) {
		return false;
	}
	emit(id, SimEventKind::TakenOver);
	drop_everything(id);
	if (!is_outside(id)) {
		leave_building(id, record(id).position);
	}
	if (has_bodies()) {
		_host->free_agent(id);
	}
	PersonRecord &person = record(id);
	person.state = PersonState::Waiting;
	person.pose = AgentPose::Stand;
	person.place_kind = Target::Kind::None;
	person.place = PersonRecord::none;
	person.presence = Presence::Taken;
	return true;
}

bool Simulation::place_taken(PersonId id, glm::vec3 position) {
	if (index_of(id) >= _persons.size() || record(id).presence != Presence::Taken) {
		return false;
	}
	record(id).position = position;
	return true;
}

bool Simulation::release(PersonId id) {
	if (index_of(id) >= _persons.size() || record(id).presence != Presence::Taken) {
		return false;
	}
	close_span(id);
	record(id).presence = Presence::Living;
	show_person(id);
	emit(id, SimEventKind::Released);
	begin_entry(id);
	schedule(id);
	return true;
}

bool Simulation::remove_person(PersonId id) {
	if (!_has_started || index_of(id) >= _persons.size() || record(id).presence == Presence::Removed) {
		return false;
	}
	PersonRecord &person = record(id);
	const bool has_body = is_outside(id) && !person.is_absent();
	emit(id, SimEventKind::Removed);
	drop_everything(id);
	if (is_outside(id)) {
		change_outside(-1);
	} else if (index_of(person.target().building()) < _inside_counts.size()) {
		--_inside_counts[person.place];
	}
	if (has_body && has_bodies()) {
		_host->free_agent(id);
	}
	person.state = PersonState::Inside;
	person.place_kind = Target::Kind::None;
	person.place = PersonRecord::none;
	person.presence = Presence::Removed;
	return true;
}

} // namespace pcg
