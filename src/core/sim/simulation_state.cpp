#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "core/sim/behavior.h"
#include "core/sim/saved_state.h"
#include "core/sim/simulation.h"

// Saving and loading. A state may come from a file that somebody damaged: everything that the simulation trusts is checked before anything changes.
namespace pcg {

namespace {

constexpr uint32_t none = PersonRecord::none;

bool is_finite(glm::vec3 point) { return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z); }

// The new number of an index that is in use, in order of first use.
class Renumbering {
public:
	uint32_t operator()(uint32_t index, const auto &add) {
		if (index == none) {
			return none;
		}
		const auto [found, is_new] = _numbers.try_emplace(index, uint32_t(_numbers.size()));
		if (is_new) {
			add(index);
		}
		return found->second;
	}

private:
	std::unordered_map<uint32_t, uint32_t> _numbers;
};

} // namespace

std::string Simulation::save() const {
	SavedState state;
	state.program_fingerprint = _program ? _program->fingerprint : 0;
	state.seed = _settings.seed;
	state.attributes = _settings.overrides;
	state.patience = _settings.patience;
	state.city_origin = _city.origin;
	state.buildings = _city.buildings().size();
	state.zones = _city.zones().size();
	state.objects = _city.objects().size();
	state.now = _now;
	state.statistics = _statistics;
	state.persons = _persons;
	state.floating_taken = _floating_taken;
	Renumbering walks, behaviors, parties;
	for (PersonRecord &person : state.persons) {
		person.walk = walks(person.walk, [&](uint32_t index) { state.walks.push_back(_walks[index]); });
		person.behavior = behaviors(person.behavior, [&](uint32_t index) { state.behaviors.push_back(_behaviors[index]->save()); });
		person.party = parties(person.party, [&](uint32_t index) { state.parties.push_back(_parties[index]); });
	}
	return state_to_bytes(state);
}

bool Simulation::restore(std::string_view bytes, Diagnostics &diagnostics) {
	const auto refuse = [&](std::string message, std::string hint) {
		diagnostics.error("bad-state", std::move(message), std::move(hint));
		return false;
	};
	take_in_city_edits();
	SavedState state;
	if (!state_from_bytes(bytes, state)) {
		return refuse("the saved state is damaged", "load another one");
	}
	if (state.program_fingerprint != (_program ? _program->fingerprint : 0)) {
		return refuse("the state was saved with other rules", "load it with the rule file that it was saved with");
	}
	if (state.city_origin != _city.origin) {
		return refuse("the state was saved in another city", "generate the city with the layout and the seed that it was saved with");
	}
	if (state.buildings > _city.buildings().size() || state.zones > _city.zones().size() || state.objects > _city.objects().size()) {
		return refuse("parts of the city that the state was saved in are missing", "load it in the city that it was saved in, with all that was added by hand");
	}
	std::vector<std::unique_ptr<Behavior>> behaviors;
	if (!is_sound(state) || !wake_behaviors(state, behaviors)) {
		return refuse("the saved state contradicts itself, its people or the city", "load it with the people and the city that it was saved with");
	}
	const SimTime from = _has_started ? _now : state.now;
	if (_has_started) {
		flush_lived();
		hide_everybody();
	}
	take_over_state(std::move(state), std::move(behaviors));
	for (SimulationObserver *observer : _observers) {
		observer->on_jump(from, _now);
	}
	show_everybody();
	return true;
}

bool Simulation::wake_behaviors(const SavedState &state, std::vector<std::unique_ptr<Behavior>> &behaviors) {
	SimulationSettings settings = _settings;
	settings.seed = state.seed;
	settings.overrides = state.attributes;
	for (const SavedBehavior &saved : state.behaviors) {
		behaviors.push_back(std::make_unique<Behavior>(*this, *_rule_world, settings));
		if (!behaviors.back()->restore(saved)) {
			return false;
		}
	}
	return true;
}

void Simulation::take_over_state(SavedState &&state, std::vector<std::unique_ptr<Behavior>> &&behaviors) {
	forget_everything(state.now);
	_has_started = true;
	_now = state.now;
	_settings.patience = state.patience;
	_settings.seed = state.seed;
	_settings.overrides = std::move(state.attributes);
	_statistics = state.statistics;
	_statistics.outside = 0;
	_persons = std::move(state.persons);
	_behaviors = std::move(behaviors);
	_free_behaviors.clear();
	_parties = std::move(state.parties);
	_floating_taken = std::move(state.floating_taken);
	_walks.restore(std::move(state.walks));
	for (uint32_t i = 0; i < _parties.size(); ++i) {
		_party_of_group[_parties[i].group] = i;
	}
	_city_revision = _city.revision() - 1; // it may have changed since, and so may the ground: looked at with the next step
	_ground_revision = 0;
	for (uint32_t i = 0; i < _persons.size(); ++i) {
		take_in_record(PersonId(i));
	}
}

