#include "godot/nodes/citizen_manager.h"

#include <algorithm>
#include <cmath>

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>

#include "core/agenda/agenda_generator.h"
#include "core/agenda/context.h"
#include "core/population/population_generator.h"
#include "core/sim/day_plan.h"
#include "godot/convert.h"
#include "godot/nodes/pcg_agent_view.h"
#include "godot/nodes/pcg_city.h"
#include "godot/ports/script_builtins.h"
#include "godot/report.h"

using namespace godot;

namespace pcg {

namespace {

constexpr const char *signal_of_notice[Notice::kind_count] = { "person_left_building", "person_entered_building", "task_started",
	"agent_spawned", "agent_freed" };
constexpr double longest_advance = 366.0 * 86400.0; // seconds

} // namespace

CitizenManager::CitizenManager() = default;

CitizenManager::~CitizenManager() = default;

void CitizenManager::_notification(int p_what) {
	if (p_what == NOTIFICATION_PREDELETE) {
		close_view(); // it refers to the population, which goes with this object
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
	if (_auto_start && !is_running() && city && city->is_generated() && generate_population()) {
		start();
	}
}

// So that life ends with the ground under it.
void CitizenManager::follow_city() {
	PCGCity *city = get_city();
	const godot::Callable leave = callable_mp(this, &CitizenManager::leave_lost_city);
	_life->city_id = city->get_instance_id();
	if (!city->is_connected("city_cleared", leave)) {
		city->connect("city_cleared", leave);
	}
}

// Another city than the one that is lived in may have been cleared; then nothing happens.
void CitizenManager::leave_lost_city() {
	const PCGCity *city = _life ? Object::cast_to<PCGCity>(ObjectDB::get_instance(_life->city_id)) : nullptr;
	if (!_life || (city && city->state() == _life->city)) {
		return;
	}
	const bool ends_unasked = is_running() && !(_auto_start && city && city->is_generating());
	stop();
	_life.reset();
	if (ends_unasked) {
		WARN_PRINT("CitizenManager: its city was cleared, freed or generated anew, so the simulation has stopped. Call generate_population() and "
				   "start() when the new city is there, or stop() before the old one goes.");
	}
}

void CitizenManager::set_city(PCGCity *p_city) {
	_city_id = p_city ? p_city->get_instance_id() : 0;
	update_configuration_warnings();
}

PCGCity *CitizenManager::get_city() const { return Object::cast_to<PCGCity>(ObjectDB::get_instance(_city_id)); }

void CitizenManager::set_rules(const Ref<PCGRuleSet> &p_rules) {
	_rules = p_rules;
	update_configuration_warnings();
}

void CitizenManager::set_household_table(const Ref<PCGHouseholdTable> &p_table) {
	_table = p_table;
	update_configuration_warnings();
}

void CitizenManager::set_person_count(int p_count) {
	ERR_FAIL_COND_MSG(p_count < 0, "CitizenManager: person_count is 0 or more.");
	_person_count = p_count;
}

PackedStringArray CitizenManager::_get_configuration_warnings() const {
	PackedStringArray warnings;
	if (!get_city()) {
		warnings.push_back("Nobody can live here: set `city` to a PCGCity of this scene.");
	}
	if (_rules.is_null()) {
		warnings.push_back("Nobody knows what to do: set `rules` to a .pcg file.");
	} else if (_rules->has_errors()) {
		warnings.push_back("The rules have errors; see their list of diagnostics.");
	} else if (_rules->get_dialect() != PCGRuleSet::DIALECT_AGENDA) {
		warnings.push_back("These rules build lots. Agendas come from a .pcg file.");
	}
	if (_table.is_null()) {
		warnings.push_back("There are no households: set `household_table`.");
	}
	return warnings;
}

bool CitizenManager::check_inputs(Diagnostics &diagnostics) const {
	const PCGCity *city = get_city();
	if (!city) {
		diagnostics.error("missing-city", "CitizenManager has no city", "set its `city` to a PCGCity");
	} else if (!city->is_generated()) {
		diagnostics.error("missing-city", "the city of CitizenManager has not been generated yet",
				"call generate() on it and wait for city_generated");
	}
	if (_rules.is_null()) {
		diagnostics.error("missing-rules", "CitizenManager has no rules", "set its `rules` to a .pcg file");
	} else if (_rules->get_dialect() != PCGRuleSet::DIALECT_AGENDA) {
		diagnostics.error("wrong-dialect", "the rules of CitizenManager are shape grammar rules", "give it a .pcg file");
	} else {
		diagnostics.append(_rules->diagnostics());
	}
	if (_table.is_null()) {
		diagnostics.error("missing-households", "CitizenManager has no household table", "set its `household_table`");
	} else {
		diagnostics.append(_table->diagnostics());
	}
	return !diagnostics.has_errors();
}

bool CitizenManager::generate_population() {
	stop();
	_life.reset();
	_diagnostics = Diagnostics();
	if (!check_inputs(_diagnostics)) {
		report(_diagnostics);
		return false;
	}
	std::unique_ptr<CitizenLife> life = std::make_unique<CitizenLife>();
	life->city = get_city()->state();
	life->program = _rules->program();
	PopulationOptions people;
	people.seed = uint64_t(_seed);
	people.persons = uint32_t(_person_count);
	people.home_type = from_godot(_home_type);
	const CityModel &model = life->city->city.model;
	life->population = pcg::generate_population(_table->table(), model, people, _diagnostics);
	AgendaOptions days;
	days.seed = uint64_t(_seed);
	days.start_rule = from_godot(_start_rule);
	days.work.threads = has_script_builtins() ? 1 : 0;
	if (!_diagnostics.has_errors()) {
		life->agendas = generate_agendas(*life->program, model, *life->city->paths, life->population, days, _diagnostics);
	}
	report(_diagnostics);
	// Households whose rules failed have what was written until then; where nobody has anything there is no day to live.
	if (life->population.persons.empty() || (life->agendas.tasks.empty() && _diagnostics.has_errors())) {
		return false;
	}
	_life = std::move(life);
	follow_city();
	emit_signal("population_generated");
	return true;
}

bool CitizenManager::start() {
	ERR_FAIL_COND_V_MSG(!_life, false, "CitizenManager: there is nobody in this city yet. Call generate_population() before start().");
	stop();
	SimulationSettings settings;
	settings.seed = uint64_t(_seed);
	CitizenLife &life = *_life;
	life.simulation = std::make_unique<Simulation>(life.city->city.model, *life.city->paths, life.population, life.agendas, life.program,
			std::move(settings), life.notices);
	life.notices.set_simulation(life.simulation.get());
	life.simulation->add_observer(life.notices);
	if (_check_promises) {
		life.checker = std::make_unique<InvariantChecker>(*life.simulation);
	}
	if (_record_lives) {
		life.log = std::make_unique<LivedLog>();
		life.heat = std::make_unique<AgeHeat>(life.city->city.model, life.population);
		life.simulation->add_observer(*life.log);
		for (HeatMap &map : life.heat->maps) {
			life.simulation->add_observer(map);
		}
	}
	open_view();
	listen();
	_owed_seconds = 0.0;
	_told_breaks = 0;
	_told_messages = 0;
	life.simulation->start(_begin);
	show_bodies();
	tell_rule_messages();
	emit_signal("simulation_started");
	tell_notices();
	return is_running(); // whoever listened may have ended it
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
	const PCGCity *city = get_city();
	if (city && city->is_inside_tree() && is_inside_tree()) {
		view->set_global_transform(city->get_global_transform());
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
	if (!is_running()) {
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

void CitizenManager::_process(double p_delta) {
	leave_lost_city(); // one that was freed has told nobody
	if (is_running() && !_is_paused) {
		advance(p_delta * _time_scale);
	}
}

void CitizenManager::advance(double p_seconds) {
	ERR_FAIL_COND_MSG(!is_running(), "CitizenManager: nothing runs. Call start() before advance().");
	ERR_FAIL_COND_MSG(!(p_seconds >= 0.0 && p_seconds <= longest_advance),
			"CitizenManager: advance() takes 0 s to 366 days; jump_to() goes backwards.");
	Simulation &simulation = *_life->simulation;
	const int64_t day_before = simulation.now().day();
	const double seconds = p_seconds + _owed_seconds;
	const Duration step{ int64_t(std::floor(seconds * 1000.0)) };
	_owed_seconds = seconds - step.in_seconds();
	listen();
	simulation.step(step);
	show_bodies();
	if (_life->checker) {
		_life->checker->check();
	}
	tell_rule_messages();
	tell_notices();
	for (int64_t day = day_before + 1; is_running() && day <= _life->simulation->now().day(); ++day) {
		emit_signal("day_started", day);
	}
	tell_broken_promises();
}

void CitizenManager::jump_to(int p_day, double p_seconds) {
	ERR_FAIL_COND_MSG(!(std::abs(p_seconds) <= longest_advance), "CitizenManager: jump_to() takes seconds of the day.");
	const SimTime time = SimTime::at(p_day, Duration::seconds(p_seconds));
	if (!is_running()) {
		_begin = time;
		return;
	}
	listen();
	_life->simulation->jump_to(time);
	_owed_seconds = 0.0;
	show_bodies();
	tell_rule_messages();
	tell_notices();
	emit_signal("time_jumped");
}

void CitizenManager::set_day(int p_day) {
	if (p_day != get_day()) {
		jump_to(p_day, get_time());
	}
}

int CitizenManager::get_day() const { return int((is_running() ? _life->simulation->now() : _begin).day()); }

void CitizenManager::set_time(double p_seconds) { jump_to(get_day(), p_seconds); }

double CitizenManager::get_time() const { return (is_running() ? _life->simulation->now() : _begin).time_of_day().in_seconds(); }

String CitizenManager::get_clock_text() const {
	const SimTime now = is_running() ? _life->simulation->now() : _begin;
	return to_godot(std::string_view(clock_text(now.time_of_day())));
}

void CitizenManager::set_time_scale(double p_scale) {
	ERR_FAIL_COND_MSG(!(p_scale >= 0.0 && p_scale <= 100000.0), "CitizenManager: time_scale is 0 to 100000; 1 is real time.");
	_time_scale = p_scale;
}

// Only what somebody listens to is written down.
void CitizenManager::listen() {
	for (size_t kind = 0; kind < Notice::kind_count; ++kind) {
		_life->notices.want(Notice::Kind(kind), has_connections(signal_of_notice[kind]));
	}
}

// What went wrong in delayed rules, and was not told when agendas were written.
void CitizenManager::tell_rule_messages() {
	const std::vector<Diagnostic> &messages = _life->simulation->diagnostics().list();
	Diagnostics news;
	for (; _told_messages < messages.size(); ++_told_messages) {
		const Diagnostic &message = messages[_told_messages];
		const std::vector<Diagnostic> &told = _diagnostics.list();
		if (std::none_of(told.begin(), told.end(), [&](const Diagnostic &other) { return agenda::is_repeat(other, message); })) {
			news.add(message);
		}
	}
	report(news);
}

void CitizenManager::tell_notices() {
	if (!_life) {
		return; // whoever listened to the signal before this one has cleared the city
	}
	const std::vector<Notice> notices = _life->notices.take();
	for (const Notice &notice : notices) {
		const StringName signal = signal_of_notice[size_t(notice.kind)];
		const int64_t person = index_of(notice.person);
		switch (notice.kind) {
			case Notice::Kind::LeftBuilding:
			case Notice::Kind::EnteredBuilding: emit_signal(signal, person, int64_t(to_number(notice.building))); break;
			case Notice::Kind::TaskStarted: emit_signal(signal, person, to_godot(task_kind_name(notice.task))); break;
			case Notice::Kind::AgentSpawned:
			case Notice::Kind::AgentFreed: emit_signal(signal, person); break;
		}
	}
}

void CitizenManager::tell_broken_promises() {
	if (!is_running() || !_life->checker || _life->checker->broken_total() == _told_breaks) {
		return;
	}
	const bool is_first = _told_breaks == 0;
	_told_breaks = _life->checker->broken_total();
	const std::vector<std::string> &examples = _life->checker->examples();
	if (is_first && !examples.empty()) {
		WARN_PRINT("CitizenManager: a promise of the simulation was broken (please report this): " + to_godot(std::string_view(examples[0])));
	}
	emit_signal("promise_broken", int64_t(_told_breaks));
}

} // namespace pcg
