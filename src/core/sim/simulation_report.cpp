#include <algorithm>

#include <glm/geometric.hpp>

#include "core/agenda/context.h"
#include "core/sim/simulation.h"

// What a simulation tells: events and spans to observers, bodies to the host.
namespace pcg {

void Simulation::emit(PersonId id, SimEventKind kind, Target place) {
	if (_is_replaying) {
		return;
	}
	++_statistics.events[size_t(kind)];
	if (_observers.empty()) {
		return;
	}
	const SimEvent event{ _now, id, kind, place, position(id) };
	for (SimulationObserver *observer : _observers) {
		observer->on_event(event);
	}
}

void Simulation::note(Diagnostic diagnostic) {
	const std::vector<Diagnostic> &told = _diagnostics.list();
	if (std::none_of(told.begin(), told.end(), [&](const Diagnostic &other) { return agenda::is_repeat(other, diagnostic); })) {
		_diagnostics.add(std::move(diagnostic));
	}
}

void Simulation::close_span(PersonId id) {
	PersonRecord &person = record(id);
	const SimTime start = person.since;
	const float first_metre = person.first_metre;
	person.since = _now;
	person.first_metre = person.walk == WalkPool::none ? 0.0f : float(_walks[person.walk].metres_at(_now));
	if (_is_replaying || _observers.empty() || start >= _now || person.presence == Presence::Removed) {
		return;
	}
	LivedSpan span;
	span.person = id;
	span.start = start;
	span.end = _now;
	span.state = person.state;
	span.place = person.target();
	span.position = position(id);
	span.entry = entry_of(id);
	span.leader = person.is_in_group() ? _parties[person.party].leader : PersonId::Invalid;
	if (person.walk != WalkPool::none) {
		span.path = _walks[person.walk].points;
		span.first_metre = double(first_metre);
		span.last_metre = double(person.first_metre);
	}
	for (SimulationObserver *observer : _observers) {
		observer->on_lived(span);
	}
}

void Simulation::flush_lived() {
	for (uint32_t i = 0; i < _persons.size(); ++i) {
		close_span(PersonId(i));
	}
}

void Simulation::change_outside(int change) {
	_statistics.outside = uint32_t(int64_t(_statistics.outside) + change);
	if (!_is_replaying && _statistics.outside > _statistics.peak_outside) {
		_statistics.peak_outside = _statistics.outside;
		_statistics.peak_time = _now;
	}
}

void Simulation::show_standing(PersonId id) {
	if (has_bodies()) {
		const PersonView person = view(id);
		_host->place_agent(id, person.position, person.facing, person.pose);
	}
}

void Simulation::show_walking(PersonId id) {
	if (!has_bodies()) {
		return;
	}
	const Walk &walk = _walks[record(id).walk];
	if (walk.departure == _now) {
		_host->walk_agent(id, walk.points, walk.speed);
		return;
	}
	rest_of(walk, _now, _way);
	_host->walk_agent(id, _way, walk.speed);
}

void Simulation::show_everybody() {
	for (uint32_t i = 0; i < _persons.size() && has_bodies(); ++i) {
		const PersonId id = PersonId(i);
		if (is_outside(id) && !_persons[i].is_absent()) {
			show_person(id);
		}
	}
}

// Outdoors, with a new body.
void Simulation::show_person(PersonId id) {
	if (has_bodies()) {
		_host->spawn_agent(id, position(id));
		state(id) == PersonState::Walking ? show_walking(id) : show_standing(id);
	}
}

void Simulation::hide_everybody() {
	for (uint32_t i = 0; i < _persons.size() && has_bodies(); ++i) {
		if (is_outside(PersonId(i)) && !_persons[i].is_absent()) {
			_host->free_agent(PersonId(i));
		}
	}
}

} // namespace pcg