// What the other books say of a person.
void Simulation::take_in_record(PersonId id) {
	PersonRecord &person = record(id);
	if (person.walk != WalkPool::none) {
		_walks.join(person.walk);
	}
	if (person.reserved_object != none) {
		_reservations.put(ObjectId(person.reserved_object), person.object_place, id);
	}
	if (person.state != PersonState::Inside) {
		++_statistics.outside;
	} else if (index_of(person.target().building()) < _inside_counts.size()) {
		++_inside_counts[person.place];
	}
	if (person.queued != never) {
		_queue.push({ person.queued, id });
	}
	person.since = _now;
	person.first_metre = person.walk == WalkPool::none ? 0.0f : float(_walks[person.walk].metres_at(_now));
}

// Whether the lists fit each other, the people, the agendas and the city.
bool Simulation::is_sound(const SavedState &state) const {
	if (state.persons.size() != _persons.size() || state.floating_taken.size() != _floating_taken.size() ||
			(state.behaviors.size() > 0 && !_rule_world)) {
		return false;
	}
	const bool are_walks_sound = std::all_of(state.walks.begin(), state.walks.end(), [](const Walk &walk) {
		return walk.points.size() >= 2 && std::all_of(walk.points.begin(), walk.points.end(), is_finite) && std::isfinite(walk.length) &&
				walk.length >= 0.0 && std::isfinite(walk.speed) && walk.speed > 0.0f && walk.arrival >= walk.departure;
	});
	if (!are_walks_sound || !are_parties_sound(state)) {
		return false;
	}
	Reservations seats;
	seats.update(_city);
	for (uint32_t i = 0; i < state.persons.size(); ++i) {
		const PersonRecord &person = state.persons[i];
		if (!is_sound(state, PersonId(i))) {
			return false;
		}
		const bool has_seat = person.reserved_object != none && person.object_place < _city.objects()[person.reserved_object].places.size();
		if (has_seat && !seats.put(ObjectId(person.reserved_object), person.object_place, PersonId(i))) {
			return false;
		}
	}
	return true;
}

bool Simulation::are_parties_sound(const SavedState &state) const {
	std::vector<uint32_t> groups;
	for (uint32_t i = 0; i < state.parties.size(); ++i) {
		const Party &party = state.parties[i];
		const auto exists = [&](PersonId id) { return index_of(id) < state.persons.size(); };
		if (party.group >= _agendas.groups.size() || !std::all_of(party.pending.begin(), party.pending.end(), exists) ||
				!std::all_of(party.collected.begin(), party.collected.end(), exists)) {
			return false;
		}
		groups.push_back(party.group);
		const bool has_leader = exists(party.leader) && state.persons[index_of(party.leader)].party == i;
		for (PersonId id : party.collected) { // they walk with the leader
			const PersonRecord &member = state.persons[index_of(id)];
			if (!has_leader || member.party != i || member.walk != state.persons[index_of(party.leader)].walk) {
				return false;
			}
		}
	}
	std::sort(groups.begin(), groups.end());
	return std::adjacent_find(groups.begin(), groups.end()) == groups.end();
}

bool Simulation::is_sound(const SavedState &state, PersonId id) const {
	const PersonRecord &person = state.persons[index_of(id)];
	const bool walks = person.state == PersonState::Walking;
	const bool walks_in_group = walks && (person.purpose == Purpose::Group || person.purpose == Purpose::Pickup);
	const bool has_rule = person.behavior != none;
	const bool is_in_time = person.queued >= state.now && person.due >= state.now && (person.is_in_group() || person.entry_end >= state.now);
	const bool has_entry = person.is_in_hole() || (person.is_in_group() && person.entry_task == PlannedEntry::gone) ||
			person.entry_task < _agendas.agenda_of(id).on(person.entry_start.day()).size();
	if (!is_finite(person.position) || !is_in_time || !has_entry || !names_a_place(person) || walks != (person.walk != none) ||
			(walks && person.walk >= state.walks.size()) || (has_rule && person.behavior >= state.behaviors.size()) ||
			(person.is_in_group() && person.party >= state.parties.size())) {
		return false;
	}
	if (person.is_absent() && (walks || has_rule || person.is_in_group() || person.reserved_object != none || person.queued != never)) {
		return false;
	}
	if (has_rule && (state.behaviors[person.behavior].person != id || person.is_in_group() ||
							(state.behaviors[person.behavior].uses_on_arrival && person.reserved_object == none))) {
		return false;
	}
	if (walks_in_group) {
		if (!person.is_in_group()) {
			return false;
		}
		const Party &party = state.parties[person.party];
		return party.leader == id || (person.due == never && std::count(party.collected.begin(), party.collected.end(), id) == 1);
	}
	return !walks || person.purpose != Purpose::Rule || has_rule;
}

// Whether what a record refers to in city and agendas exists.
bool Simulation::names_a_place(const PersonRecord &person) const {
	const size_t limits[] = { size_t(none) + 1, _city.buildings().size(), _city.zones().size(), _city.objects().size(), _persons.size() };
	const bool is_nowhere = person.place == none && person.state == PersonState::Inside; // without a home
	const bool has_place = is_nowhere || person.place < limits[size_t(person.place_kind)];
	const bool has_object = person.reserved_object == none
			? person.object_place == Reservations::none
			: person.reserved_object < _city.objects().size() && person.object_place != Reservations::none; // which may be gone since
	return has_place && has_object;
}

} // namespace pcg
