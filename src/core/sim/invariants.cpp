#include "core/sim/invariants.h"

#include <algorithm>
#include <limits>

#include <glm/geometric.hpp>

namespace pcg {

namespace {

constexpr double zone_margin = 2.0; // metres from a zone's outline that still count as at it
constexpr size_t example_limit = 20;

double distance_to_segment(glm::vec3 point, glm::vec3 a, glm::vec3 b) {
	const glm::vec3 along = b - a;
	const float length = glm::dot(along, along);
	const float share = length > 0.0f ? std::clamp(glm::dot(point - a, along) / length, 0.0f, 1.0f) : 0.0f;
	return double(glm::distance(point, a + along * share));
}

bool is_in_zone(const Zone &zone, glm::vec3 point) {
	bool is_inside = false;
	double nearest = 1e30;
	for (size_t i = 0, j = zone.polygon.size() - 1; i < zone.polygon.size(); j = i++) {
		glm::vec3 a = zone.polygon[i];
		glm::vec3 b = zone.polygon[j];
		a.y = b.y = point.y;
		nearest = std::min(nearest, distance_to_segment(point, a, b));
		if ((a.z > point.z) != (b.z > point.z) && point.x < (b.x - a.x) * (point.z - a.z) / (b.z - a.z) + a.x) {
			is_inside = !is_inside;
		}
	}
	return is_inside || nearest <= zone_margin;
}

} // namespace

std::string_view promise_name(Promise promise) {
	switch (promise) {
		case Promise::NoTeleport:
			return "teleports";
		case Promise::NoWalkToNowhere:
			return "walks_to_nowhere";
		case Promise::NoDoubleSeat:
			return "double_seats";
		case Promise::NoTwoPlaces:
			return "in_two_places";
		case Promise::NoChildAlone:
			return "children_alone";
		case Promise::DayCovered:
			return "days_with_gaps";
		case Promise::RightBuilding:
			return "wrong_buildings";
	}
	return "";
}

InvariantChecker::InvariantChecker(Simulation &simulation) : _simulation(simulation), _lives(simulation.person_count()) {
	simulation.add_observer(*this);
}

InvariantChecker::~InvariantChecker() { _simulation.remove_observer(*this); }

uint64_t InvariantChecker::broken_total() const {
	uint64_t sum = 0;
	for (uint64_t count : _broken) {
		sum += count;
	}
	return sum;
}

void InvariantChecker::complain(Promise promise, PersonId id, SimTime time, std::string text) {
	++_broken[size_t(promise)];
	if (_examples.size() < example_limit) {
		_examples.push_back(std::string(promise_name(promise)) + ": person " + number_text(_simulation.settings().numbers.persons, id) +
				", day " + std::to_string(time.day()) + ", " + clock_text(time.time_of_day(), true) + ": " + text);
	}
}

void InvariantChecker::begin_life(SimTime time) {
	_is_alive = true;
	_life_start = time;
	for (uint32_t i = 0; i < _lives.size(); ++i) {
		begin_life_of(PersonId(i), time);
	}
}

void InvariantChecker::begin_life_of(PersonId id, SimTime time) {
	const PersonView view = _simulation.view(id);
	Life &known = life(id);
	known = Life();
	known.span_end = time;
	known.span_position = view.position;
	known.span_state = view.state;
	known.inside = view.state == PersonState::Inside ? view.place.building() : BuildingId::Invalid;
	known.span_building = known.inside;
	known.is_taken = view.presence == Presence::Taken;
	known.is_gone = view.presence == Presence::Removed;
	known.begin = known.set_out = time;
	if (view.state == PersonState::Walking) {
		known.set_out = view.arrival - Duration::seconds(path_length(view.path) / double(view.speed));
		known.walks_alone = !is_valid(view.leader) || known.set_out < view.entry.start;
	}
}

// Who comes, goes, or is the game's for a while.
void InvariantChecker::note_presence(const SimEvent &event) {
	switch (event.kind) {
		case SimEventKind::Added:
			_lives.resize(std::max<size_t>(_lives.size(), size_t(index_of(event.person)) + 1));
			begin_life_of(event.person, event.time);
			break;
		case SimEventKind::Removed:
			life(event.person).is_gone = true;
			life(event.person).inside = BuildingId::Invalid;
			break;
		case SimEventKind::TakenOver:
			life(event.person).is_taken = true;
			break;
		case SimEventKind::Released:
			life(event.person).is_taken = false;
			life(event.person).span_position = event.position;
			life(event.person).seen_time = never;
			break;
		default:
			break;
	}
}

void InvariantChecker::on_jump(SimTime, SimTime to) { begin_life(to); }

void InvariantChecker::on_event(const SimEvent &event) {
	if (!_is_alive) {
		return;
	}
	note_presence(event);
	Life &known = life(event.person);
	switch (event.kind) {
		case SimEventKind::Unreachable:
			known.without_way = event.time;
			break;
		case SimEventKind::GoalChanged:
			known.goal_changed = event.time;
			break;
		case SimEventKind::PatienceRanOut:
			known.gave_up_waiting = event.time;
			known.missed_goal = event.place;
			break;
		case SimEventKind::EnteredBuilding:
			if (is_valid(known.inside)) {
				complain(Promise::NoTwoPlaces, event.person, event.time, "enters a building while inside another");
			}
			known.inside = event.place.building();
			break;
		case SimEventKind::LeftBuilding:
			if (known.inside != event.place.building()) {
				complain(Promise::NoTwoPlaces, event.person, event.time, "leaves a building that it is not in");
			}
			known.inside = BuildingId::Invalid;
			known.left_by = event.position;
			check_door(event);
			break;
		case SimEventKind::SetOut:
			note_walk_begin(event);
			check_walk(event);
			break;
		default:
			break;
	}
}

void InvariantChecker::check_door(const SimEvent &event) {
	if (!is_near_door(event.place.building(), event.position, tolerance) &&
			double(glm::distance(event.position, life(event.person).span_position)) > tolerance) {
		complain(Promise::NoTeleport, event.person, event.time, "leaves a building where it has no door");
	}
}

void InvariantChecker::check_walk(const SimEvent &event) {
	const PersonView view = _simulation.view(event.person);
	if (view.path.size() < 2 || view.state != PersonState::Walking) {
		complain(Promise::NoWalkToNowhere, event.person, event.time, "sets out without a path");
	} else if (!ends_at(event.place, view.path.back())) {
		complain(Promise::NoWalkToNowhere, event.person, event.time, "sets out on a path that does not end at its goal");
	}
}

bool InvariantChecker::ends_at(const Target &goal, glm::vec3 end) const {
	const CityModel &city = _simulation.city();
	switch (goal.kind) {
		case Target::Kind::Building:
			return goal.index < city.buildings().size() && is_near_door(goal.building(), end, tolerance);
		case Target::Kind::Zone:
			return goal.index < city.zones().size() && is_in_zone(city.zone(goal.zone()), end);
		case Target::Kind::Object: {
			if (goal.index >= city.objects().size()) {
				return false;
			}
			const std::vector<Place> &places = city.object(goal.object()).places;
			return std::any_of(places.begin(), places.end(), [&](const Place &place) {
				return double(glm::distance(place.position, end)) <= tolerance;
			});
		}
		case Target::Kind::Person:
			return goal.index < _lives.size();
		case Target::Kind::None:
			return false;
	}
	return false;
}

bool InvariantChecker::is_near_door(BuildingId building, glm::vec3 position, double metres) const {
	const CityModel &city = _simulation.city();
	if (index_of(building) >= city.buildings().size()) {
		return false;
	}
	const std::vector<EntranceId> &doors = city.building(building).entrances;
	return std::any_of(doors.begin(), doors.end(), [&](EntranceId door) {
		return double(glm::distance(city.entrance(door).position, position)) <= metres;
	});
}

void InvariantChecker::on_lived(const LivedSpan &span) {
	if (!_is_alive) {
		return;
	}
	Life &known = life(span.person);
	if (span.start != known.span_end) {
		complain(Promise::DayCovered, span.person, span.start, "a gap in its life");
	}
	if (!known.is_taken) {
		check_continuity(span, known);
	}
	if (span.state == PersonState::Walking) {
		note_child(span);
	}
	known.span_end = span.end;
	known.span_position = span.position;
	known.span_state = span.state;
	known.span_building = span.state == PersonState::Inside ? span.place.building() : BuildingId::Invalid;
}

// From the end of the span before to the start of this one no time passes, so there must be no way between; inside a building any of its doors
// may be next.
void InvariantChecker::check_continuity(const LivedSpan &span, Life &known) {
	const bool walks = span.state == PersonState::Walking;
	const glm::vec3 start = walks ? point_along(span.path, span.first_metre) : span.position;
	if (span.start > _life_start && known.span_end == span.start) {
		const bool came_from_inside = known.span_state == PersonState::Inside;
		const bool stays_inside = came_from_inside && span.state == PersonState::Inside && known.span_building == span.place.building();
		const bool is_there = double(glm::distance(start, known.span_position)) <= tolerance || stays_inside ||
				(came_from_inside && double(glm::distance(start, known.left_by)) <= tolerance);
		if (!is_there) {
			complain(Promise::NoTeleport, span.person, span.start, "appears elsewhere");
		}
	}
	const double speed = double(_simulation.population().person(span.person).walking_speed);
	if (walks && double(glm::distance(start, span.position)) > (span.end - span.start).in_seconds() * speed + tolerance) {
		complain(Promise::NoTeleport, span.person, span.end, "walks faster than it can");
	}
}

} // namespace pcg
