// How fast agendas are written: the shipped weekday rules on 2,000 buildings, all distances known. Prints a JSON object for each figure. The bar is a
// million agendas a second on one core; the peers are an equivalent generator written by hand, for LuaJIT and for plain Lua, and SUMO's activitygen.
//
// `agenda_bench PERSONS` writes the agendas of so many persons once and prints how many there are: for counting instructions with callgrind, as
// tools/run_bench.py does.

#include <cmath>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <memory>
#include <vector>

#include "bench/figure.h"
#include "core/agenda/agenda_generator.h"
#include "core/io/household_csv.h"
#include "core/io/rule_loader.h"
#include "core/navigation/straight_line_paths.h"
#include "core/population/population_generator.h"
#include "core/sim/dialect.h"

using namespace pcg;

namespace {

constexpr double bar_agendas_per_second = 1'000'000.0;
constexpr double luajit_agendas_per_second = 595'000.0, lua_agendas_per_second = 209'000.0, sumo_agendas_per_second = 28'000.0;
constexpr double bar_bytes_per_person = 200.0;

struct TypeShare {
	const char *type;
	size_t count;
	uint32_t capacity;
};

// 2,000 buildings on a square of 45 by 45, 40 m apart, types mixed.
CityModel make_city() {
	constexpr TypeShare shares[] = { { "house", 1400, 100 }, { "workplace", 480, 0 }, { "school", 40, 0 }, { "shop", 80, 0 } };
	std::vector<const TypeShare *> types;
	for (const TypeShare &share : shares) {
		types.insert(types.end(), share.count, &share);
	}
	Random random(1, 1);
	for (size_t i = types.size(); i > 1; --i) {
		std::swap(types[i - 1], types[random.index(i)]);
	}
	CityModel city;
	for (size_t i = 0; i < types.size(); ++i) {
		Entrance entrance;
		entrance.building = city.add_building();
		entrance.type = city.types.add(types[i]->type);
		entrance.capacity = types[i]->capacity;
		entrance.position = { float(i % 45) * 40.0f, 0.0f, float(i / 45) * 40.0f };
		city.add_entrance(entrance);
	}
	return city;
}

// Answers from a table, as a navigation does that has learnt all distances.
class KnownPaths : public StraightLinePaths {
public:
	explicit KnownPaths(const CityModel &city) : StraightLinePaths(city), _count(city.buildings().size()) {
		_distance.resize(_count * _count);
		for (size_t i = 0; i < _distance.size(); ++i) {
			_distance[i] = float(StraightLinePaths::distance(BuildingId(uint32_t(i / _count)), BuildingId(uint32_t(i % _count))));
		}
		_nearest.resize(city.types.size() * _count);
		for (size_t i = 0; i < _nearest.size(); ++i) {
			_nearest[i] = StraightLinePaths::nearest_building(TypeId(uint32_t(i / _count)), BuildingId(uint32_t(i % _count)));
		}
	}
	double distance(BuildingId from, BuildingId to) const override { return double(_distance[index_of(from) * _count + index_of(to)]); }
	BuildingId nearest_building(TypeId type, BuildingId from) const override { return _nearest[index_of(type) * _count + index_of(from)]; }

private:
	size_t _count;
	std::vector<float> _distance;
	std::vector<BuildingId> _nearest;
};

// Processor time of the one thread, so that other work on the machine does not count.
double seconds_since(std::clock_t start) { return double(std::clock() - start) / double(CLOCKS_PER_SEC); }

double wall_seconds(const std::function<void()> &work) {
	const auto start = std::chrono::steady_clock::now();
	work();
	return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Of one person, as the simulation keeps it.
double bytes_of(const Population &population, const AgendaSet &agendas) {
	double bytes = double(population.persons.size()) * (sizeof(Person) + 2 * sizeof(uint32_t)) + double(population.households.size() * sizeof(Household));
	bytes += double(agendas.tasks.size() * sizeof(Task) + agendas.floating_tasks.size() * sizeof(FloatingTask));
	for (const Group &group : agendas.groups) {
		bytes += double(sizeof(Group) + group.joiners.size() * sizeof(PersonId));
	}
	return bytes / double(population.persons.size());
}

// Best of five, in processor time of one thread and in wall time of one and of two.
struct Times {
	double processor = 1e9, one_thread = 1e9, two_threads = 1e9;
};

Times measure(AgendaOptions options, const std::function<void(const AgendaOptions &)> &generate) {
	Times times;
	for (int i = 0; i < 5; ++i) {
		options.work.threads = 1;
		const std::clock_t start = std::clock();
		times.one_thread = std::fmin(times.one_thread, wall_seconds([&] { generate(options); }));
		times.processor = std::fmin(times.processor, seconds_since(start));
		options.work.threads = 2;
		times.two_threads = std::fmin(times.two_threads, wall_seconds([&] { generate(options); }));
	}
	return times;
}

} // namespace

int main(int count, char **arguments) {
	Diagnostics diagnostics;
	const CityModel city = make_city();
	const std::optional<HouseholdTable> table = read_household_table("rules/data/households_us_acs2023.csv", diagnostics);
	const auto program = load_program("rules/agenda/weekday.pcg", pcg_dialect(), diagnostics);
	if (!table || !program) {
		std::fprintf(stderr, "%s\nrun this in the folder that holds rules/\n", to_text(diagnostics).c_str());
		return 1;
	}
	std::unique_ptr<KnownPaths> paths;
	const double learning_seconds = wall_seconds([&] { paths = std::make_unique<KnownPaths>(city); });
	PopulationOptions people;
	people.persons = count > 1 ? uint32_t(std::strtoul(arguments[1], nullptr, 10)) : 100'000;
	const std::clock_t population_start = std::clock();
	const Population population = generate_population(*table, city, people, diagnostics);
	const double population_seconds = seconds_since(population_start);
	const double persons = double(population.persons.size());
	AgendaSet agendas;
	const auto generate = [&](const AgendaOptions &options) { agendas = generate_agendas(*program, city, *paths, population, options, diagnostics); };
	if (count > 1) {
		AgendaOptions options;
		options.work.threads = 1;
		generate(options);
		std::printf("%.0f\n", persons);
		return 0;
	}
	const Times times = measure({}, generate);
	std::fputs(to_text(diagnostics).c_str(), stderr);
	const double agendas_per_second = persons / times.processor;
	bench::print("agenda.generated_per_second", agendas_per_second, "agendas/s/core", bar_agendas_per_second);
	bench::print("agenda.beside_luajit", agendas_per_second, "agendas/s/core", luajit_agendas_per_second);
	bench::print("agenda.beside_lua", agendas_per_second, "agendas/s/core", lua_agendas_per_second);
	bench::print("agenda.beside_sumo", agendas_per_second, "agendas/s/core", sumo_agendas_per_second);
	bench::print("agenda.two_threads", times.one_thread / times.two_threads, "x", 2.0);
	bench::print("agenda.distances_learnt", learning_seconds, "s", 1.6);
	bench::print("agenda.bytes_per_person", bytes_of(population, agendas), "B", bar_bytes_per_person);
	bench::print("population.drawn_per_second", persons / population_seconds, "persons/s/core");
	return 0;
}
