#include "core/agenda/agenda_generator.h"
#include "core/navigation/straight_line_paths.h"
#include "core/sim/dialect.h"
#include "core/sim/saved_people.h"
#include "core/sim/simulation.h"
#include "fuzz/fuzz.h"
#include "fuzz/street.h"

using namespace pcg;

namespace {

constexpr const char *rules =
		"@StartRule Household --> members { age < 18: Child | age < 65: Adult | true: Elder }"
		" Child --> stayInside(0h, 24h, home) stayInside(9h, 15h, findBuilding(\"school\"))"
		" Adult --> stayInside(0h, 24h, home) case count(age < 18) > 0: accompany(9h, age < 18) delayedRule(13h, 18h, Park)"
		" else: floatingSlot(10h, 19h) floatingTask(20m, Errand) floatingTask(1h, Park)"
		" Elder --> stayInside(0h, 24h, home) delayedRule(8h, 20h, Park)"
		" Park --> wait(rand(0, 90)) goToZone(\"park\") set(bench, findObject(\"bench\", 60))"
		" case isValid(bench): goToObject(bench) interact(bench, \"sit\") waitUntilNextTask() else: wait(10m) Park"
		" Errand --> set(shop, findBuilding(\"shop\")) goToBuilding(shop) stayInside(rand(2m, 20m)) goToBuilding(home)";

// The street with its days written once, and its state saved at every full hour of one.
struct SavedStreet {
	fuzz::Street street;
	StraightLinePaths paths{ street.city };
	Diagnostics diagnostics;
	std::shared_ptr<const Program> program = fuzz::load(rules, pcg_dialect(), diagnostics);
	AgendaSet agendas;
	AgentHost host;
	std::vector<std::string> states;
	std::string people;

	SavedStreet() {
		if (!program) {
			fputs(to_text(diagnostics).c_str(), stderr);
			abort();
		}
		AgendaOptions options;
		options.work.threads = 1;
		agendas = generate_agendas(*program, street.city, paths, street.population, options, diagnostics);
		Simulation simulation(street.city, paths, street.population, agendas, program, {}, host);
		simulation.start(SimTime::at(0, Duration{}));
		for (int hour = 0; hour < 24; ++hour) {
			simulation.advance_to(SimTime::at(0, Duration::hours(hour)));
			states.push_back(simulation.save());
		}
		people = people_to_bytes(street.population, agendas);
	}
};

// Bytes that stay the right number, for a state of the wrong length is refused at once: each three are a place and what stands there now.
void damage(std::string &bytes, const uint8_t *data, size_t size) {
	for (size_t i = 0; i + 2 < size; i += 3) {
		bytes[(data[i] * 256u + data[i + 1]) % bytes.size()] = char(data[i + 2]);
	}
}

} // namespace

// The first byte says which hour's state is damaged (from 24 on: the people), the others how. What is not refused is lived for a day.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
	static const SavedStreet saved;
	if (size == 0) {
		return 0;
	}
	if (data[0] >= 24) {
		std::string bytes = saved.people;
		damage(bytes, data + 1, size - 1);
		SavedPeople people;
		people_from_bytes(bytes, people);
		return 0;
	}
	std::string bytes = saved.states[data[0]];
	damage(bytes, data + 1, size - 1);
	AgentHost host;
	Diagnostics diagnostics;
	Simulation simulation(saved.street.city, saved.paths, saved.street.population, saved.agendas, saved.program, {}, host);
	if (simulation.restore(bytes, diagnostics)) {
		simulation.step(Duration::hours(24));
		simulation.save();
	}
	to_text(diagnostics);
	return 0;
}
