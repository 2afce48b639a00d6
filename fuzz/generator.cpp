#include "core/agenda/agenda_generator.h"

#include "core/navigation/straight_line_paths.h"
#include "core/sim/dialect.h"
#include "core/sim/simulation.h"
#include "fuzz/fuzz.h"
#include "fuzz/street.h"

using namespace pcg;

// The rules write three households' agendas, which are lived for a day.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
	static const fuzz::Street street;
	Diagnostics diagnostics;
	const auto program = fuzz::load(fuzz::text_of(data, size), pcg_dialect(), diagnostics);
	if (program == nullptr) {
		return 0;
	}
	const StraightLinePaths paths(street.city);
	AgendaOptions options;
	options.seed = size;
	options.limits.max_steps = 5'000;
	options.limits.max_silent_steps = 5'000;
	options.limits.max_depth = 100;
	options.limits.max_native_depth = 40;
	options.work.threads = 1;
	const AgendaSet agendas = generate_agendas(*program, street.city, paths, street.population, options, diagnostics);
	AgentHost host;
	SimulationSettings settings;
	settings.seed = options.seed;
	Simulation simulation(street.city, paths, street.population, agendas, program, settings, host);
	simulation.start(SimTime::at(0, Duration::hours(5)));
	simulation.advance_to(SimTime::at(0, Duration::hours(20)));
	simulation.jump_to(SimTime::at(1, Duration::hours(8)));
	to_text(diagnostics);
	return 0;
}
