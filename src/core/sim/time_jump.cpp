#include <algorithm>
#include <limits>

#include <glm/geometric.hpp>

#include "core/sim/behavior.h"
#include "core/sim/simulation.h"

// Time jumps (PCG language, section 8; paper, Algorithm 2). The paper interpolates one walk; here each household is put into the last moment
// at which all of its members were surely inside a building, with all of the day's floating tasks before them, and lives from there to the new
// time by the very same code as ever, so that walks, rules, seats and groups come out as they would have. Households do so one after the other:
// who comes later finds the seats taken.
namespace pcg {

namespace {
constexpr int anchor_tries = 64; // entries to look back, per household
constexpr Duration oldest_anchor = Duration::hours(48);
constexpr double detour = 1.5; // of streets against the straight line
}

void Simulation::jump_to(SimTime time) {
	if (!_has_started) {
		start(time);
		return;
	}
	const SimTime from = _now;
	flush_lived();
	hide_everybody();
	take_in_city_edits();
	place_everybody(time);
	for (SimulationObserver *observer : _observers) {
		observer->on_jump(from, time);
	}
	show_everybody();
}

void Simulation::forget_everything(SimTime begin) {
	for (PersonRecord &person : _persons) {
		if (person.behavior != PersonRecord::none) {
			_behaviors[person.behavior]->end();
			_free_behaviors.push_back(person.behavior);
		}
	}
	_statistics.outside = 0;
	for (PersonRecord &person : _persons) {
		PersonRecord anew;
		if (person.is_absent()) {
			anew.presence = person.presence;
			anew.position = person.position;
			anew.entry_end = never;
			anew.state = person.presence == Presence::Taken ? PersonState::Waiting : PersonState::Inside;
			_statistics.outside += person.presence == Presence::Taken ? 1 : 0;
		}
		person = anew;
	}
	_queue.clear(begin);
	_replay_queue.clear();
	_last_to_enter.clear();
	_walks.clear();
	_reservations.clear();
	_parties.clear();
	_free_parties.clear();
	std::fill(_party_of_group.begin(), _party_of_group.end(), PersonRecord::none);
	for (uint32_t i = 0; i < _persons.size(); ++i) { // what those did whom the game has, they did
		if (!_persons[i].is_absent()) {
			std::fill(_floating_taken.begin() + _agendas.first_floating_task[i], _floating_taken.begin() + _agendas.first_floating_task[i + 1], never_taken);
		}
	}
	std::fill(_inside_counts.begin(), _inside_counts.end(), 0);
}

void Simulation::place_everybody(SimTime time) {
	forget_everything(time);
	_ground_revision = _paths.ground_revision();
	_is_replaying = true;
	for (const Household &household : _population.households) {
		replay_household(household, time);
	}
	end_replay(time, 0);
}

// Persons from the first on were replayed: a life from `time` on begins for them.
void Simulation::end_replay(SimTime time, size_t first_person) {
	_is_replaying = false;
	_now = time;
	for (size_t i = first_person; i < _persons.size(); ++i) {
		PersonRecord &person = _persons[i];
		person.since = time;
		person.first_metre = person.walk == WalkPool::none ? 0.0f : float(_walks[person.walk].metres_at(time));
	}
	if (_statistics.outside > _statistics.peak_outside) {
		_statistics.peak_outside = _statistics.outside;
		_statistics.peak_time = time;
	}
}

void Simulation::replay_household(const Household &household, SimTime time) {
	const uint32_t first = index_of(household.first_member);
	if (household.member_count == 0 || first + household.member_count > _persons.size()) {
		return;
	}
	const SimTime anchor = find_anchor(household, time);
	_now = anchor;
	for (uint32_t i = 0; i < household.member_count; ++i) {
		if (!_persons[first + i].is_absent()) {
			put_inside(PersonId(first + i), anchor);
		}
	}
	for (Due due; _replay_queue.pop_until(time, due);) {
		run_due(due);
	}
	while (!_replay_queue.is_empty()) {
		const Due due = _replay_queue.pop();
		if (record(due.person).queued == due.time) {
			_queue.push(due);
		}
	}
}

// Where the entry leads, if it is a stay, a walk or a hole; Invalid for the others and for homes that are not there.
BuildingId Simulation::building_of(PersonId id, const PlannedEntry &entry) const {
	if (entry.is_hole()) {
		return home_of(id);
	}
	return is_stay(entry.kind) && entry.target < _city.buildings().size() ? BuildingId(entry.target) : BuildingId::Invalid;
}

// Whether the agenda has had the person in that building for so long that it surely is there.
bool Simulation::is_settled(PersonId id, SimTime time, BuildingId &building) const {
	PlannedEntry entry = plan_at(id, time);
	building = building_of(id, entry);
	const BuildingId home = home_of(id);
	if (!is_valid(building) || _city.building(building).is_removed || (building != home && !std::isfinite(_paths.distance(home, building)))) {
		return false;
	}
	while (time - entry.start < _settling) {
		entry = plan_at(id, entry.start - Duration{ 1 });
		if (building_of(id, entry) != building) {
			return false;
		}
	}
	return true;
}

// Whether nobody can have taken a floating task today that the person has left to do: it has had no slot yet. If not, `before` is when its first
// one began.
bool Simulation::is_pool_full(PersonId id, SimTime time, SimTime &before) const {
	const SimTime midnight = SimTime::at(time.day(), {});
	const std::span<const FloatingTask> pool = _agendas.floating_tasks_of(id);
	before = time;
	if (std::none_of(pool.begin(), pool.end(), [&](const FloatingTask &task) { return (task.days >> time.weekday()) & 1; })) {
		return true;
	}
	for (const SimTime day : { midnight - one_day, midnight }) { // a slot of yesterday may last until today
		for (const Task &task : _agendas.agenda_of(id).on(day.day())) {
			const bool is_slot = task.kind == TaskKind::FloatingSlot && ((task.days >> day.weekday()) & 1);
			if (is_slot && day + task.end() > midnight) {
				before = std::min(before, day + task.start());
			}
		}
	}
	return before == time;
}

SimTime Simulation::find_anchor(const Household &household, SimTime time) const {
	const uint32_t first = index_of(household.first_member);
	SimTime candidate = time;
	for (int i = 0; i < anchor_tries && time - candidate < oldest_anchor; ++i) {
		bool is_good = true;
		SimTime latest_start{ std::numeric_limits<int64_t>::min() };
		SimTime earliest_slot = candidate;
		for (uint32_t member = first; member < first + household.member_count; ++member) {
			if (_persons[member].is_absent()) {
				continue;
			}
			BuildingId building;
			SimTime slot;
			is_good = is_good && is_settled(PersonId(member), candidate, building);
			latest_start = std::max(latest_start, plan_at(PersonId(member), candidate).start);
			is_good = is_pool_full(PersonId(member), candidate, slot) && is_good;
			earliest_slot = std::min(earliest_slot, slot);
		}
		if (is_good) {
			return candidate;
		}
		candidate = std::min(latest_start, earliest_slot) - Duration{ 1 };
	}
	return time - one_day;
}

// Into the building that the agenda says; home where it says none. The entry goes on, or begins anew where it is a rule or the like.
void Simulation::put_inside(PersonId id, SimTime time) {
	PersonRecord &person = record(id);
	const PlannedEntry entry = plan_at(id, time);
	BuildingId building;
	const bool goes_on = is_settled(id, time, building);
	put_into(id, goes_on ? building : home_of(id));
	person.since = time;
	person.entry_start = entry.start;
	person.entry_end = goes_on ? entry.end : time;
	person.entry_task = entry.task;
	person.entry_kind = entry.kind;
	schedule(id);
}

// Before it where it was removed; into no building where there never was one.
void Simulation::put_into(PersonId id, BuildingId building) {
	PersonRecord &person = record(id);
	if (index_of(building) >= _city.buildings().size()) {
		return;
	}
	if (!_city.building(building).is_removed) {
		const EntranceId entrance = _city.entrance_of(building);
		person.place_kind = Target::Kind::Building;
		person.place = index_of(building);
		person.position = is_valid(entrance) ? _city.entrance(entrance).position : glm::vec3(0.0f);
		++_inside_counts[index_of(building)];
		return;
	}
	const std::vector<Entrance> &doors = _city.entrances();
	const auto door = std::find_if(doors.begin(), doors.end(), [building](const Entrance &entrance) { return entrance.building == building; });
	if (door != doors.end()) {
		person.state = PersonState::Waiting;
		person.position = door->position;
		change_outside(+1);
	}
}

Duration Simulation::longest_walk() const {
	glm::vec3 low{ std::numeric_limits<float>::max() };
	glm::vec3 high{ std::numeric_limits<float>::lowest() };
	for (const Entrance &entrance : _city.entrances()) {
		low = glm::min(low, entrance.position);
		high = glm::max(high, entrance.position);
	}
	float slowest = 10.0f;
	for (const Person &person : _population.persons) {
		slowest = std::min(slowest, person.walking_speed);
	}
	const double diagonal = _city.entrances().empty() ? 0.0 : double(glm::distance(low, high));
	return Duration::seconds(diagonal * detour / double(slowest)) + _settings.patience;
}

} // namespace pcg
