#include <godot_cpp/core/error_macros.hpp>

#include "core/io/trace_csv.h"
#include "core/population/names.h"
#include "core/sim/day_story.h"
#include "godot/convert.h"
#include "godot/convert_looks.h"
#include "godot/convert_task.h"
#include "godot/liveness.h"
#include "godot/nodes/citizen_manager.h"
#include "godot/nodes/pcg_agent_view.h"
#include "godot/nodes/pcg_city.h"
#include "godot/report.h"

using namespace godot;

namespace pcg {

namespace {

TypeId type_of(const Target &place, const CityModel &model) {
	switch (place.kind) {
		case Target::Kind::Building: {
			const EntranceId door = model.entrance_of(place.building());
			return is_valid(door) ? model.entrance(door).type : TypeId::Invalid;
		}
		case Target::Kind::Zone: return model.zone(place.zone()).type;
		case Target::Kind::Object: return model.object(place.object()).type;
		default: return TypeId::Invalid;
	}
}

Dictionary to_dictionary(const Target &place, const CityModel &model) {
	static constexpr const char *kinds[] = { "", "building", "zone", "object", "person" };
	const TypeId type = type_of(place, model);
	Dictionary result;
	result["kind"] = kinds[size_t(place.kind)];
	result["id"] = place.is_none() ? int64_t(-1) : int64_t(place.index);
	result["type"] = is_valid(type) ? to_godot(model.types.name(type)) : String();
	return result;
}

PackedInt32Array to_ids(const std::vector<PersonId> &persons) {
	PackedInt32Array result;
	for (const PersonId person : persons) {
		result.push_back(int32_t(index_of(person)));
	}
	return result;
}

void add_state(Dictionary &result, const PersonView &view, const CityModel &model, const Transform3D &frame) {
	result["state"] = to_godot(state_name(view.state));
	result["place"] = to_dictionary(view.place, model);
	result["position"] = frame.xform(to_godot(view.position));
	result["since"] = view.since.in_seconds();
	if (view.state == PersonState::Walking) {
		result["arrival"] = view.arrival.in_seconds();
	}
	result["leader"] = int64_t(to_number(view.leader));
	static constexpr const char *presences[] = { "living", "taken", "removed" };
	result["presence"] = presences[size_t(view.presence)];
}

} // namespace

bool CitizenManager::has_person(int p_person) const {
	return _life && p_person >= 0 && size_t(p_person) < _life->population.persons.size();
}

Dictionary CitizenManager::get_person(int p_person) const {
	ERR_FAIL_COND_V_MSG(!has_person(p_person), Dictionary(), no_person);
	const PersonId id = PersonId(p_person);
	const Person &person = _life->population.person(id);
	Dictionary result;
	result["id"] = p_person;
	result["name"] = to_godot(std::string_view(full_name(_life->population, id)));
	result["age"] = int64_t(person.age);
	result["gender"] = person.gender == Gender::Woman ? "woman" : "man";
	result["household"] = int64_t(to_number(person.household));
	const uint16_t row = _life->population.household(person.household).pattern;
	result["household_row"] = row == PCGPopulation::no_row ? int64_t(-1) : int64_t(row);
	result["home"] = int64_t(to_number(_life->population.home_of(id)));
	result["walking_speed"] = person.walking_speed;
	if (is_running()) {
		add_state(result, _life->simulation->view(id), _life->city->city.model, city_frame());
	}
	return result;
}

Dictionary CitizenManager::get_looks(int p_person) const {
	ERR_FAIL_COND_V_MSG(!has_person(p_person), Dictionary(), no_person);
	const PersonId id = PersonId(p_person);
	return to_godot(_life->population, id, looks_of(_life->population, id));
}

// Calls a script for each person, which may do anything meanwhile.
PackedInt32Array CitizenManager::find_persons(const godot::Callable &p_predicate) const {
	PackedInt32Array found;
	ERR_FAIL_COND_V_MSG(!p_predicate.is_valid(), found, "CitizenManager: find_persons() takes a function of a person that gives true or false.");
	const uint64_t self = get_instance_id();
	for (int person = 0; has_person(person); ++person) {
		Array arguments;
		arguments.push_back(get_person(person));
		const Variant is_wanted = p_predicate.callv(arguments);
		ERR_FAIL_COND_V_MSG(is_wanted.get_type() != Variant::BOOL, found,
				"CitizenManager: the function that find_persons() was given has to give true or false.");
		if (bool(is_wanted)) {
			found.push_back(person);
		}
		if (!is_there(self)) {
			break;
		}
	}
	return found;
}

TypedArray<Dictionary> CitizenManager::get_agenda(int p_person, int p_day) const {
	TypedArray<Dictionary> result;
	ERR_FAIL_COND_V_MSG(!has_person(p_person), result, no_person);
	const AgendaView agenda = _life->agendas.agenda_of(PersonId(p_person));
	const DayMask days = p_day < 0 ? all_days : DayMask(1u << SimTime::at(p_day, {}).weekday());
	for (const Task &task : p_day < 0 ? agenda.week : agenda.on(p_day)) {
		if (task.days & days) {
			result.push_back(to_godot(task, _life->agendas, *_life->program, p_day < 0 ? std::nullopt : std::optional<int64_t>(p_day)));
		}
	}
	return result;
}

PackedInt32Array CitizenManager::get_persons_outside() const {
	return is_running() ? to_ids(_life->simulation->persons_outside()) : PackedInt32Array();
}

PackedInt32Array CitizenManager::get_persons_inside(int p_building) const {
	const bool is_building = is_running() && p_building >= 0 && size_t(p_building) < _life->city->city.model.buildings().size();
	return is_building ? to_ids(_life->simulation->persons_inside(BuildingId(p_building))) : PackedInt32Array();
}

Dictionary CitizenManager::get_statistics() const {
	Dictionary result;
	result["persons"] = _life ? int64_t(_life->population.persons.size()) : 0;
	result["households"] = _life ? int64_t(_life->population.households.size()) : 0;
	result["tasks"] = _life ? int64_t(_life->agendas.tasks.size()) : 0;
	if (!is_running()) {
		return result;
	}
	const SimulationStatistics &figures = _life->simulation->statistics();
	result["trips"] = int64_t(figures.trips);
	result["late_arrivals"] = int64_t(figures.late_arrivals);
	result["outside"] = int64_t(figures.outside);
	result["peak_outside"] = int64_t(figures.peak_outside);
	result["peak_time"] = figures.peak_time.in_seconds();
	result["peak_clock"] = to_godot(std::string_view(clock_text(figures.peak_time.time_of_day())));
	Dictionary events;
	for (size_t i = 0; i < sim_event_kind_count; ++i) {
		events[to_godot(event_name(SimEventKind(i)))] = int64_t(figures.events[i]);
	}
	result["events"] = events;
	return result;
}

Dictionary CitizenManager::get_broken_promises() const {
	Dictionary result;
	if (_life && _life->checker) {
		for (size_t i = 0; i < promise_count; ++i) {
			result[to_godot(promise_name(Promise(i)))] = int64_t(_life->checker->broken(Promise(i)));
		}
	}
	return result;
}

PackedStringArray CitizenManager::get_broken_promise_examples() const {
	return _life && _life->checker ? to_godot(_life->checker->examples()) : PackedStringArray();
}

// Those of making the population, then those of the simulation.
TypedArray<Dictionary> CitizenManager::get_diagnostics() const {
	Diagnostics all = _diagnostics;
	if (is_running()) {
		all.append(_life->simulation->diagnostics());
	}
	return to_godot(all);
}

// Ends the spans that are still being lived, so that records reach to now.
void CitizenManager::flush_lives() const { _life->simulation->flush_lived(); }

int CitizenManager::choose_household() const {
	ERR_FAIL_COND_V_MSG(!has_recorded_lives(), -1, no_lives);
	flush_lives();
	return int(to_number(pcg::choose_household(_life->population, *_life->log)));
}

PackedStringArray CitizenManager::tell_day(int p_household, int p_day) const {
	ERR_FAIL_COND_V_MSG(!has_recorded_lives(), PackedStringArray(), no_lives);
	ERR_FAIL_COND_V_MSG(p_household < 0 || size_t(p_household) >= _life->population.households.size(), PackedStringArray(),
			"CitizenManager: there is no such household. Ask choose_household() for one worth telling of.");
	flush_lives();
	return to_godot(pcg::tell_day(_life->city->city.model, _life->population, *_life->log, HouseholdId(p_household),
			SimTime::at(p_day, {}), SimTime::at(int64_t(p_day) + 1, {})));
}

Error CitizenManager::save_lives(const String &p_path) const {
	ERR_FAIL_COND_V_MSG(!has_recorded_lives(), ERR_UNCONFIGURED, no_lives);
	flush_lives();
	return save_to(p_path, [this](const std::string &path, Diagnostics &diagnostics) {
		write_lived_csv(path, _life->city->city.model, _life->population, *_life->log, {}, diagnostics);
	});
}

} // namespace pcg
