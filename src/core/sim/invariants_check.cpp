#include <algorithm>

#include <glm/geometric.hpp>

#include "core/sim/invariants.h"

// What is looked at now and then: everybody, where they are at one moment.
namespace pcg {

void InvariantChecker::check() {
	const bool knows_city = _simulation.knows_city(); // else it is not to blame
	for (uint32_t i = 0; i < _lives.size(); ++i) {
		const PersonView view = _simulation.view(PersonId(i));
		if (_lives[i].is_gone || _lives[i].is_taken) {
			continue;
		}
		check_position(PersonId(i), view);
		if (view.state == PersonState::Walking) {
			check_child(PersonId(i), view.leader, view.position, _simulation.now());
		}
		if (knows_city) {
			check_building(PersonId(i), view);
		}
	}
	check_seats();
	if (knows_city) {
		check_holders();
	}
	check_counts();
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
	known.seen_building = inside;
}

void InvariantChecker::check_building(PersonId id, const PersonView &view) {
	const CityModel &city = _simulation.city();
	const SimTime now = _simulation.now();
	const BuildingId inside = view.state == PersonState::Inside ? view.place.building() : BuildingId::Invalid;
	if (is_valid(inside) && city.building(inside).is_removed) {
		complain(Promise::RightBuilding, id, now, "is inside building " + number_text(_simulation.settings().numbers.buildings, inside) + ", which is gone");
	}
	const PlannedEntry entry = _simulation.plan_at(id, now);
	const bool is_with_late_group = is_valid(view.leader);
	if (!is_stay(entry.kind) || is_with_late_group) {
		return;
	}
	const BuildingId wanted = entry.is_hole() ? _simulation.population().home_of(id) : BuildingId(entry.target);
	const bool is_there_or_coming = (view.state == PersonState::Inside || view.state == PersonState::Walking) &&
			view.place.building() == wanted;
	if (is_there_or_coming) {
		return;
	}
	Life &known = life(id);
	if (!has_way(view, wanted)) {
		known.without_way = now;
	} else if (known.without_way + retry_pause < now) {
		complain(Promise::RightBuilding, id, now, "should be inside building " + number_text(_simulation.settings().numbers.buildings, wanted) + " or on the way there");
	}
}

// From where somebody is, through any door of the building that it is in, to any door of the other.
bool InvariantChecker::has_way(const PersonView &from, BuildingId to) const {
	const CityModel &city = _simulation.city();
	const PathProvider &paths = _simulation.paths();
	const auto doors_of = [&city](BuildingId building) {
		std::vector<glm::vec3> doors;
		if (index_of(building) < city.buildings().size()) {
			for (EntranceId door : city.building(building).entrances) {
				doors.push_back(city.entrance(door).position);
			}
		}
		return doors;
	};
	std::vector<glm::vec3> starts{ from.position };
	glm::vec3 ground{ 0.0f };
	if (from.state == PersonState::Inside) {
		starts = doors_of(from.place.building());
	} else if (paths.nearest_walkable(from.position, ground)) {
		starts.push_back(ground);
	}
	const std::vector<glm::vec3> goals = doors_of(to);
	return std::any_of(starts.begin(), starts.end(), [&](glm::vec3 start) {
		return std::any_of(goals.begin(), goals.end(), [&](glm::vec3 goal) { return start == goal || !paths.path(start, goal).empty(); });
	});
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

// Whoever uses a place has it, and whoever has one uses it or is on the way.
void InvariantChecker::check_holders() {
	const std::vector<CityObject> &objects = _simulation.city().objects();
	const SimTime now = _simulation.now();
	for (uint32_t i = 0; i < objects.size(); ++i) {
		for (size_t place = 0; place < std::min<size_t>(objects[i].places.size(), Reservations::none); ++place) {
			const PersonId holder = _simulation.place_holder(ObjectId(i), uint8_t(place));
			if (!is_valid(holder)) {
				continue;
			}
			const PersonView view = _simulation.view(holder);
			const bool is_at_it = view.state == PersonState::AtPlace && view.object_place == place;
			if (view.place != target_of(ObjectId(i)) || !(is_at_it || view.state == PersonState::Walking)) {
				complain(Promise::NoDoubleSeat, holder, now, "holds a place of object " + std::to_string(i) + " and is not there");
			}
		}
	}
	for (uint32_t i = 0; i < _lives.size(); ++i) {
		const PersonView view = _simulation.view(PersonId(i));
		const bool is_at_object = view.state == PersonState::AtPlace && is_valid(view.place.object());
		if (is_at_object && (view.object_place >= objects[view.place.index].places.size() ||
									_simulation.place_holder(view.place.object(), view.object_place) != PersonId(i))) {
			complain(Promise::NoDoubleSeat, PersonId(i), now, "is at a place that it does not hold");
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
					"building " + number_text(_simulation.settings().numbers.buildings, BuildingId(i)) + " does not count who went in and out");
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
