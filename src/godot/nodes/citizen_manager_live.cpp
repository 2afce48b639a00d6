#include <cmath>

#include <godot_cpp/core/error_macros.hpp>

#include "core/population/crowded_homes.h"
#include "core/sim/day_plan.h"
#include "godot/convert.h"
#include "godot/convert_task.h"
#include "godot/liveness.h"
#include "godot/nodes/citizen_manager.h"
#include "godot/nodes/pcg_city.h"
#include "godot/report.h"

using namespace godot;

// Changes of agendas and people, also while they live.
namespace pcg {

namespace {

const char *reason_name(Unmet reason) {
	switch (reason) {
		case Unmet::No:
			return "";
		case Unmet::Missing:
			return "missing";
		case Unmet::Lost:
			return "lost";
		case Unmet::NotOver:
			return "not-over";
		case Unmet::Deserted:
			return "deserted";
		case Unmet::Leaderless:
			return "leaderless";
	}
	return "";
}

} // namespace

// Whether it is somebody with a life of its own at present.
bool CitizenManager::is_living(int p_person, const char *p_method) const {
	ERR_FAIL_COND_V_MSG(!is_running(), false, String("CitizenManager: nothing runs. Call start() before ") + p_method + "().");
	ERR_FAIL_COND_V_MSG(!has_person(p_person), false, no_person);
	return is_alone(p_method);
}

bool CitizenManager::check_task(const Task &task, std::optional<int64_t> day) const {
	const std::vector<Building> &buildings = _life->city->city.model.buildings();
	ERR_FAIL_COND_V_MSG(is_stay(task.kind) && (task.target >= buildings.size() || buildings[task.target].is_removed), false,
			"CitizenManager: `target` of the task is no building of the city.");
	const bool is_over = day && is_running() && SimTime::at(*day, task.end()) <= _life->simulation->now();
	ERR_FAIL_COND_V_MSG(is_over, false, "CitizenManager: the time of the task is over. `day` counts from the first Monday on, as the property `day` does.");
	return true;
}

// Scripts come in the middle of it only if the rules call some.
bool CitizenManager::renew_agendas(bool p_at_once) {
	ERR_FAIL_COND_V_MSG(!_life, false, "CitizenManager: nobody lives here yet. Call generate_population() before renew_agendas().");
	if (!is_alone("renew_agendas")) {
		return false;
	}
	Diagnostics diagnostics;
	if (!check_place(diagnostics)) {
		report(diagnostics);
		return false;
	}
	_renews_agendas = is_running() && !p_at_once;
	return _renews_agendas || take_over_rules();
}

// Where the new rules write nothing but errors, the old agendas stay. False then, and if a listener or a rule has freed this node.
bool CitizenManager::take_over_rules() {
	_renews_agendas = false;
	const std::shared_ptr<CitizenLife> life = _life;
	const std::shared_ptr<const Program> program = _rules->program();
	const uint64_t self = get_instance_id();
	Diagnostics diagnostics;
	AgendaOptions options = agenda_options(*life);
	options.overrides = attributes(diagnostics);
	_is_generating = true;
	AgendaSet agendas = generate_agendas(*program, life->city->city.model, *life->city->paths, life->population, options, diagnostics);
	if (!is_there(self)) {
		return false;
	}
	_is_generating = false;
	_diagnostics = diagnostics;
	report(diagnostics);
	if (agendas.tasks.empty() && diagnostics.has_errors()) {
		return false;
	}
	const auto change = [&] {
		life->agendas = std::move(agendas);
		life->program = program;
		life->attributes = options.overrides;
		return program;
	};
	if (!is_running()) {
		change();
	} else if (!move([&](Simulation &simulation) { simulation.change_agendas(change, options.overrides); }) || !tell_news()) {
		return false;
	}
	emit_signal("agendas_renewed");
	return is_there(self);
}

bool CitizenManager::insert_task(int p_person, const Dictionary &p_task) {
	ERR_FAIL_COND_V_MSG(!_life, false, "CitizenManager: nobody lives here yet. Call generate_population() before insert_task().");
	ERR_FAIL_COND_V_MSG(!has_person(p_person), false, no_person);
	if (!is_alone("insert_task")) {
		return false;
	}
	TaskReader reader(_life->agendas, *_life->program);
	const std::optional<WrittenTask> written = reader.read(p_task);
	ERR_FAIL_COND_V_MSG(!written, false, "CitizenManager: insert_task() cannot use this: " + reader.problem());
	if (!check_task(written->task, written->day)) {
		return false;
	}
	const AgendaChange change = pcg::insert_task(_life->agendas, _life->population, PersonId(p_person), written->task, written->day);
	return change.is_inserted && tell_change(change);
}

// Whoever listens hears of what else fell out. True even if a listener has freed this node.
bool CitizenManager::tell_change(const AgendaChange &change) {
	const auto take_in = [&change](Simulation &simulation) {
		for (const PersonId person : change.changed) {
			simulation.take_in_agenda(person);
		}
	};
	const std::shared_ptr<CitizenLife> life = _life;
	if (is_running() && !move(take_in)) {
		return true;
	}
	const uint64_t self = get_instance_id();
	for (const DroppedTask &dropped : change.dropped) {
		Dictionary entry = to_godot(dropped.task, life->agendas, *life->program, dropped.day);
		if (dropped.day) {
			entry["day"] = *dropped.day;
		}
		emit_signal("task_dropped", int64_t(index_of(dropped.person)), entry, String(reason_name(dropped.reason)),
				dropped.name != 0 ? to_godot(std::string_view(life->agendas.names[dropped.name])) : String());
		if (!is_there(self)) {
			return true;
		}
	}
	tell_news();
	return true;
}

bool CitizenManager::take_over(int p_person) {
	if (!is_living(p_person, "take_over") || !_life->simulation->is_living(PersonId(p_person))) {
		return false;
	}
	if (move([p_person](Simulation &simulation) { simulation.take_over(PersonId(p_person)); })) {
		tell_news();
	}
	return true;
}

bool CitizenManager::place_taken(int p_person, const Vector3 &p_position) {
	ERR_FAIL_COND_V_MSG(!p_position.is_finite(), false, "CitizenManager: place_taken() takes a finite position.");
	if (!is_living(p_person, "place_taken")) {
		return false;
	}
	return _life->simulation->place_taken(PersonId(p_person), from_godot(city_frame().affine_inverse().xform(p_position)));
}

bool CitizenManager::release(int p_person) {
	if (!is_living(p_person, "release") || _life->simulation->view(PersonId(p_person)).presence != Presence::Taken) {
		return false;
	}
	if (move([p_person](Simulation &simulation) { simulation.release(PersonId(p_person)); })) {
		if (_life->simulation->is_stranded(PersonId(p_person))) {
			WARN_PRINT(vformat("CitizenManager: person %d was released where no way leads to where its agenda wants it. It stands there and tries again "
							   "every five minutes and after every edit of the city.", p_person));
		}
		tell_news();
	}
	return true;
}

bool CitizenManager::remove_person(int p_person) {
	if (!is_living(p_person, "remove_person") || _life->simulation->view(PersonId(p_person)).presence == Presence::Removed) {
		return false;
	}
	if (move([p_person](Simulation &simulation) { simulation.remove_person(PersonId(p_person)); })) {
		tell_news();
	}
	return true;
}

PackedInt32Array CitizenManager::add_people(const Ref<PCGPopulation> &p_people) {
	PackedInt32Array added;
	ERR_FAIL_COND_V_MSG(!_life, added, "CitizenManager: nobody lives here yet. Call generate_population() before add_people().");
	ERR_FAIL_COND_V_MSG(p_people.is_null(), added, "CitizenManager: add_people() takes a PCGPopulation.");
	if (!is_alone("add_people")) {
		return added;
	}
	Diagnostics diagnostics;
	const std::shared_ptr<CitizenLife> life = _life;
	const CityModel &model = life->city->city.model;
	const Population more = p_people->read(model, diagnostics);
	const size_t before = life->population.persons.size();
	AgendaOptions options = agenda_options(*life);
	options.first_household = HouseholdId(uint32_t(life->population.households.size()));
	append_population(life->population, more);
	if (!more.persons.empty()) {
		warn_of_crowded_homes(life->population, model, {}, diagnostics);
	}
	const uint64_t self = get_instance_id();
	_is_generating = true;
	append_agendas(life->agendas, generate_agendas(*life->program, model, *life->city->paths, life->population, options, diagnostics));
	if (!is_there(self)) {
		return added;
	}
	_is_generating = false;
	report(diagnostics);
	for (size_t i = before; i < life->population.persons.size(); ++i) {
		added.push_back(int32_t(i));
	}
	if (is_running() && move([](Simulation &simulation) { simulation.take_in_people(); })) {
		tell_news();
	}
	return added;
}

} // namespace pcg
