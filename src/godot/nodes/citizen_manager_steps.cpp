#include <algorithm>
#include <chrono>
#include <cmath>

#include <godot_cpp/core/error_macros.hpp>

#include "core/agenda/context.h"
#include "godot/convert.h"
#include "godot/liveness.h"
#include "godot/nodes/citizen_manager.h"
#include "godot/nodes/pcg_agent_view.h"
#include "godot/report.h"

using namespace godot;

// The clock, and what is told when it has moved.
namespace pcg {

namespace {

constexpr const char *signal_of_notice[Notice::kind_count] = { "person_left_building", "person_entered_building", "task_started",
	"agent_spawned", "agent_freed" };
constexpr int64_t remembered_days = 14; // that jumps back find as they were changed
constexpr double longest_advance = 366.0 * 86400.0; // seconds
constexpr int64_t last_day = 1'000'000; // and as many before the first

} // namespace

ToldWords::ToldWords() {
	for (size_t i = 0; i < signals.size(); ++i) {
		signals[i] = signal_of_notice[i];
	}
	for (size_t i = 0; i < tasks.size(); ++i) {
		tasks[i] = to_godot(task_kind_name(TaskKind(i)));
	}
}

void CitizenManager::_process(double p_delta) {
	if (!leave_lost_city() || !is_running()) { // a city that was freed has told nobody
		return;
	}
	if (!_is_paused) {
		advance(p_delta * _time_scale);
	} else if (PCGAgentView *view = get_agent_view()) {
		view->show_again(_life->simulation->now());
	}
}

// Scripts that the rules call come in the middle of a step, when nothing may change.
bool CitizenManager::is_alone(const char *p_method) const {
	const bool is_busy = _is_generating || (_life && _life->is_moving);
	ERR_FAIL_COND_V_MSG(is_busy, false,
			String("CitizenManager: ") + p_method + "() was called by a function or an operation of the rules, while they run. Call it afterwards, as with call_deferred().");
	return true;
}

// Whatever moves people. The life stays as long as it moves, even if a script that the rules call frees this node: then false.
bool CitizenManager::move(const std::function<void(Simulation &)> &change) {
	const std::shared_ptr<CitizenLife> life = _life;
	const uint64_t self = get_instance_id();
	listen();
	life->is_moving = true;
	change(*life->simulation);
	life->is_moving = false;
	if (is_there(self)) {
		show_bodies();
	}
	return is_there(self);
}

// False if a listener has freed this node.
bool CitizenManager::tell_news() {
	if (is_running()) {
		tell_rule_messages();
	}
	return tell_notices();
}

// Agendas that are to be renewed are so between the days. False if this node is gone.
bool CitizenManager::step_over_midnight(Duration step) {
	const SimTime end = _life->simulation->now() + step;
	const SimTime midnight = SimTime::at(_life->simulation->now().day() + 1, {});
	const uint64_t self = get_instance_id();
	if (_renews_agendas && midnight <= end) {
		if (!move([midnight](Simulation &simulation) { simulation.advance_to(midnight); })) {
			return false;
		}
		take_over_rules();
		if (!is_there(self) || !is_running()) {
			return false;
		}
	}
	return move([end](Simulation &simulation) { simulation.advance_to(end); });
}

void CitizenManager::advance(double p_seconds) {
	ERR_FAIL_COND_MSG(!is_running(), "CitizenManager: nothing runs. Call start() before advance().");
	ERR_FAIL_COND_MSG(!(p_seconds >= 0.0 && p_seconds <= longest_advance),
			"CitizenManager: advance() takes 0 s to 366 days; jump_to() goes backwards.");
	if (!is_alone("advance")) {
		return;
	}
	if (_life->simulation->now().day() > last_day) {
		_is_paused = true; // told once, not in every frame
		ERR_FAIL_MSG("CitizenManager: the clock has passed day 1000000, the last one, and is paused. jump_to() goes back.");
	}
	const auto begin = std::chrono::steady_clock::now();
	const int64_t day_before = _life->simulation->now().day();
	const double seconds = p_seconds + _owed_seconds;
	const Duration step{ int64_t(std::floor(seconds * 1000.0)) };
	_owed_seconds = seconds - step.in_seconds();
	if (!step_over_midnight(step)) {
		return;
	}
	if (_life->checker) {
		_life->checker->check();
	}
	count_load(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
	const uint64_t self = get_instance_id();
	bool is_here = tell_news();
	for (int64_t day = day_before + 1; is_here && is_running() && day <= _life->simulation->now().day(); ++day) {
		forget_days_before(_life->agendas, day - remembered_days);
		emit_signal("day_started", day);
		is_here = is_there(self);
	}
	if (is_here) {
		tell_broken_promises();
	}
}

void CitizenManager::jump_to(int64_t p_day, double p_seconds) {
	ERR_FAIL_COND_MSG(p_day < -last_day || p_day > last_day, "CitizenManager: days are -1000000 to 1000000; 0 is the first Monday.");
	ERR_FAIL_COND_MSG(!(std::abs(p_seconds) <= longest_advance), "CitizenManager: jump_to() takes seconds of the day.");
	const SimTime time = SimTime::at(p_day, Duration::seconds(p_seconds));
	if (!is_alone("jump_to")) {
		return;
	}
	if (!is_running()) {
		_begin = time;
		return;
	}
	_owed_seconds = 0.0;
	const uint64_t self = get_instance_id();
	if (_renews_agendas && time.day() > _life->simulation->now().day()) {
		take_over_rules();
		if (!is_there(self) || !is_running()) {
			return;
		}
	}
	if (move([time](Simulation &simulation) { simulation.jump_to(time); }) && tell_news()) {
		emit_signal("time_jumped");
	}
}

void CitizenManager::set_day(int64_t p_day) {
	if (p_day != get_day()) {
		jump_to(p_day, get_time());
	}
}

int CitizenManager::get_day() const { return int((is_running() ? _life->simulation->now() : _begin).day()); }

void CitizenManager::set_time(double p_seconds) { jump_to(get_day(), p_seconds); }

double CitizenManager::get_time() const { return (is_running() ? _life->simulation->now() : _begin).time_of_day().in_seconds(); }

String CitizenManager::get_clock_text() const { return format_clock(get_time()); }

// Whole minutes that have gone by, as on any clock.
String CitizenManager::format_clock(double p_seconds) { return to_godot(std::string_view(clock_text(Duration::seconds(p_seconds)))); }

void CitizenManager::set_time_scale(double p_scale) {
	ERR_FAIL_COND_MSG(!(p_scale >= 0.0 && p_scale <= 100000.0), "CitizenManager: time_scale is 0 to 100000; 1 is real time.");
	_time_scale = p_scale;
}

// Only what somebody listens to is written down.
void CitizenManager::listen() {
	for (size_t kind = 0; kind < Notice::kind_count; ++kind) {
		_life->notices.want(Notice::Kind(kind), has_connections(_words.signals[kind]));
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

// False if a listener has freed this node.
bool CitizenManager::tell_notices() {
	if (!_life) {
		return true; // whoever listened to the signal before this one has cleared the city
	}
	const uint64_t self = get_instance_id();
	std::vector<Notice> notices = std::move(_spare_notices); // whoever listens may come here again
	_life->notices.take(notices);
	for (const Notice &notice : notices) {
		const StringName &signal = _words.signals[size_t(notice.kind)];
		const int64_t person = index_of(notice.person);
		switch (notice.kind) {
			case Notice::Kind::LeftBuilding:
			case Notice::Kind::EnteredBuilding: emit_signal(signal, person, int64_t(to_number(notice.building))); break;
			case Notice::Kind::TaskStarted: emit_signal(signal, person, _words.tasks[size_t(notice.task)]); break;
			case Notice::Kind::AgentSpawned:
			case Notice::Kind::AgentFreed: emit_signal(signal, person); break;
		}
		if (!is_there(self)) {
			return false;
		}
	}
	notices.clear();
	_spare_notices = std::move(notices);
	return true;
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
