#include <algorithm>
#include <chrono>
#include <iterator>

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/performance.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/array.hpp>

#include "godot/convert.h"
#include "godot/nodes/citizen_manager.h"

using namespace godot;

// What the debugger's monitors show.
namespace pcg {

namespace {

constexpr const char *monitor_names[] = { "agents", "outside", "events_per_second", "milliseconds_per_frame" };

String list_monitors() {
	String list;
	for (const char *name : monitor_names) {
		list += (list.is_empty() ? "" : ", ") + String(name);
	}
	return list;
}

double now_seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

} // namespace

double CitizenManager::get_monitor(const String &p_monitor) const {
	const auto *found = std::find_if(std::begin(monitor_names), std::end(monitor_names), [&](const char *name) { return p_monitor == name; });
	ERR_FAIL_COND_V_MSG(found == std::end(monitor_names), 0.0, "CitizenManager: there is no monitor '" + p_monitor + "'. There are " + list_monitors() + ".");
	if (!is_running()) {
		return 0.0;
	}
	const double values[] = { double(_life->bodies->size()), double(_life->simulation->outside_count()), _load.events_per_second, _load.frame_ms };
	static_assert(std::size(values) == std::size(monitor_names));
	return values[found - monitor_names];
}

// `seconds` that the simulation and the bodies took, of this frame.
void CitizenManager::count_load(double seconds) {
	const uint64_t frame = Engine::get_singleton()->get_process_frames();
	_load.frame_ms = (frame == _load.frame ? _load.frame_ms : 0.0) + seconds * 1000.0;
	_load.frame = frame;
	const double now = now_seconds(), passed = now - _load.second;
	const uint64_t events = _life->simulation->statistics().handled_moments;
	if (passed < 1.0 && events >= _load.events) {
		return;
	}
	const bool is_new = passed > 10.0 || events < _load.events; // it was paused, or loaded
	_load.events_per_second = is_new ? 0.0 : double(events - _load.events) / passed;
	_load.second = now;
	_load.events = events;
}

void CitizenManager::add_monitors() {
	Performance *performance = Performance::get_singleton();
	String group = get_name();
	if (performance->has_custom_monitor(group + "/" + monitor_names[0])) {
		group += " " + String::num_int64(int64_t(get_instance_id())); // of another manager with this name
	}
	for (const char *name : monitor_names) {
		const String id = group + "/" + name;
		Array arguments;
		arguments.push_back(String(name));
		performance->add_custom_monitor(id, godot::Callable(this, "get_monitor"), arguments);
		_monitors.push_back(id);
	}
}

void CitizenManager::remove_monitors() {
	for (int64_t i = 0; i < _monitors.size(); ++i) {
		Performance::get_singleton()->remove_custom_monitor(_monitors[i]);
	}
	_monitors.clear();
}

} // namespace pcg
