#include "godot/nodes/pcg_city.h"

#include <utility>

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/worker_thread_pool.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>

#include "godot/convert.h"
#include "godot/nodes/configuration_warnings.h"
#include "godot/report.h"

using namespace godot;

namespace pcg {

namespace {

// Work on the main thread goes on in the next frame after so long. A piece that is expected to take longer than what is left begins the next slice;
// one that takes longer than a whole slice (a large lot, a tile) runs alone.
class Slice {
public:
	double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - _begin).count(); }
	bool is_over(double expected = 0.0) const { return seconds() + expected > 0.003; }

private:
	const std::chrono::steady_clock::time_point _begin = std::chrono::steady_clock::now();
};

} // namespace

PCGCity::PCGCity() = default;

// A city generates only in the tree, and stops when it leaves: there is nothing to wait for here.
PCGCity::~PCGCity() = default;

void PCGCity::set_layout(const Ref<PCGLayout> &p_layout) {
	warn_by(this, std::exchange(_layout, p_layout), p_layout);
}

void PCGCity::set_lot_types(const TypedArray<PCGLotType> &p_types) {
	for (int64_t i = 0; i < _lot_types.size(); ++i) {
		warn_by(this, Ref<PCGLotType>(_lot_types[i]), Ref<Resource>());
	}
	_lot_types = p_types;
	for (int64_t i = 0; i < _lot_types.size(); ++i) {
		warn_by(this, Ref<Resource>(), Ref<PCGLotType>(_lot_types[i]));
	}
	update_configuration_warnings();
}

void PCGCity::set_street_rules(const Ref<PCGRuleSet> &p_rules) {
	warn_by(this, std::exchange(_street_rules, p_rules), p_rules);
}

void PCGCity::set_cell_size(double p_metres) {
	ERR_FAIL_COND_MSG(!(p_metres == 0.0 || (p_metres >= 0.05 && p_metres <= 1.0)),
			"PCGCity: cell_size is 0.05 m to 1 m, or 0 for that of the world's navigation map; through larger cells no door can be told from its wall.");
	_cell_size = p_metres;
	update_configuration_warnings();
}

void PCGCity::set_agent_radius(double p_metres) {
	ERR_FAIL_COND_MSG(!(p_metres >= 0.0 && p_metres <= 1.0), "PCGCity: agent_radius is 0 m to 1 m; wider people do not pass a door.");
	_agent_radius = p_metres;
}

void PCGCity::set_agent_height(double p_metres) {
	ERR_FAIL_COND_MSG(!(p_metres >= 0.5 && p_metres <= 5.0), "PCGCity: agent_height is 0.5 m to 5 m.");
	_agent_height = p_metres;
}

void PCGCity::set_agent_max_climb(double p_metres) {
	ERR_FAIL_COND_MSG(!(p_metres >= 0.0 && p_metres <= 1.0), "PCGCity: agent_max_climb is 0 m to 1 m.");
	_agent_max_climb = p_metres;
}

void PCGCity::set_agent_max_slope(double p_degrees) {
	ERR_FAIL_COND_MSG(!(p_degrees >= 0.0 && p_degrees <= 90.0), "PCGCity: agent_max_slope is 0 to 90 degrees.");
	_agent_max_slope = p_degrees;
}

void PCGCity::_ready() {
	set_process(is_generating()); // the engine has just switched it on
	if (!_state && !is_generating() && !_saved.is_empty() && load_saved()) {
		return;
	}
	if (_generate_on_ready && !Engine::get_singleton()->is_editor_hint()) {
		generate();
	}
}

void PCGCity::_notification(int p_what) {
	if (p_what == NOTIFICATION_ENTER_TREE) {
		add_to_group(group);
	} else if (p_what == NOTIFICATION_EXIT_TREE && is_generating()) {
		end(false);
	}
}

bool PCGCity::begin(bool is_async) {
	ERR_FAIL_COND_V_MSG(is_generating(), false, "PCGCity: it is being generated already. Call cancel() first, or wait for city_generated.");
	if (!is_inside_tree()) {
		tell_end(false);
		ERR_FAIL_V_MSG(false, "PCGCity: add it to the scene tree before generate(): its ground is baked for a world.");
	}
	CityInput input;
	_diagnostics = Diagnostics();
	_seconds.clear();
	_longest_hold = _built_seconds = _built_work = 0.0;
	if (!prepare_job(input, _diagnostics)) {
		report(_diagnostics);
		tell_end(false);
		return false;
	}
	prepare_streets(input, _diagnostics);
	PackedStringArray warnings;
	add_bake_warnings(warnings);
	for (const String &warning : warnings) {
		_diagnostics.warning("odd-ground", from_godot(warning), "");
	}
	_job = std::make_unique<CityJob>(std::move(input));
	_is_async = is_async;
	emit_signal("generation_started");
	start_task(Stage::Growing);
	return true;
}

bool PCGCity::generate() {
	if (!begin(true)) {
		return false;
	}
	set_process(true);
	return true;
}

bool PCGCity::generate_now() {
	if (!begin(false)) {
		return false;
	}
	while (is_generating()) {
		go_on();
	}
	return is_generated() && !_diagnostics.has_errors();
}

void PCGCity::cancel() {
	if (!is_generating()) {
		return;
	}
	const bool is_scene_touched = _stage != Stage::Growing;
	end(false);
	if (is_scene_touched) {
		tear_down();
	}
}

void PCGCity::clear() {
	if (is_generating()) {
		end(false);
	}
	tear_down();
}

// Nothing is left of the city that was there, and whoever lived in it is told.
void PCGCity::tear_down() {
	_ground.reset();
	CityBuilder::clear(this);
	_edits.follow(nullptr);
	_state_in_scene.reset();
	_saved.clear();
	if (_state) {
		_state.reset();
		emit_signal("city_cleared");
	}
}

