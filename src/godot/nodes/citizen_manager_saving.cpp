#include <godot_cpp/core/error_macros.hpp>

#include "core/io/atomic_file.h"
#include "core/io/population_csv.h"
#include "core/io/state_file.h"
#include "core/ports/agent_host.h"
#include "godot/convert.h"
#include "godot/liveness.h"
#include "godot/nodes/citizen_manager.h"
#include "godot/nodes/pcg_city.h"
#include "godot/ports/engine_files.h"
#include "godot/report.h"

using namespace godot;

// A life that is put aside and goes on later, and people who are kept.
namespace pcg {

namespace {

// Whether it fits these people, rules and this city: tried on a simulation that nobody sees.
bool can_restore(const CitizenLife &life, const std::string &state, Diagnostics &diagnostics) {
	AgentHost nobody;
	SimulationSettings settings;
	settings.has_live_bodies = false;
	Simulation trial(life.city->city.model, *life.city->paths, life.population, life.agendas, life.program, settings, nobody);
	return trial.restore(state, diagnostics);
}

} // namespace

PackedByteArray CitizenManager::save_state() const {
	ERR_FAIL_COND_V_MSG(!is_running(), PackedByteArray(), "CitizenManager: nothing runs. Call start() before save_state(); it may be paused.");
	return is_alone("save_state") ? to_bytes(state_file_bytes(*_life->simulation)) : PackedByteArray();
}

// What is lived now ends only when all of the new life is known to be sound.
bool CitizenManager::load_state(const PackedByteArray &p_bytes) {
	const uint64_t self = get_instance_id();
	if (!is_alone("load_state")) {
		return false;
	}
	Diagnostics diagnostics;
	std::shared_ptr<CitizenLife> life;
	std::optional<StateFile> file;
	if (check_place(diagnostics)) {
		life = new_life();
		file = read_state_file(view_of(p_bytes), "saved state", diagnostics);
	}
	if (file) {
		life->population = std::move(file->people.population);
		life->agendas = std::move(file->people.agendas);
	}
	if (!file || !can_restore(*life, file->simulation, diagnostics)) {
		report(diagnostics);
		return false;
	}
	stop();
	if (!is_there(self)) {
		return false;
	}
	_diagnostics = diagnostics;
	_life = life;
	_renews_agendas = false; // that was asked for in the life that has ended
	follow_city();
	return live([&](Simulation &simulation) {
		simulation.restore(file->simulation, diagnostics);
		life->seed = simulation.settings().seed;
		life->attributes = simulation.settings().overrides;
	});
}

Error CitizenManager::save_state_file(const String &p_path) const {
	const PackedByteArray bytes = save_state();
	if (bytes.is_empty()) {
		return ERR_UNCONFIGURED; // which was told
	}
	return save_to(p_path, [&bytes](const std::string &path, Diagnostics &diagnostics) { write_file(path, view_of(bytes), diagnostics); });
}

Error CitizenManager::load_state_file(const String &p_path) {
	const Result<std::string> text = read_engine_file(p_path);
	if (!text) {
		Diagnostics diagnostics;
		diagnostics.add(text.diagnostic());
		report(diagnostics);
		return ERR_FILE_CANT_READ;
	}
	return load_state(to_bytes(*text)) ? OK : ERR_FILE_CORRUPT;
}

Ref<PCGPopulation> CitizenManager::keep_population() {
	ERR_FAIL_COND_V_MSG(!_life, Ref<PCGPopulation>(), "CitizenManager: nobody lives here yet. Call generate_population() before keep_population().");
	Ref<PCGPopulation> people;
	people.instantiate();
	people->set_source(to_godot(std::string_view(population_to_csv(_life->population))));
	set_population(people);
	return people;
}

} // namespace pcg
