#include <doctest/doctest.h>

#include "core/agenda/agenda_generator.h"
#include "core/sim/invariants.h"
#include "tests/core/sim/random_rules.h"
#include "tests/core/sim/town.h"

using namespace pcg;
using namespace pcg::test;

namespace {

struct Seen {
	uint64_t trips = 0;
	uint64_t tasks = 0;
	uint64_t groups = 0;
	uint64_t behaviors = 0;
};

// A town of 15 buildings, two parks and six benches where eight households live by rules that nobody thought up.
struct RandomCity {
	Town town;
	Diagnostics diagnostics;
	std::string rules;

	explicit RandomCity(uint64_t seed) : rules(RuleWriter(seed).write()) {
		Random random(seed, 3);
		static const char *types[] = { "house", "school", "shop" };
		for (int i = 0; i < 15; ++i) {
			town.building(types[i % 3], float(random.uniform(0, 600)), float(random.uniform(0, 600)));
		}
		town.zone("park", 300.0f, 300.0f, 60.0f);
		town.zone("park", 100.0f, 500.0f, 40.0f);
		for (int i = 0; i < 6; ++i) {
			town.bench(305.0f + 9.0f * float(i), 320.0f, 1 + i % 2);
		}
		for (uint32_t i = 0; i < 8; ++i) {
			town.household(BuildingId(uint32_t(3 * random.index(5))));
			for (size_t member = 1 + random.index(4); member > 0; --member) {
				town.person(float(random.uniform(3, 90)), float(random.uniform(0.6, 1.6)));
			}
		}
		MemorySourceProvider provider;
		provider.add("random.pcg", rules);
		town.program = load_program("random.pcg", pcg_dialect(), provider, diagnostics);
	}

	AgendaSet agendas(unsigned threads) {
		AgendaOptions options;
		options.work.threads = threads;
		return generate_agendas(*town.program, town.city, town.paths, town.population, options, diagnostics);
	}
};

bool are_equal(const AgendaSet &a, const AgendaSet &b) {
	const auto is_same = [](const Task &x, const Task &y) {
		return x.start_ms == y.start_ms && x.end_ms == y.end_ms && x.kind == y.kind && x.target == y.target && x.days == y.days;
	};
	return a.first_task == b.first_task && std::equal(a.tasks.begin(), a.tasks.end(), b.tasks.begin(), b.tasks.end(), is_same);
}

// The week is a circle: what begins on Sunday and ends on Monday is looked at on Monday too.
void check_disjoint(std::span<const Task> tasks) {
	struct Stretch {
		int64_t start, end;
	};
	std::vector<Stretch> week;
	constexpr int64_t day_ms = 86'400'000, week_ms = 7 * day_ms;
	for (const Task &task : tasks) {
		CHECK(task.start_ms >= 0);
		CHECK(task.start_ms < day_ms);
		CHECK(task.end_ms > task.start_ms);
		for (int day = 0; day < 7; ++day) {
			if (task.days & (1u << day)) {
				week.push_back({ day * day_ms + task.start_ms, day * day_ms + task.end_ms });
			}
		}
	}
	std::sort(week.begin(), week.end(), [](const Stretch &a, const Stretch &b) { return a.start < b.start; });
	for (size_t i = 0; i + 1 < week.size(); ++i) {
		CHECK(week[i].end <= week[i + 1].start);
	}
	if (!week.empty()) {
		CHECK(week.back().end - week_ms <= week.front().start);
	}
}

Simulation simulation_of(RandomCity &city, const AgendaSet &agendas) {
	return { city.town.city, city.town.paths, city.town.population, agendas, city.town.program, {}, city.town.host };
}

Lines lines_of(Simulation &simulation, SimTime until, int64_t step_ms) {
	Recorder recorder;
	simulation.add_observer(recorder);
	while (simulation.now() < until) {
		simulation.advance_to(std::min(simulation.now() + Duration{ step_ms }, until));
	}
	simulation.remove_observer(recorder);
	return recorder.lines;
}

void check_promises(RandomCity &city, const AgendaSet &agendas, uint64_t seed, Seen &seen) {
	Simulation simulation = simulation_of(city, agendas);
	InvariantChecker checker(simulation);
	Random random(seed, 4);
	simulation.start(moment(0, 0));
	while (simulation.now() < moment(3, 0)) {
		simulation.step(Duration{ int64_t(random.index(600'000)) });
		checker.check();
		if (random.chance(0.005)) {
			simulation.jump_to(simulation.now() + Duration::minutes(int64_t(random.index(900)) - 200));
		}
	}
	simulation.flush_lived();
	checker.finish();
	INFO((checker.examples().empty() ? std::string() : checker.examples()[0]));
	CHECK(checker.broken_total() == 0);
	seen.trips += simulation.statistics().trips;
}

void check_repeats(RandomCity &city, const AgendaSet &agendas, uint64_t seed) {
	Simulation first = simulation_of(city, agendas), second = simulation_of(city, agendas);
	first.start(moment(4, 5));
	second.start(moment(4, 5));
	CHECK(lines_of(first, moment(4, 14), 86'400'000) == lines_of(second, moment(4, 14), 60'007));
	const std::string state = first.save();
	CHECK(second.save() == state);
	Simulation loaded = simulation_of(city, agendas);
	Diagnostics diagnostics;
	REQUIRE(loaded.restore(state, diagnostics));
	const SimTime later = moment(5, 0) + Duration::minutes(int64_t(seed % 600));
	CHECK(lines_of(first, later, 3'600'000) == lines_of(loaded, later, 86'400'000));
}

} // namespace

TEST_CASE("random rule sets give sound agendas, for any number of threads, whose days keep all promises and repeat") {
	Seen seen;
	for (uint64_t seed = 1; seed <= 300; ++seed) {
		RandomCity city(seed);
		INFO("seed " << seed << "\n" << city.rules << to_text(city.diagnostics));
		CHECK(city.town.program != nullptr);
		if (!city.town.program) {
			continue;
		}
		const AgendaSet agendas = city.agendas(1);
		CHECK(are_equal(agendas, city.agendas(3)));
		CHECK(!city.diagnostics.has_errors());
		for (size_t i = 0; i < city.town.population.persons.size(); ++i) {
			check_disjoint(agendas.tasks_of(PersonId(uint32_t(i))));
		}
		check_promises(city, agendas, seed, seen);
		check_repeats(city, agendas, seed);
		seen.tasks += agendas.tasks.size();
		seen.groups += agendas.groups.size();
		for (const Task &task : agendas.tasks) {
			seen.behaviors += task.kind == TaskKind::DelayedRule || task.kind == TaskKind::FloatingSlot;
		}
	}
	CHECK(seen.trips > 2000);
	CHECK(seen.tasks > 2000);
	CHECK(seen.groups > 50);
	CHECK(seen.behaviors > 500);
}
