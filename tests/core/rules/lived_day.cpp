#include "tests/core/rules/lived_day.h"

#include <vector>

#include "core/navigation/straight_line_paths.h"
#include "core/sim/lived_log.h"
#include "core/sim/simulation.h"

namespace pcg {

namespace {

std::string place_text(const LivedEntry &entry) {
	static constexpr std::string_view kinds[] = { "", "", "zone ", "object ", "person " };
	static constexpr std::string_view states[] = { "inside ", "walking to ", "at ", "waiting at " };
	const std::string state(states[size_t(entry.state)]);
	return entry.place.is_none() ? state + "nothing" : state + std::string(kinds[size_t(entry.place.kind)]) + std::to_string(entry.place.index);
}

} // namespace

std::string lived_day(const AgendaFixture &fixture, PersonId id, int day) {
	const StraightLinePaths paths(fixture.city);
	AgentHost host;
	SimulationSettings settings;
	settings.seed = fixture.options.seed;
	settings.overrides = fixture.options.overrides;
	Simulation simulation(fixture.city, paths, fixture.population, fixture.agendas, fixture.program, settings, host);
	LivedLog log;
	simulation.add_observer(log);
	simulation.start(SimTime::at(day, {}));
	simulation.advance_to(SimTime::at(day + 1, {}));
	simulation.flush_lived();
	std::vector<LivedEntry> stretches;
	for (const LivedEntry &entry : log.of(id)) {
		if (!stretches.empty() && stretches.back().state == entry.state && stretches.back().place == entry.place) {
			stretches.back().end = entry.end;
		} else if (entry.start < entry.end) {
			stretches.push_back(entry);
		}
	}
	std::string text;
	for (const LivedEntry &entry : stretches) {
		text += (text.empty() ? "" : "; ") + clock_text(entry.start - SimTime::at(day, {}), true) + "-" + clock_text(entry.end - SimTime::at(day, {}), true) + " " +
				place_text(entry);
	}
	return text;
}

} // namespace pcg
