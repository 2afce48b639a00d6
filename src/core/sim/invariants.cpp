#include "core/sim/invariants.h"

#include <algorithm>
#include <limits>

#include <glm/geometric.hpp>

namespace pcg {

namespace {

constexpr double tolerance = 0.02; // metres: positions are floats, times whole milliseconds
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
	_leaders_walks.clear();
	_childrens_walks.clear();
	for (uint32_t i = 0; i < _lives.size(); ++i) {
		begin_life_of(PersonId(i), time);
	}
}

void InvariantChecker::begin_life_of(PersonId id, SimTime time) {
	const PersonView view = _simulation.view(id);
	Life &known = life(id);
	known = Life();
	known.span_end = time;
	known.set_out = SimTime{ std::numeric_limits<int64_t>::min() }; // not known of walks in progress
	known.span_position = view.position;
	known.span_state = view.state;
	known.inside = view.state == PersonState::Inside ? view.place.building() : BuildingId::Invalid;
	known.span_building = known.inside;
	known.is_taken = view.presence == Presence::Taken;
	known.is_gone = view.presence == Presence::Removed;
	known.is_stuck = true; // whether it was told so before is not known; until its next entry
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
			life(event.person).released = event.time;
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
		case SimEventKind::TaskStarted:
			known.is_stuck = false;
			break;
		case SimEventKind::Unreachable:
		case SimEventKind::GoalChanged: // perhaps its building is gone
			known.is_stuck = true;
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
			if (!is_near_door(event.place.building(), event.position, tolerance) &&
					double(glm::distance(event.position, known.span_position)) > tolerance) {
				complain(Promise::NoTeleport, event.person, event.time, "leaves a building where it has no door");
			}
			break;
		case SimEventKind::SetOut:
			known.set_out = event.time;
			check_walk(event);
			break;
		default:
			break;
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
	note_group_walk(span);
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

void InvariantChecker::note_group_walk(const LivedSpan &span) {
	if (span.state != PersonState::Walking || span.entry.kind != TaskKind::Accompany || span.entry.is_hole() ||
			span.entry.target >= _simulation.agendas().groups.size()) {
		return;
	}
	const Group &group = _simulation.agendas().groups[span.entry.target];
	const GroupWalk walk{ span.person, group.leader, span.start, span.end, span.position };
	if (span.person == group.leader) {
		_leaders_walks.push_back(walk);
		return;
	}
	const bool is_child = _simulation.population().person(span.person).age < 18.0f;
	const bool is_own_walk = life(span.person).set_out < span.entry.start; // to the same building, begun before the group's time
	const Life &leader = life(group.leader);
	const Life &child = life(span.person);
	const bool was_led_away = leader.is_taken || leader.is_gone || child.set_out < leader.released; // by the game
	const bool was_away = child.is_taken || child.is_gone || child.released >= span.entry.start;
	if (is_child && span.place == target_of(group.goal) && !is_own_walk && !was_led_away && !was_away) {
		_childrens_walks.push_back(walk);
	}
}

void InvariantChecker::check_children() {
	for (const GroupWalk &walk : _childrens_walks) {
		const bool is_with_leader =
				std::any_of(_leaders_walks.begin(), _leaders_walks.end(), [&](const GroupWalk &leaders) {
					return leaders.person == walk.leader && leaders.start <= walk.start && leaders.end >= walk.end &&
							double(glm::distance(leaders.position, walk.position)) <= tolerance;
				});
		if (!is_with_leader) {
			complain(Promise::NoChildAlone, walk.person, walk.start, "walks to the group's goal without the leader");
		}
	}
	_childrens_walks.clear();
	_leaders_walks.clear();
}

void InvariantChecker::check() {
	for (uint32_t i = 0; i < _lives.size(); ++i) {
		const PersonView view = _simulation.view(PersonId(i));
		if (_lives[i].is_gone || _lives[i].is_taken) {
			continue;
		}
		check_position(PersonId(i), view);
		check_building(PersonId(i), view);
	}
	check_seats();
	check_counts();
	check_children();
}

void InvariantChecker::check_position(PersonId id, const PersonView &view) {
	Life &known = life(id);
	const SimTime now = _simulation.now();
	const double speed = double(_simulation.population().person(id).walking_speed);
	const BuildingId inside = view.state == PersonState::Inside ? view.place.building() : BuildingId::Invalid;
	if (known.seen_time != never) {
		const double reach = (now - known.seen_time).in_seconds() * speed + tolerance;
		const bool is_near = double(glm::distance(view.position, known.seen_position)) <= reach;
		const bool by_door = (is_valid(known.seen_building) && is_near_door(known.seen_building, view.position, reach)) ||
				(is_valid(inside) && is_near_door(inside, known.seen_position, reach));
		const bool both_inside = is_valid(inside) && is_valid(known.seen_building);
		if (!is_near && !by_door && !(both_inside && inside == known.seen_building)) {
			complain(Promise::NoTeleport, id, now, "is further from where it was than it can walk");
		}
	}
	if (known.inside != inside) {
		complain(Promise::NoTwoPlaces, id, now, "is not where it was seen going in");
	}
	known.seen_position = view.position;
	known.seen_time = now;
	known.seen_state = view.state;
	known.seen_building = inside;
}

void InvariantChecker::check_building(PersonId id, const PersonView &view) {
	const PlannedEntry entry = _simulation.plan_at(id, _simulation.now());
	const bool is_stay = entry.kind == TaskKind::StayInside || entry.kind == TaskKind::GoToBuilding;
	const bool is_with_late_group = is_valid(view.leader);
	if (!is_stay || life(id).is_stuck || is_with_late_group) {
		return;
	}
	const BuildingId wanted = entry.is_hole() ? _simulation.population().home_of(id) : BuildingId(entry.target);
	const bool is_there_or_coming = (view.state == PersonState::Inside || view.state == PersonState::Walking) &&
			view.place.building() == wanted;
	if (!is_there_or_coming) {
		complain(Promise::RightBuilding, id, _simulation.now(),
				"should be inside building " + std::to_string(index_of(wanted)) + " or on the way there");
	}
}

void InvariantChecker::check_seats() {
	struct Seat {
		uint32_t object, place, person;
		auto operator<=>(const Seat &) const = default;
	};
	std::vector<Seat> seats;
	for (uint32_t i = 0; i < _lives.size(); ++i) {
		const PersonView view = _simulation.view(PersonId(i));
		if (view.state == PersonState::AtPlace && is_valid(view.place.object())) {
			seats.push_back({ view.place.index, view.object_place, i });
		}
	}
	std::sort(seats.begin(), seats.end());
	for (size_t i = 1; i < seats.size(); ++i) {
		const glm::vec3 a = _simulation.position(PersonId(seats[i - 1].person));
		const glm::vec3 b = _simulation.position(PersonId(seats[i].person));
		const bool is_same_object = seats[i].object == seats[i - 1].object;
		if (is_same_object && (seats[i].place == seats[i - 1].place || double(glm::distance(a, b)) <= tolerance)) {
			complain(Promise::NoDoubleSeat, PersonId(seats[i].person), _simulation.now(),
					"shares a place with person " + number_text(_simulation.settings().numbers.persons, PersonId(seats[i - 1].person)));
		}
	}
}

void InvariantChecker::check_counts() {
	std::vector<uint32_t> counts(_simulation.city().buildings().size());
	for (const Life &known : _lives) {
		if (index_of(known.inside) < counts.size()) {
			++counts[index_of(known.inside)];
		}
	}
	for (uint32_t i = 0; i < counts.size(); ++i) {
		if (counts[i] != _simulation.inside_count(BuildingId(i))) {
			complain(Promise::RightBuilding, PersonId::Invalid, _simulation.now(),
					"building " + std::to_string(i) + " does not count who went in and out");
		}
	}
}

void InvariantChecker::finish() {
	check();
	for (uint32_t i = 0; i < _lives.size(); ++i) {
		if (_lives[i].span_end != _simulation.now() && !_lives[i].is_gone) {
			complain(Promise::DayCovered, PersonId(i), _simulation.now(), "its life was told only in part");
		}
	}
}

} // namespace pcg