void PCGCity::end(bool is_good) {
	stop();
	tell_end(is_good);
}

// Told when the caller has returned, so that nobody who awaits the signal afterwards waits in vain.
void PCGCity::tell_end(bool is_good) { call_deferred("emit_signal", "city_generated", is_good); }

// Ends a generation without a word.
void PCGCity::stop() {
	if (_job) {
		_job->is_cancelled = true;
		_job->main->close();
	}
	wait_for_task();
	_baker.reset(); // what the engine still bakes is its own to finish
	_builder.reset();
	_job.reset();
	_stage = Stage::Idle;
	set_process(_ground != nullptr && !_ground->is_idle());
}

void PCGCity::_process(double) {
	if (is_generating()) {
		go_on();
	} else if (_ground) {
		go_on_with_ground();
	}
}

// One slice of work on the main thread.
void PCGCity::go_on() {
	const auto begin = std::chrono::steady_clock::now();
	go_on_with_stage();
	_longest_hold = std::max(_longest_hold, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
}

void PCGCity::go_on_with_stage() {
	switch (_stage) {
		case Stage::Idle: break;
		case Stage::Growing:
			_job->main->run_waiting();
			tell_progress(_job->progress);
			if (is_task_done()) {
				wait_for_task();
				_job->has_succeeded ? begin_building() : fail();
			}
			break;
		case Stage::Building: build_slice(); break;
		case Stage::Baking: bake_slice(); break;
		case Stage::Joining:
			tell_progress(_job->progress);
			if (is_task_done()) {
				wait_for_task();
				_job->has_succeeded ? finish() : fail();
			}
			break;
	}
}

void PCGCity::start_task(Stage stage) {
	_stage = stage;
	_stage_start = std::chrono::steady_clock::now();
	_job->progress = 0.0f;
	if (_is_async) {
		_task = WorkerThreadPool::get_singleton()->add_task(callable_mp(this, &PCGCity::run_task), true, "PCGCity");
	} else {
		_job->do_beside([this] { run_task(); });
	}
}

void PCGCity::run_task() { _job->has_succeeded = _stage == Stage::Growing ? _job->grow() : _job->join(); }

bool PCGCity::is_task_done() const { return _task < 0 || WorkerThreadPool::get_singleton()->is_task_completed(_task); }

// The engine wants every task waited for, also one that is done.
void PCGCity::wait_for_task() {
	if (_task >= 0) {
		WorkerThreadPool::get_singleton()->wait_for_task_completion(_task);
		_task = -1;
	}
}

void PCGCity::begin_building() {
	note_seconds("lots");
	_stage = Stage::Building;
	tear_down();
	_state_in_scene = _job->state;
	_edits.follow(_state_in_scene);
	_edits.forget_ids();
	_builder = std::make_unique<CityBuilder>(this, _job->state->city, _collision);
}

void PCGCity::build_slice() {
	const Slice slice;
	double before = 0.0;
	for (double work = _builder->next_work(); _builder->build_next(); work = _builder->next_work()) {
		const double now = slice.seconds();
		_built_seconds += now - before;
		_built_work += work;
		before = now;
		if (_is_async && slice.is_over(_builder->next_work() * _built_seconds / _built_work)) {
			tell_progress(_builder->progress());
			return;
		}
	}
	tell_progress(1.0);
	note_seconds("scene");
	begin_baking();
}

void PCGCity::begin_baking() {
	_stage = Stage::Baking;
	update_model();
	_edits.remove_unclaimed();
	_ground = std::make_unique<CityGround>(_job->state, bake_settings(), _edits.patches());
	_baker = std::make_unique<TileBaker>(_job->state->city, bake_settings());
	_job->state->regions.resize(_baker->tile_count());
	_next_bake = _next_tile = 0;
}

void PCGCity::bake_slice() {
	const Slice slice;
	const uint32_t count = uint32_t(_baker->tile_count());
	do {
		if (_next_bake < count) {
			_baker->bake(_next_bake++, _is_async);
		} else if (_next_tile < count && !_baker->is_baking(_next_tile)) {
			const Ref<NavigationMesh> mesh = _baker->finish(_next_tile);
			_builder->add_region(_next_tile, mesh);
			_job->state->regions[_next_tile++] = from_godot(mesh);
		} else {
			break;
		}
	} while (!slice.is_over());
	tell_progress(double(_next_tile) / double(std::max<uint32_t>(1, count)));
	if (_next_tile == count) {
		note_seconds("navigation");
		_baker.reset();
		update_model(); // the model is read from now on
		start_task(Stage::Joining);
	}
}

void PCGCity::finish() {
	note_seconds("distances");
	_diagnostics.append(_job->diagnostics);
	_state = _job->state;
	_edits.mark_reach(_job->entrance_reach, _job->zone_reach);
	report(_diagnostics);
	update_configuration_warnings();
	end(!_diagnostics.has_errors());
	adopt_lost_nodes();
	update_model();
}

void PCGCity::fail() {
	_diagnostics.append(_job->diagnostics);
	report(_diagnostics);
	end(false);
	tear_down();
}

void PCGCity::note_seconds(const char *stage) {
	const auto now = std::chrono::steady_clock::now();
	_seconds[stage] = std::chrono::duration<double>(now - _stage_start).count();
	_stage_start = now;
}

void PCGCity::tell_progress(double fraction) {
	static constexpr const char *names[] = { "idle", "lots", "scene", "navigation", "distances" };
	emit_signal("generation_progressed", names[int(_stage)], fraction);
}

} // namespace pcg
