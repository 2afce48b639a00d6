// Lives many days of many people with every promise checked, first undisturbed, then with a game that meddles: it drags benches, takes people over
// and gives them back, inserts entries, has all agendas written anew, jumps in time, and every day saves everything and goes on from what it loads. See ./dev soak.
//
//   soak DAYS PERSONS SEED
#include <cstdio>
#include <cstdlib>
#include <memory>

#include <sys/resource.h>

#include "core/agenda/agenda_edit.h"
#include "core/io/household_csv.h"
#include "core/io/rule_loader.h"
#include "core/io/state_file.h"
#include "core/navigation/straight_line_paths.h"
#include "core/population/population_generator.h"
#include "core/sim/dialect.h"
#include "core/sim/invariants.h"
#include "tests/soak/soak_city.h"

using namespace pcg;

namespace {

constexpr const char *rules = "rules/agenda/mixed_week.pcg";
constexpr const char *households = "rules/data/households_us_acs2023.csv";
// Memory may grow by this factor at most from then on: every day of the week has been lived by then, and the oldest insertions were forgotten.
constexpr double most_growth = 1.25;
constexpr int64_t settled_days = 16;
constexpr int64_t remembered_days = 7; // more than jumps go back

struct World {
	CityModel city;
	std::shared_ptr<const Program> program;
	Population population;
	AgendaSet agendas;
};

void write_agendas(World &world, uint64_t seed, Diagnostics &diagnostics) {
	AgendaOptions options;
	options.seed = seed;
	const StraightLinePaths paths(world.city);
	world.agendas = generate_agendas(*world.program, world.city, paths, world.population, options, diagnostics);
}

bool build(World &world, uint32_t persons, uint64_t seed, Diagnostics &diagnostics) {
	soak::build_city(world.city, seed, persons / 5 + 30);
	world.program = load_program(rules, pcg_dialect(), diagnostics);
	const std::optional<HouseholdTable> table = read_household_table(households, diagnostics);
	if (!world.program || !table) {
		return false;
	}
	PopulationOptions people;
	people.persons = persons;
	people.seed = seed;
	world.population = generate_population(*table, world.city, people, diagnostics);
	write_agendas(world, seed, diagnostics);
	return !diagnostics.has_errors();
}

double resident_mb() {
	rusage usage{};
	getrusage(RUSAGE_SELF, &usage);
	return double(usage.ru_maxrss) / 1024.0;
}

class Soak {
public:
	Soak(World world, bool is_meddled, uint64_t seed) : _world(std::move(world)), _paths(_world.city), _is_meddled(is_meddled), _random(seed, 4) {
		_settings.seed = seed;
		_settings.has_live_bodies = false;
		make_simulation();
		_simulation->start(SimTime{});
	}

	// False if a promise was broken, loading failed, or memory grows and grows.
	bool run(int64_t days) {
		double settled_mb = 0.0;
		for (int64_t day = 0; day < days; ++day) {
			const SimTime reload = SimTime::at(day, Duration{ int64_t(_random.index(uint64_t(one_day.ms))) });
			live_until(reload);
			if (_is_meddled && !save_and_load()) {
				return false;
			}
			live_until(SimTime::at(day + 1, {}));
			forget_days_before(_world.agendas, day - remembered_days);
			settled_mb = day < settled_days ? resident_mb() : settled_mb;
			if (day % 5 == 4 || day + 1 == days) {
				tell(day + 1);
			}
		}
		end_checks();
		const bool is_growing = days > settled_days && resident_mb() > settled_mb * most_growth;
		if (is_growing) {
			std::printf("  memory grew from %.0f MB to %.0f MB\n", settled_mb, resident_mb());
		}
		std::printf("  %llu broken promises; %llu children whom nobody came for went alone\n", (unsigned long long)_broken,
				(unsigned long long)_excused);
		return _broken == 0 && !is_growing;
	}

private:
	void make_simulation() {
		_checker.reset();
		_simulation = std::make_unique<Simulation>(_world.city, _paths, _world.population, _world.agendas, _world.program, _settings, _host);
		_checker = std::make_unique<InvariantChecker>(*_simulation);
	}

