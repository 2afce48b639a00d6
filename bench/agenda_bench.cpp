// How fast agendas are written: the shipped weekday rules on 2,000 buildings, all distances known, one thread. Prints a JSON object for
// each figure. The peer is an equivalent generator written by hand for LuaJIT: 595,000 agendas a second (209,000 in plain Lua).

#include <cmath>
#include <cstdio>
#include <ctime>
#include <vector>

#include "core/agenda/agenda_generator.h"
#include "core/io/household_csv.h"
#include "core/io/rule_loader.h"
#include "core/navigation/straight_line_paths.h"
#include "core/population/population_generator.h"
#include "core/sim/dialect.h"

using namespace pcg;

namespace {

constexpr double luajit_agendas_per_second = 595'000.0;
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

void print_figure(const char *name, double value, const char *unit, double peer, bool is_more_better) {
	std::printf("{\"name\": \"%s\", \"value\": %.4g, \"unit\": \"%s\", \"peer\": %.4g, \"ratio\": %.3g}\n", name, value, unit, peer,
			is_more_better ? value / peer : peer / value);
}

} // namespace

int main() {
	Diagnostics diagnostics;
	const CityModel city = make_city();
	const Result<HouseholdTable> table = read_household_table("rules/data/households_us_acs2023.csv");
	const auto program = load_program("rules/agenda/weekday.pcg", pcg_dialect(), diagnostics);
	if (!table || !program) {
		std::fprintf(stderr, "%s\nrun this in the folder that holds rules/\n", to_text(diagnostics).c_str());
		return 1;
	}
	const KnownPaths paths(city);
	PopulationOptions people;
	people.persons = 100'000;
	const std::clock_t population_start = std::clock();
	const Population population = generate_population(*table, city, people, diagnostics);
	const double population_seconds = seconds_since(population_start);

	AgendaOptions options;
	options.work.threads = 1;
	double best = 1e9;
	AgendaSet agendas;
	for (int i = 0; i < 5; ++i) {
		const std::clock_t start = std::clock();
		agendas = generate_agendas(*program, city, paths, population, options, diagnostics);
		best = std::fmin(best, seconds_since(start));
	}
	if (!diagnostics.is_empty()) {
		std::fprintf(stderr, "%s\n", to_text(diagnostics).c_str());
	}
	const double persons = double(population.persons.size());
	double bytes = persons * (sizeof(Person) + 2 * sizeof(uint32_t)) + double(population.households.size() * sizeof(Household));
	bytes += double(agendas.tasks.size() * sizeof(Task) + agendas.floating_tasks.size() * sizeof(FloatingTask));
	for (const Group &group : agendas.groups) {
		bytes += double(sizeof(Group) + group.joiners.size() * sizeof(PersonId));
	}
	print_figure("agenda.generated_per_second", persons / best, "agendas/s/core", luajit_agendas_per_second, true);
	print_figure("agenda.bytes_per_person", bytes / persons, "B", bar_bytes_per_person, false);
	print_figure("population.drawn_per_second", persons / population_seconds, "persons/s/core", luajit_agendas_per_second, true);
	return 0;
}
