#include <algorithm>
#include <limits>

#include <glm/geometric.hpp>

#include "core/sim/simulation.h"

// Being somewhere and getting elsewhere. All changes of state and place are made here.
namespace pcg {

namespace {

// Nobody teleports: the path begins and ends exactly where it should, even if navigation snapped its ends to the ground.
void pin_ends(std::vector<glm::vec3> &path, glm::vec3 from, glm::vec3 to) {
	if (path.front() != from) {
		path.insert(path.begin(), from);
	}
	if (path.back() != to || path.size() < 2) {
		path.push_back(to);
	}
}

// Empty if there is none.
void way_between(const PathProvider &paths, glm::vec3 from, glm::vec3 to, std::vector<glm::vec3> &way) {
	if (from == to) {
		way.assign(2, from);
		return;
	}
	paths.find_path(from, to, way);
	if (!way.empty()) {
		pin_ends(way, from, to);
	}
}

} // namespace

void Simulation::find_doors(BuildingId building, std::vector<glm::vec3> &doors) const {
	doors.clear();
	if (index_of(building) >= _city.buildings().size() || _city.building(building).is_removed) {
		return;
	}
	for (EntranceId entrance : _city.building(building).entrances) {
		if (!_city.entrance(entrance).is_removed) {
			doors.push_back(_city.entrance(entrance).position);
		}
	}
}

bool Simulation::has_just_come_in(PersonId id) const {
	return _last_entry == _now && std::find(_last_to_enter.begin(), _last_to_enter.end(), id) != _last_to_enter.end();
}

// Where somebody is, or the doors of the building that it is in. Nobody gets from door to door in no time: if it or one of the `companions` came in
// only now, they leave by that door.
void Simulation::find_starts(PersonId id, std::span<const PersonId> companions) {
	const PersonRecord &person = record(id);
	if (person.state != PersonState::Inside) {
		_from_points.assign(1, position(id));
		return;
	}
	const auto late = std::find_if(companions.begin(), companions.end(), [this](PersonId other) { return has_just_come_in(other); });
	if (has_just_come_in(id) || late != companions.end()) {
		_from_points.assign(1, record(has_just_come_in(id) ? id : *late).position);
		return;
	}
	find_doors(person.target().building(), _from_points);
	if (_from_points.empty() && is_valid(person.target().building())) {
		_from_points.push_back(person.position); // its building was removed around it
	}
}

// From any of `_from_points`, into `_best_way`; empty if none can be reached.
void Simulation::find_shortest_way(std::span<const glm::vec3> goals) {
	_best_way.clear();
	if (_from_points.size() == 1 && goals.size() == 1) {
		way_between(_paths, _from_points[0], goals[0], _best_way);
		return;
	}
	_door_pairs.clear();
	for (uint32_t from = 0; from < _from_points.size(); ++from) {
		for (uint32_t to = 0; to < goals.size(); ++to) {
			_door_pairs.push_back({ glm::distance(_from_points[from], goals[to]), from, to });
		}
	}
	std::sort(_door_pairs.begin(), _door_pairs.end());
	double best_length = std::numeric_limits<double>::max();
	for (const DoorPair &pair : _door_pairs) {
		if (double(pair.distance) >= best_length) {
			break;
		}
		way_between(_paths, _from_points[pair.from], goals[pair.to], _way);
		const double length = _way.empty() ? best_length : path_length(_way);
		if (length < best_length) {
			best_length = length;
			std::swap(_best_way, _way);
		}
	}
}

// The shortest way from there to any of `goals`; empty if none can be reached. Whoever is where nobody can walk, since the game put it there or the
// ground changed, first goes straight to the nearest point where people can. Holds until the next call.
const std::vector<glm::vec3> &Simulation::find_way(PersonId id, std::span<const glm::vec3> goals, std::span<const PersonId> companions) {
	find_starts(id, companions);
	find_shortest_way(goals);
	if (_best_way.empty() && !goals.empty() && is_outside(id)) {
		const glm::vec3 here = _from_points[0];
		if (_paths.nearest_walkable(here, _from_points[0]) && _from_points[0] != here) {
			find_shortest_way(goals);
			if (!_best_way.empty()) {
				_best_way.insert(_best_way.begin(), here);
			}
		}
	}
	return _best_way;
}

bool Simulation::go_to_building(PersonId id, BuildingId building, Purpose purpose) {
	find_doors(building, _to_points);
	const std::vector<glm::vec3> &path = find_way(id, _to_points);
	if (path.empty()) {
		emit(id, SimEventKind::Unreachable, target_of(building));
		return false;
	}
	const uint32_t walk = _walks.add(path, _now, _population.person(id).walking_speed, 1);
	set_out(id, walk, target_of(building), purpose);
	return true;
}

bool Simulation::go_to_point(PersonId id, Target goal, glm::vec3 point, Purpose purpose) {
	const std::vector<glm::vec3> &path = find_way(id, { &point, 1 });
	if (path.empty()) {
		emit(id, SimEventKind::Unreachable, goal);
		return false;
	}
	set_out(id, _walks.add(path, _now, _population.person(id).walking_speed, 1), goal, purpose);
	return true;
}

void Simulation::set_out(PersonId id, uint32_t walk, Target goal, Purpose purpose) {
	PersonRecord &person = record(id);
	if (person.reserved_object != PersonRecord::none && target_of(ObjectId(person.reserved_object)) != goal) {
		release_place(id);
	}
	if (person.state == PersonState::Inside) {
		leave_building(id, _walks[walk].points.front());
	} else if (person.state == PersonState::Walking) {
		stop_walk(id);
	} else {
		close_span(id);
	}
	person.state = PersonState::Walking;
	person.pose = AgentPose::Walk;
	person.walk = walk;
	person.first_metre = 0.0f;
	person.place_kind = goal.kind;
	person.place = goal.index;
	person.purpose = purpose;
	person.due = _walks[walk].arrival;
	show_walking(id);
	emit(id, SimEventKind::SetOut, goal);
}

// Where it is now, standing.
void Simulation::stop_walk(PersonId id) {
	PersonRecord &person = record(id);
	close_span(id);
	person.position = position(id);
	_walks.leave(person.walk);
	person.walk = WalkPool::none;
	person.due = never;
	person.state = PersonState::Waiting;
	person.pose = AgentPose::Stand;
	person.place_kind = Target::Kind::None;
	person.place = PersonRecord::none;
}

// The walk is over at its last point; the person is at its goal or goes in.
void Simulation::end_walk(PersonId id) {
	PersonRecord &person = record(id);
	const Target goal = person.target();
	stop_walk(id);
	_statistics.trips += _is_replaying ? 0 : 1;
	if (goal.kind == Target::Kind::Building) {
		return; // whoever ends the walk says whether it goes in
	}
	const bool is_place = goal.kind == Target::Kind::Zone || goal.kind == Target::Kind::Object;
	stand(id, is_place ? PersonState::AtPlace : PersonState::Waiting, is_place ? goal : Target{}, person.position);
	emit(id, SimEventKind::Arrived, goal);
}

void Simulation::arrive(PersonId id) {
	const Target goal = record(id).target();
	const Purpose purpose = record(id).purpose;
	if (purpose == Purpose::Pickup || purpose == Purpose::Group) {
		group_walk_ended(id, purpose);
		return;
	}
	end_walk(id);
	if (is_valid(goal.building())) {
		enter_building(id, goal.building(), record(id).position);
	}
	if (purpose == Purpose::Rule) {
		resume_rule(id);
	} else if (record(id).is_in_group()) {
		record(id).due = std::max(_now, record(id).entry_start + _settings.patience);
		lead_on(record(id).party);
	} else {
		note_lateness(id);
	}
}

void Simulation::leave_building(PersonId id, glm::vec3 door) {
	PersonRecord &person = record(id);
	close_span(id);
	const Target building = person.target();
	if (index_of(building.building()) < _inside_counts.size()) {
		--_inside_counts[building.index];
	}
	person.state = PersonState::Waiting;
	person.position = door;
	person.place_kind = Target::Kind::None;
	person.place = PersonRecord::none;
	change_outside(+1);
	if (has_bodies()) {
		_host->spawn_agent(id, door);
	}
	emit(id, SimEventKind::LeftBuilding, building);
}

void Simulation::enter_building(PersonId id, BuildingId building, glm::vec3 door) {
	PersonRecord &person = record(id);
	close_span(id);
	person.state = PersonState::Inside;
	person.pose = AgentPose::Stand;
	person.position = door;
	person.place_kind = Target::Kind::Building;
	person.place = index_of(building);
	++_inside_counts[index_of(building)];
	if (_last_entry != _now) {
		_last_entry = _now;
		_last_to_enter.clear();
	}
	_last_to_enter.push_back(id);
	change_outside(-1);
	if (has_bodies()) {
		_host->free_agent(id);
	}
	emit(id, SimEventKind::EnteredBuilding, target_of(building));
}

void Simulation::stand(PersonId id, PersonState state, Target place, glm::vec3 position) {
	PersonRecord &person = record(id);
	close_span(id);
	person.state = state;
	person.pose = AgentPose::Stand;
	person.position = position;
	person.place_kind = place.kind;
	person.place = place.index;
	show_standing(id);
}

// At its reserved place, from where goToObject led it.
void Simulation::use_place(PersonId id, AgentPose pose) {
	PersonRecord &person = record(id);
	const Target object = target_of(ObjectId(person.reserved_object));
	close_span(id);
	person.state = PersonState::AtPlace;
	person.pose = pose;
	person.place_kind = object.kind;
	person.place = object.index;
	show_standing(id);
	emit(id, SimEventKind::UsedObject, object);
}

bool Simulation::reserve_place(PersonId id, ObjectId object) {
	PersonRecord &person = record(id);
	if (person.reserved_object == index_of(object)) {
		return true;
	}
	release_place(id);
	const uint8_t place = _reservations.take(_city, object, id);
	if (place == Reservations::none) {
		emit(id, SimEventKind::NoFreePlace, target_of(object));
		return false;
	}
	person.reserved_object = index_of(object);
	person.object_place = place;
	return true;
}

void Simulation::release_place(PersonId id) {
	PersonRecord &person = record(id);
	if (person.reserved_object == PersonRecord::none) {
		return;
	}
	const ObjectId object = ObjectId(person.reserved_object);
	_reservations.release(object, person.object_place);
	person.reserved_object = PersonRecord::none;
	person.object_place = Reservations::none;
	if (person.state == PersonState::AtPlace && person.target() == target_of(object)) {
		emit(id, SimEventKind::LeftObject, target_of(object));
		stand(id, PersonState::Waiting, {}, person.position);
	}
}

} // namespace pcg
