#include "godot/nodes/citizen_manager.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>

#include "core/agenda/agenda_generator.h"
#include "core/agenda/context.h"
#include "core/population/crowded_homes.h"
#include "core/population/population_generator.h"
#include "core/sim/day_plan.h"
#include "godot/convert.h"
#include "godot/liveness.h"
#include "godot/nodes/configuration_warnings.h"
#include "godot/nodes/pcg_agent_view.h"
#include "godot/nodes/pcg_city.h"
#include "godot/ports/script_builtins.h"
#include "godot/report.h"

using namespace godot;

namespace pcg {

CitizenManager::CitizenManager() = default;

CitizenManager::~CitizenManager() = default;

void CitizenManager::_notification(int p_what) {
	if (p_what == NOTIFICATION_PREDELETE) {
		close_view(); // it refers to the population, which goes with this object
	} else if (p_what == NOTIFICATION_ENTER_TREE && !Engine::get_singleton()->is_editor_hint()) {
		add_monitors();
	} else if (p_what == NOTIFICATION_EXIT_TREE) {
		remove_monitors();
	}
}

void CitizenManager::_ready() {
	if (!_auto_start || Engine::get_singleton()->is_editor_hint()) {
		return;
	}
	PCGCity *city = get_city();
	ERR_FAIL_NULL_MSG(city, "CitizenManager: auto_start waits for a city, and there is none. Set `city` before this node enters the tree.");
	const godot::Callable start_then = callable_mp(this, &CitizenManager::on_city_generated);
	if (!city->is_connected("city_generated", start_then)) {
		city->connect("city_generated", start_then);
	}
	on_city_generated(true);
}

// A city with an error in some lots can be lived in. After cancel() the one before may still be there, and life in it goes on.
void CitizenManager::on_city_generated(bool) {
	const PCGCity *city = get_city();
	const uint64_t self = get_instance_id();
	if (_auto_start && !is_running() && city && city->is_generated() && generate_population() && is_there(self)) {
		start();
	}
}

// So that life ends with the ground under it.
void CitizenManager::follow_city() {
	PCGCity *city = get_city();
	const godot::Callable leave = callable_mp(this, &CitizenManager::on_city_cleared);
	_life->city_id = city->get_instance_id();
	if (!city->is_connected("city_cleared", leave)) {
		city->connect("city_cleared", leave);
	}
}

void CitizenManager::on_city_cleared() { leave_lost_city(); }

// Another city than the one that is lived in may have been cleared; then nothing happens. In the middle of a step it waits for the next frame. False
// if a listener has freed this node.
bool CitizenManager::leave_lost_city() {
	const PCGCity *city = _life ? Object::cast_to<PCGCity>(ObjectDB::get_instance(_life->city_id)) : nullptr;
	if (!_life || _life->is_moving || _is_generating || (city && city->state() == _life->city)) {
		return true;
	}
	const bool ends_unasked = is_running() && !(_auto_start && city && city->is_generating());
	const uint64_t self = get_instance_id();
	stop();
	if (!is_there(self)) {
		return false;
	}
	_life.reset();
	if (ends_unasked) {
		WARN_PRINT("CitizenManager: its city was cleared, freed or generated anew, so the simulation has stopped. Call generate_population() and "
				   "start() when the new city is there, or stop() before the old one goes.");
	}
	return true;
}

void CitizenManager::set_city(PCGCity *p_city) {
	_city_id = p_city ? p_city->get_instance_id() : 0;
	update_configuration_warnings();
}

PCGCity *CitizenManager::get_city() const { return Object::cast_to<PCGCity>(ObjectDB::get_instance(_city_id)); }

Transform3D CitizenManager::city_frame() const {
	const PCGCity *city = get_city();
	return city ? city->frame() : Transform3D();
}

void CitizenManager::set_rules(const Ref<PCGRuleSet> &p_rules) {
	warn_by(this, std::exchange(_rules, p_rules), p_rules);
}

void CitizenManager::set_attributes(const Dictionary &p_attributes) {
	_attributes = p_attributes;
	update_configuration_warnings();
}

void CitizenManager::set_household_table(const Ref<PCGHouseholdTable> &p_table) {
	warn_by(this, std::exchange(_table, p_table), p_table);
}

void CitizenManager::set_population(const Ref<PCGPopulation> &p_population) {
	warn_by(this, std::exchange(_people, p_population), p_population);
}

void CitizenManager::set_person_count(int p_count) {
	ERR_FAIL_COND_MSG(p_count < 0, "CitizenManager: person_count is 0 or more.");
	_person_count = p_count;
	update_configuration_warnings();
}

std::shared_ptr<CitizenLife> CitizenManager::new_life() const {
	std::shared_ptr<CitizenLife> life = std::make_shared<CitizenLife>();
	life->city = get_city()->state();
	life->program = _rules->program();
	return life;
}

AgendaOptions CitizenManager::agenda_options(const CitizenLife &life) const {
	AgendaOptions options;
	options.seed = life.seed;
	options.overrides = life.attributes;
	options.start_rule = from_godot(_start_rule);
	options.work.threads = has_script_builtins() ? 1 : 0;
	return options;
}

void CitizenManager::draw_people(CitizenLife &life, Diagnostics &diagnostics) const {
	PopulationOptions options;
	options.seed = uint64_t(_seed);
	options.persons = uint32_t(_person_count);
	options.home_type = from_godot(_home_type);
	const CityModel &model = life.city->city.model;
	life.population = _people.is_valid() ? _people->read(model, diagnostics) : pcg::generate_population(_table->table(), model, options, diagnostics);
	life.population.home_type = options.home_type;
	if (_people.is_valid()) {
		warn_of_crowded_homes(life.population, model, {}, diagnostics);
	}
	life.seed = uint64_t(_seed);
	life.attributes = attributes(diagnostics);
	const AgendaOptions days = agenda_options(life);
	if (!diagnostics.has_errors()) { // from here on scripts may free this node
		life.agendas = generate_agendas(*life.program, model, *life.city->paths, life.population, days, diagnostics);
	}
}

bool CitizenManager::generate_population() {
	const uint64_t self = get_instance_id();
	if (!let_everybody_go("generate_population")) {
		return false;
	}
	if (!check_inputs(_diagnostics)) {
		report(_diagnostics);
		return false;
	}
	const std::shared_ptr<CitizenLife> life = new_life();
	Diagnostics diagnostics = _diagnostics;
	_is_generating = true;
	draw_people(*life, diagnostics);
	if (!is_there(self)) {
		return false;
	}
	_is_generating = false;
	_diagnostics = diagnostics;
	report(diagnostics);
	// Households whose rules failed have what was written until then; where nobody has anything there is no day to live.
	if (life->population.persons.empty() || (life->agendas.tasks.empty() && diagnostics.has_errors())) {
		return false;
	}
	_life = life;
	follow_city();
	emit_signal("population_generated");
	return true;
}

void CitizenManager::clear_population() { let_everybody_go("clear_population"); }

// False if it cannot be now, or a listener has freed this node.
bool CitizenManager::let_everybody_go(const char *p_method) {
	const uint64_t self = get_instance_id();
	stop();
	if (!is_there(self) || !is_alone(p_method)) {
		return false;
	}
	_life.reset();
	_renews_agendas = false;
	_diagnostics = Diagnostics();
	return true;
}

bool CitizenManager::start() {
	ERR_FAIL_COND_V_MSG(!_life, false, "CitizenManager: there is nobody in this city yet. Call generate_population() before start().");
	const uint64_t self = get_instance_id();
	stop();
	return is_there(self) && is_alone("start") && _life && live([begin = _begin](Simulation &simulation) { simulation.start(begin); });
}

// `begin` puts people in place. False if nothing runs in the end: whoever listens may have ended it.
bool CitizenManager::live(const std::function<void(Simulation &)> &begin) {
	SimulationSettings settings;
	CitizenLife &life = *_life;
	settings.seed = life.seed;
	settings.overrides = life.attributes;
	life.simulation = std::make_unique<Simulation>(life.city->city.model, *life.city->paths, life.population, life.agendas, life.program,
			std::move(settings), life.notices);
	life.notices.set_simulation(life.simulation.get());
	life.simulation->add_observer(life.notices);
	if (_check_promises) {
		life.checker = std::make_unique<InvariantChecker>(*life.simulation);
	}
	if (_record_lives) {
		begin_record();
	}
	open_view();
	_owed_seconds = 0.0;
	_told_breaks = 0;
	_told_messages = 0;
	const uint64_t self = get_instance_id();
	if (!move(begin)) {
		return false;
	}
	emit_signal("simulation_started");
	return is_there(self) && tell_news() && is_running();
}

void CitizenManager::begin_record() {
	_life->log = std::make_unique<LivedLog>();
	_life->heat = std::make_unique<AgeHeat>(_life->city->city.model, _life->population);
	_life->simulation->add_observer(*_life->log);
	_life->simulation->add_observer(*_life->heat);
}

// What was recorded can still be asked for after the record has ended, until life does.
void CitizenManager::set_record_lives(bool p_enabled) {
	if (p_enabled == _record_lives || (is_running() && !is_alone("set_record_lives"))) {
		return;
	}
	_record_lives = p_enabled;
	if (!is_running()) {
		return;
	}
	flush_lives(); // spans begin or end with the record
	if (_life->log) {
		_life->simulation->remove_observer(*_life->log);
		_life->simulation->remove_observer(*_life->heat);
	}
	if (p_enabled) {
		begin_record();
	}
}

PCGAgentView *CitizenManager::get_agent_view() const { return Object::cast_to<PCGAgentView>(ObjectDB::get_instance(_view_id)); }

// A child that the user put there, with his own limits, or one of our making.
PCGAgentView *CitizenManager::find_view() {
	for (int i = 0; i < get_child_count(true); ++i) {
		if (PCGAgentView *view = cast_to<PCGAgentView>(get_child(i, true))) {
			return view;
		}
	}
	PCGAgentView *view = memnew(PCGAgentView);
	view->set_name("Agents");
	add_child(view, false, INTERNAL_MODE_BACK);
	return view;
}

void CitizenManager::open_view() {
	PCGAgentView *view = find_view();
	_view_id = view->get_instance_id();
	const Layout &layout = _life->city->city.layout;
	const AABB bounds(to_godot(layout.min), to_godot(layout.max - layout.min) + Vector3(0, 3, 0));
	const Simulation *simulation = _life->simulation.get();
	_life->bodies = std::make_shared<Crowd>(_life->population, _life->city->paths.get(), [simulation] { return simulation->now(); });
	_life->notices.set_bodies(_life->bodies.get());
	view->open(_life->bodies, bounds);
	if (is_inside_tree()) {
		view->set_global_transform(city_frame());
	}
}

void CitizenManager::close_view() {
	if (PCGAgentView *view = get_agent_view()) {
		view->close();
	}
}

void CitizenManager::show_bodies() {
	if (PCGAgentView *view = get_agent_view()) {
		view->show_at(_life->simulation->now());
	}
}

void CitizenManager::stop() {
	if (!is_running() || !is_alone("stop")) {
		return;
	}
	_begin = _life->simulation->now();
	close_view();
	_life->notices.set_bodies(nullptr);
	_life->bodies.reset();
	_life->notices.set_simulation(nullptr);
	_life->checker.reset();
	_life->simulation.reset();
	_life->log.reset();
	_life->heat.reset();
	emit_signal("simulation_stopped");
}

} // namespace pcg