	void live_until(SimTime end) {
		while (_simulation->now() < end) {
			const Duration step{ 1 + int64_t(_random.index(600'000)) };
			_simulation->advance_to(std::min(_simulation->now() + step, end));
			_checker->check();
			if (_is_meddled) {
				meddle();
			}
		}
	}

	void meddle() {
		const PersonId id = PersonId(uint32_t(_random.index(_simulation->person_count())));
		const ObjectId bench = ObjectId(uint32_t(_random.index(_world.city.objects().size())));
		switch (_random.index(12)) {
			case 0:
				_world.city.move_object(bench, _world.city.object(bench).position + glm::vec3(float(_random.uniform(-3, 3)), 0, float(_random.uniform(-3, 3))));
				break;
			case 1:
				_simulation->take_over(id);
				_taken.push_back(id);
				break;
			case 2:
				give_back();
				break;
			case 3:
				insert(id);
				break;
			case 4:
				if (_random.chance(0.02)) {
					_simulation->jump_to(_simulation->now() - Duration{ int64_t(_random.index(20'000'000)) });
				}
				break;
			case 5:
				if (_random.chance(0.02)) {
					renew_agendas();
				}
				break;
			default:
				break;
		}
	}

	// Somewhere else, as a game would.
	void give_back() {
		if (!_taken.empty()) {
			const glm::vec3 away{ float(_random.uniform(-50, 50)), 0.0f, float(_random.uniform(-50, 50)) };
			_simulation->place_taken(_taken.back(), _simulation->position(_taken.back()) + away);
			_simulation->release(_taken.back());
			_taken.pop_back();
		}
	}

	void insert(PersonId id) {
		const SimTime start = _simulation->now() + Duration{ int64_t(_random.index(7'200'000)) };
		Task task;
		task.start_ms = int32_t(start.time_of_day().ms);
		task.end_ms = task.start_ms + 600'000 + int32_t(_random.index(3'600'000));
		task.target = uint32_t(_random.index(_world.city.buildings().size()));
		for (PersonId changed : insert_task(_world.agendas, _world.population, id, task, start.day()).changed) {
			_simulation->take_in_agenda(changed);
		}
	}

	// Goes on in another simulation with what the file holds, people included.
	bool save_and_load() {
		const std::string bytes = state_file_bytes(*_simulation);
		Diagnostics diagnostics;
		std::optional<StateFile> file = read_state_file(bytes, "saved", diagnostics);
		end_checks();
		_checker.reset();
		_simulation.reset();
		if (file) {
			_world.population = std::move(file->people.population);
			_world.agendas = std::move(file->people.agendas);
			make_simulation();
			if (_simulation->restore(file->simulation, diagnostics) && state_file_bytes(*_simulation) == bytes) {
				return true;
			}
		}
		std::printf("  a state could not be loaded, or came back as another one\n%s", to_text(diagnostics).c_str());
		return false;
	}

	// Adds up what the checker found.
	void end_checks() {
		_simulation->flush_lived();
		_checker->finish();
		_excused += _checker->children_alone_after_waiting();
		_broken += _checker->broken_total();
		for (const std::string &example : _checker->examples()) {
			std::printf("  %s\n", example.c_str());
		}
	}

	void tell(int64_t days) const {
		const SimulationStatistics &figures = _simulation->statistics();
		std::printf("  day %lld: %llu trips, %llu late, %llu waited in vain, peak %u outside, %.0f MB\n", (long long)days,
				(unsigned long long)figures.trips, (unsigned long long)figures.late_arrivals,
				(unsigned long long)figures.count(SimEventKind::PatienceRanOut), figures.peak_outside, resident_mb());
		std::fflush(stdout);
	}

	// By the same rules: nobody may notice but those who had something inserted, or did what a rule says.
	void renew_agendas() {
		Diagnostics diagnostics;
		_simulation->change_agendas([&] {
			write_agendas(_world, _settings.seed, diagnostics);
			return _world.program;
		});
	}

	World _world;
	StraightLinePaths _paths;
	bool _is_meddled;
	Random _random;
	SimulationSettings _settings;
	AgentHost _host;
	std::unique_ptr<Simulation> _simulation;
	std::unique_ptr<InvariantChecker> _checker;
	std::vector<PersonId> _taken;
	uint64_t _broken = 0, _excused = 0;
};

} // namespace

int main(int argc, char **argv) {
	const auto number = [&](int i, long long fallback) { return argc > i ? std::atoll(argv[i]) : fallback; };
	const int64_t days = number(1, 30);
	const uint32_t persons = uint32_t(number(2, 2000));
	const uint64_t seed = uint64_t(number(3, 1));
	bool is_good = true;
	for (const bool is_meddled : { false, true }) {
		World world;
		Diagnostics diagnostics;
		if (!build(world, persons, seed, diagnostics)) {
			std::fputs(to_text(diagnostics).c_str(), stderr);
			return 1;
		}
		std::printf("%zu persons, %lld days, %s\n", world.population.persons.size(), (long long)days, is_meddled ? "with a game that meddles" : "undisturbed");
		const bool is_kept = Soak(std::move(world), is_meddled, seed).run(days);
		std::printf("  %s\n", is_kept ? "all promises kept" : "PROMISES BROKEN");
		is_good = is_good && is_kept;
	}
	return is_good ? 0 : 1;
}
