#include "core/sim/simulation.h"

#include <algorithm>

#include "core/agenda/context.h"
#include "core/sim/behavior.h"

namespace pcg {

Simulation::Simulation(const CityModel &city, const PathProvider &paths, const Population &population,
		const AgendaSet &agendas, std::shared_ptr<const Program> program, SimulationSettings settings, AgentHost &host)
	: _city(city), _paths(paths), _population(population), _agendas(agendas), _program(std::move(program)),
	  _settings(std::move(settings)), _host(&host) {
	make_room();
	_city_revision = city.revision() - 1;
	_ground_revision = paths.ground_revision();
	take_in_city_edits();
}

Simulation::~Simulation() = default;

// For everybody in the population and all that the agendas have.
void Simulation::make_room() {
	_persons.resize(std::min(_population.persons.size(), _agendas.person_count()));
	_party_of_group.resize(_agendas.groups.size(), PersonRecord::none);
	_floating_taken.resize(_agendas.floating_tasks.size(), never_taken);
}

void Simulation::start(SimTime time) {
	if (_has_started) {
		jump_to(time);
		return;
	}
	_has_started = true;
	take_in_city_edits();
	place_everybody(time);
	for (SimulationObserver *observer : _observers) {
		observer->on_jump(time, time);
	}
	show_everybody();
}

void Simulation::advance_to(SimTime time) {
	if (!_has_started || time < _now) {
		return;
	}
	if (take_in_city_edits()) {
		mend_goals();
	}
	if (_ground_revision != _paths.ground_revision()) {
		mend_ways();
	}
	for (Due due; _queue.pop_until(time, due);) {
		run_due(due);
	}
	_now = time;
}

void Simulation::run_due(const Due &due) {
	PersonRecord &person = record(due.person);
	if (person.queued != due.time) {
		return; // it was planned anew since
	}
	person.queued = never;
	_now = due.time;
	_statistics.handled_moments += _is_replaying ? 0 : 1;
	wake(due.person);
}

// In this order: what the person did is over, then its rule's time, then the entry's.
void Simulation::wake(PersonId id) {
	if (record(id).due <= _now) {
		on_due(id);
	}
	if (record(id).behavior != PersonRecord::none && record(id).rule_end <= _now && record(id).entry_end > _now) {
		end_rule(id, SimEventKind::RuleCut);
	}
	if (record(id).entry_end <= _now && !record(id).is_in_group()) {
		begin_entry(id);
	}
	schedule(id);
}

void Simulation::on_due(PersonId id) {
	PersonRecord &person = record(id);
	person.due = never;
	if (person.state == PersonState::Walking) {
		arrive(id);
	} else if (person.is_in_group()) {
		lose_patience(id);
	} else if (person.behavior != PersonRecord::none) {
		resume_rule(id);
	} else {
		try_again(id);
	}
}

void Simulation::schedule(PersonId id) {
	PersonRecord &person = record(id);
	SimTime next = person.due;
	if (person.behavior != PersonRecord::none) {
		next = std::min(next, person.rule_end);
	}
	if (!person.is_in_group()) {
		next = std::min(next, person.entry_end);
	}
	const bool is_new = next != person.queued && next != never;
	person.queued = next;
	if (is_new && _is_replaying) {
		_replay_queue.push({ next, id });
	} else if (is_new) {
		_queue.push({ next, id });
	}
}

// Whether there were any.
bool Simulation::take_in_city_edits() {
	if (_city_revision == _city.revision()) {
		return false;
	}
	_city_revision = _city.revision();
	_reservations.update(_city);
	_inside_counts.resize(_city.buildings().size());
	_settling = longest_walk();
	if (_program) {
		if (!_rule_world) {
			_rule_world = std::make_unique<agenda::World>();
		}
		*_rule_world = agenda::make_world(*_program, _city, _paths, _population, _settings.numbers); // in place: behaviors point to it
	}
	return true;
}

glm::vec3 Simulation::position(PersonId id) const {
	const PersonRecord &person = record(id);
	return person.state == PersonState::Walking ? _walks[person.walk].position_at(_now) : person.position;
}

PersonView Simulation::view(PersonId id) const {
	const PersonRecord &person = record(id);
	PersonView result;
	result.state = person.state;
	result.place = person.target();
	result.pose = person.pose;
	result.position = person.position;
	result.since = person.since;
	result.entry = entry_of(id);
	result.presence = person.presence;
	if (person.is_in_group()) {
		result.leader = _parties[person.party].leader;
	}
	if (person.state == PersonState::Walking) {
		const Walk &walk = _walks[person.walk];
		result.position = point_along(walk.points, walk.metres_at(_now), &result.facing);
		result.arrival = walk.arrival;
		result.speed = walk.speed;
		result.path = walk.points;
	} else if (person.state == PersonState::AtPlace && person.object_place != Reservations::none) {
		const std::vector<Place> &places = _city.object(ObjectId(person.reserved_object)).places;
		result.object_place = person.object_place;
		result.facing = person.object_place < places.size() ? places[person.object_place].facing : result.facing; // it may be gone since
	}
	return result;
}

bool Simulation::is_stranded(PersonId id) const {
	const PersonRecord &person = record(id);
	return person.state == PersonState::Waiting && !person.is_absent() && person.is_on_its_own();
}

uint32_t Simulation::inside_count(BuildingId building) const {
	return index_of(building) < _inside_counts.size() ? _inside_counts[index_of(building)] : 0;
}

std::vector<PersonId> Simulation::persons_inside(BuildingId building) const {
	std::vector<PersonId> result;
	for (uint32_t i = 0; i < _persons.size(); ++i) {
		if (_persons[i].state == PersonState::Inside && _persons[i].target().building() == building) {
			result.push_back(PersonId(i));
		}
	}
	return result;
}

std::vector<PersonId> Simulation::persons_outside() const {
	std::vector<PersonId> result;
	for (uint32_t i = 0; i < _persons.size(); ++i) {
		if (_persons[i].state != PersonState::Inside) {
			result.push_back(PersonId(i));
		}
	}
	return result;
}

void Simulation::remove_observer(SimulationObserver &observer) { std::erase(_observers, &observer); }

} // namespace pcg
