#include <algorithm>

#include <glm/geometric.hpp>

#include "core/sim/simulation.h"

// Walking together (PCG language, section 5, accompany). The leader goes from one place with joiners to the next, nearest first, until all
// are with it; then the group walks to the goal at its slowest member's speed. A member takes part from its entry on, until the group is
// over; other entries wait for that. The leader decides in lead_on(), called whenever something changed.
namespace pcg {

namespace {
constexpr float arm_length = 0.01f; // metres within which two stand together
}

void Simulation::begin_accompany(PersonId id, uint32_t group) {
	PersonRecord &person = record(id);
	if (group >= _agendas.groups.size()) {
		idle_until_next(id);
		return;
	}
	const uint32_t party = call_party(group, id);
	release_place(id);
	if (_parties[party].leader == id) {
		if (person.state == PersonState::Walking) {
			stop_walk(id);
			show_standing(id);
		}
	} else if (person.state != PersonState::Walking) {
		person.due = std::max(_now, person.entry_start + _settings.patience);
	} // else it goes on to where it was going and waits there
	person.party = party;
	lead_on(party);
}

// The party of the group, made by the first member whose entry begins.
uint32_t Simulation::call_party(uint32_t group, PersonId caller) {
	uint32_t &index = _party_of_group[group];
	if (index == PersonRecord::none) {
		if (_free_parties.empty()) {
			_free_parties.push_back(uint32_t(_parties.size()));
			_parties.emplace_back();
		}
		index = _free_parties.back();
		_free_parties.pop_back();
		const Group &plan = _agendas.groups[group];
		Party &party = _parties[index];
		party.group = group;
		party.leader = plan.leader;
		party.goal = plan.goal;
		party.collected.clear();
		party.pending.clear();
		for (PersonId joiner : plan.joiners) {
			if (joiner != plan.leader && is_expected(joiner, group, caller)) {
				party.pending.push_back(joiner);
			}
		}
	}
	Party &party = _parties[index];
	const bool is_known = caller == party.leader || std::count(party.pending.begin(), party.pending.end(), caller) != 0;
	if (!is_known) {
		party.pending.push_back(caller);
	}
	return index;
}

// Whether the person still has to begin its entry of the group on the day of the caller's. Newer entries may have removed or cut it; who has begun it
// went there already, with others or alone, or is on the way.
bool Simulation::is_expected(PersonId id, uint32_t group, PersonId caller) const {
	if (index_of(id) >= _persons.size() || record(id).is_absent()) {
		return false;
	}
	const SimTime begin{ record(caller).entry_start.ms - _agendas.groups[group].start_ms };
	const SimTime first = SimTime::at(begin.day(), Duration{ _agendas.groups[group].start_ms });
	SimTime start = never, end = first;
	for (int64_t day = first.day(); day <= first.day() + 1; ++day) {
		for (const Task &task : _agendas.agenda_of(id).on(day)) {
			const SimTime task_start = SimTime::at(day, task.start());
			const bool is_on = (task.days >> task_start.weekday()) & 1;
			if (is_on && is_walk(task, group) && task_start >= first && task_start < first + one_day) {
				start = std::min(start, task_start);
				end = std::max(end, SimTime::at(day, task.end()));
			}
		}
	}
	return _now < end && (id == caller || record(id).entry_start < start || record(id).entry_end <= _now);
}

// A joiner, for a leader who is not there and will not come.
bool Simulation::waits_in_vain(PersonId id) const {
	const uint32_t index = record(id).party;
	const PersonId leader = _parties[index].leader;
	const bool is_here = index_of(leader) < _persons.size() && record(leader).party == index;
	return id != leader && !is_here && !is_expected(leader, _parties[index].group, id);
}

void Simulation::lead_on(uint32_t index) {
	const PersonId leader = _parties[index].leader;
	if (index_of(leader) >= _persons.size() || record(leader).party != index ||
			record(leader).state == PersonState::Walking) {
		return; // not there yet
	}
	collect_here(_parties[index]);
	if (_parties[index].pending.empty()) {
		Party &party = _parties[index];
		find_doors(party.goal, _to_points);
		const bool is_there = record(leader).state == PersonState::Inside && record(leader).target().building() == party.goal; // all of them
		if (is_there || party.collected.empty() || !walk_together(party, target_of(party.goal), _to_points, Purpose::Group)) {
			end_party(index);
		}
		return;
	}
	fetch(index, nearest_pending(_parties[index]));
}

bool Simulation::is_with_leader(PersonId leader_id, PersonId joiner_id) const {
	const PersonRecord &leader = record(leader_id);
	const PersonRecord &joiner = record(joiner_id);
	if (joiner.party != leader.party || joiner.state == PersonState::Walking) {
		return false;
	}
	if (joiner.state == PersonState::Inside) { // the leader may stand before the door
		return is_valid(joiner.target().building()) && leader.target() == joiner.target();
	}
	return leader.state != PersonState::Inside && glm::distance(leader.position, joiner.position) <= arm_length;
}

void Simulation::collect_here(Party &party) {
	for (size_t i = 0; i < party.pending.size();) {
		const PersonId joiner = party.pending[i];
		if (!is_with_leader(party.leader, joiner)) {
			++i;
			continue;
		}
		record(joiner).due = never;
		schedule(joiner);
		party.pending.erase(party.pending.begin() + long(i));
		party.collected.push_back(joiner);
	}
}

// As the crow flies from the leader to where each is or is going; ties to the lower id.
PersonId Simulation::nearest_pending(const Party &party) const {
	PersonId nearest = PersonId::Invalid;
	float least = 0.0f;
	for (PersonId joiner : party.pending) {
		const PersonRecord &person = record(joiner);
		const glm::vec3 place =
				person.state == PersonState::Walking ? _walks[person.walk].points.back() : person.position;
		const float distance = glm::distance(place, record(party.leader).position);
		if (!is_valid(nearest) || distance < least) {
			nearest = joiner;
			least = distance;
		}
	}
	return nearest;
}

// To the joiner, or to where it is going; waits there if that is here.
void Simulation::fetch(uint32_t index, PersonId joiner) {
	Party &party = _parties[index];
	const PersonRecord &person = record(joiner);
	const PersonRecord &leader = record(party.leader);
	if (is_valid(person.target().building())) {
		if (leader.target() == person.target()) {
			wait_for_pending(party);
			return;
		}
		find_doors(person.target().building(), _to_points);
	} else {
		const bool walks = person.state == PersonState::Walking;
		_to_points.assign(1, walks ? _walks[person.walk].points.back() : person.position);
		if (leader.state != PersonState::Inside && glm::distance(leader.position, _to_points[0]) <= arm_length) {
			wait_for_pending(party);
			return;
		}
	}
	const Target building = target_of(person.target().building());
	const Target goal = is_valid(building.building()) ? building : target_of(joiner);
	if (!walk_together(party, goal, _to_points, Purpose::Pickup)) {
		std::erase(party.pending, joiner); // it will find out by itself
		lead_on(index);
	}
}

void Simulation::wait_for_pending(Party &party) {
	const PersonRecord leader = record(party.leader); // as it is before it goes in
	if (leader.state == PersonState::Waiting && is_valid(leader.target().building())) {
		for (PersonId member : party.collected) {
			if (is_outside(member)) { // those who were met here have not left yet
				enter_building(member, leader.target().building(), leader.position);
			}
		}
		enter_building(party.leader, leader.target().building(), leader.position);
	}
	if (record(party.leader).due == never) {
		record(party.leader).due = _now + _settings.patience;
		schedule(party.leader);
	}
}

bool Simulation::walk_together(Party &party, Target goal, std::span<const glm::vec3> points, Purpose purpose) {
	const std::vector<glm::vec3> &path = find_way(party.leader, points, party.collected);
	if (path.empty()) {
		emit(party.leader, SimEventKind::Unreachable, goal);
		return false;
	}
	float speed = _population.person(party.leader).walking_speed;
	for (PersonId member : party.collected) {
		speed = std::min(speed, _population.person(member).walking_speed);
	}
	const uint32_t walk = _walks.add(path, _now, speed, uint32_t(party.collected.size() + 1));
	set_out(party.leader, walk, goal, purpose);
	schedule(party.leader);
	follow(party, walk, goal, purpose);
	return true;
}

void Simulation::follow(const Party &party, uint32_t walk, Target goal, Purpose purpose) {
	for (PersonId member : party.collected) {
		set_out(member, walk, goal, purpose);
		record(member).due = never; // the leader arrives for all
		schedule(member);
	}
}

void Simulation::group_walk_ended(PersonId leader, Purpose purpose) {
	const uint32_t index = record(leader).party;
	const Target goal = record(leader).target();
	Party &party = _parties[index];
	end_walk(leader);
	for (PersonId member : party.collected) {
		end_walk(member);
	}
	const glm::vec3 here = record(leader).position;
	if (purpose == Purpose::Group) {
		enter_together(party, goal.building(), here);
		end_party(index);
		return;
	}
	if (is_valid(goal.building())) { // stands before the door; knows which
		stand(leader, PersonState::Waiting, goal, here);
	}
	lead_on(index);
}

void Simulation::enter_together(Party &party, BuildingId building, glm::vec3 door) {
	enter_building(party.leader, building, door);
	for (PersonId member : party.collected) {
		enter_building(member, building, door);
	}
}

void Simulation::lose_patience(PersonId id) {
	const uint32_t index = record(id).party;
	Party &party = _parties[index];
	if (id == party.leader) {
		emit(id, SimEventKind::PatienceRanOut);
		std::erase_if(party.pending, [&](PersonId joiner) { return record(joiner).party != index; });
		const bool has_others = !party.pending.empty();
		if (has_others) {
			record(id).due = _now + _settings.patience; // those who are still on their way here
			schedule(id);
		} else {
			lead_on(index);
		}
		return;
	}
	std::erase(party.pending, id);
	go_alone(id); // its next entry may begin, and make a party: references to them are void
	lead_on_or_end(index);
}

// A party without a leader waits for it as long as somebody is there to wait: nothing is left of it for the next day, or for a saved state, which
// knows parties by their members.
void Simulation::lead_on_or_end(uint32_t index) {
	const Party &party = _parties[index];
	const auto is_here = [&](PersonId id) { return index_of(id) < _persons.size() && record(id).party == index; };
	if (is_here(party.leader)) {
		lead_on(index);
	} else if (std::none_of(party.pending.begin(), party.pending.end(), is_here)) {
		end_party(index);
	}
}

// A joiner that nobody came for. The caller has taken it off the list.
void Simulation::go_alone(PersonId id) {
	const BuildingId goal = _parties[record(id).party].goal;
	emit(id, SimEventKind::PatienceRanOut, target_of(goal));
	close_span(id);
	record(id).party = PersonRecord::none;
	record(id).due = record(id).state == PersonState::Walking ? record(id).due : never;
	record(id).entry_end > _now ? begin_stay(id, goal) : begin_entry(id);
	schedule(id);
}

// A member is called away, or gone. Without a leader the others go alone.
void Simulation::leave_party(PersonId id) {
	const uint32_t index = record(id).party;
	if (index == PersonRecord::none) {
		return;
	}
	Party &party = _parties[index];
	record(id).party = PersonRecord::none;
	record(id).due = never;
	std::erase(party.pending, id);
	std::erase(party.collected, id);
	if (id != party.leader) {
		lead_on_or_end(index);
		return;
	}
	for (PersonId member : party.collected) {
		if (record(member).state == PersonState::Walking) {
			stop_walk(member);
			show_standing(member);
		}
	}
	party.pending.insert(party.pending.end(), party.collected.begin(), party.collected.end());
	party.collected.clear();
	end_party(index);
}

// Everybody goes on with its own agenda.
void Simulation::end_party(uint32_t index) {
	Party party = std::move(_parties[index]);
	_party_of_group[party.group] = PersonRecord::none;
	for (PersonId joiner : party.pending) {
		if (record(joiner).party == index) {
			go_alone(joiner);
		}
	}
	if (index_of(party.leader) < _persons.size() && record(party.leader).party == index) {
		go_on_after_group(party.leader);
	}
	for (PersonId member : party.collected) {
		go_on_after_group(member);
	}
	_parties[index] = std::move(party); // for the memory of its lists
	_free_parties.push_back(index);
}

void Simulation::go_on_after_group(PersonId id) {
	PersonRecord &person = record(id);
	close_span(id);
	person.party = PersonRecord::none;
	person.due = never;
	if (person.entry_end <= _now) {
		begin_entry(id);
	} else if (is_outside(id)) {
		idle_until_next(id); // the goal could not be reached, or there was nobody to take along
	}
	schedule(id);
}

} // namespace pcg
