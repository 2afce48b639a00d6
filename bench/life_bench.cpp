// The simulation with all that the shipped weekday asks of it: groups that walk to school, delayed rules, benches that are taken; 100,000 persons in
// 10,000 buildings, and a million in 100,000, on straight lines. Memory is that of the whole program: city, people, agendas and simulation; a million
// may take 1 GB, 10^9 bytes. Peer: SUMO, as in sim_bench. Arguments: numbers of persons.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bench/living.h"
#include "core/agenda/agenda_generator.h"
#include "core/io/household_csv.h"
#include "core/io/rule_loader.h"
#include "core/navigation/straight_line_paths.h"
#include "core/population/population_generator.h"
#include "core/sim/dialect.h"

using namespace pcg;

namespace {

constexpr double sumo_person_hours_per_second = 20'000.0 * 12.0 / 6.8;
constexpr uint32_t persons_per_building = 10;
constexpr uint32_t quarter_side = 20; // buildings; each quarter has a school, shops and a park of its own
constexpr float apart = 30.0f; // metres

// Finds the nearest one in the quarter of the home, as a navigation does that has learnt the distances; all quarters are alike.
class QuarterPaths : public StraightLinePaths {
public:
	explicit QuarterPaths(const CityModel &city) : StraightLinePaths(city), _city(city) {}

	BuildingId nearest_building(TypeId type, BuildingId from) const override {
		const uint32_t first = index_of(from) / (quarter_side * quarter_side) * quarter_side * quarter_side;
		const std::vector<BuildingId> &all = _city.buildings_of_type(type);
		BuildingId nearest = BuildingId::Invalid;
		for (auto i = std::lower_bound(all.begin(), all.end(), BuildingId(first)); i != all.end() && index_of(*i) < first + quarter_side * quarter_side; ++i) {
			nearest = is_valid(nearest) && distance(from, nearest) <= distance(from, *i) ? nearest : *i;
		}
		return nearest;
	}
	ZoneId nearest_zone(TypeId type, glm::vec3 from, glm::vec3 &entry) const override {
		const float width = quarter_side * apart;
		const uint32_t across = quarters_across(_city.buildings().size());
		const uint32_t quarter = uint32_t(from.z / width) * across + uint32_t(from.x / width);
		const std::vector<ZoneId> &all = _city.zones_of_type(type);
		if (quarter >= all.size()) {
			return ZoneId::Invalid;
		}
		entry = _city.zone(all[quarter]).polygon[0];
		return all[quarter];
	}
	static uint32_t quarters_across(size_t buildings) {
		return uint32_t(std::ceil(std::sqrt(double(buildings) / (quarter_side * quarter_side))));
	}

private:
	const CityModel &_city;
};

// A park of 20 m with 8 benches for two, between the buildings.
void add_park(CityModel &city, glm::vec3 corner) {
	Zone zone;
	zone.type = city.types.add("park");
	zone.polygon = { corner, corner + glm::vec3(0, 0, 20), corner + glm::vec3(20, 0, 20), corner + glm::vec3(20, 0, 0) };
	city.add_zone(std::move(zone));
	for (int i = 0; i < 8; ++i) {
		CityObject bench;
		bench.type = city.types.add("bench");
		bench.position = corner + glm::vec3(2.0f + 2.0f * float(i), 0.0f, 10.0f);
		bench.places = { { bench.position, { 0, 0, 1 } }, { bench.position + glm::vec3(0.6f, 0, 0), { 0, 0, 1 } } };
		city.add_object(std::move(bench));
	}
}

CityModel make_city(uint32_t buildings) {
	CityModel city;
	const uint32_t quarter_size = quarter_side * quarter_side;
	const uint32_t across = QuarterPaths::quarters_across(buildings);
	for (uint32_t i = 0; i < buildings; ++i) {
		const uint32_t quarter = i / quarter_size, in_quarter = i % quarter_size;
		const uint32_t x = quarter % across * quarter_side + in_quarter % quarter_side;
		const uint32_t z = quarter / across * quarter_side + in_quarter / quarter_side;
		Entrance entrance;
		entrance.building = city.add_building();
		entrance.type = city.types.add(in_quarter == 210 ? "school" : in_quarter % 25 == 7 ? "shop" : in_quarter % 4 == 1 ? "workplace" : "house");
		entrance.position = { (float(x) + 0.5f) * apart, 0.0f, (float(z) + 0.5f) * apart };
		entrance.capacity = 100;
		city.add_entrance(entrance);
		if (in_quarter == 0) {
			add_park(city, { (float(x) + 10.0f) * apart + 5.0f, 0.0f, (float(z) + 10.0f) * apart + 5.0f });
		}
	}
	return city;
}

bool measure(const HouseholdTable &table, const std::shared_ptr<const Program> &program, uint32_t persons) {
	Diagnostics diagnostics;
	const CityModel city = make_city(persons / persons_per_building);
	const QuarterPaths paths(city);
	PopulationOptions people;
	people.persons = persons;
	const Population population = generate_population(table, city, people, diagnostics);
	const AgendaSet agendas = generate_agendas(*program, city, paths, population, {}, diagnostics);
	AgentHost host;
	SimulationSettings settings;
	settings.has_live_bodies = false;
	Simulation simulation(city, paths, population, agendas, program, settings, host);
	const std::string name = persons % 1'000'000 == 0 ? "life_" + std::to_string(persons / 1'000'000) + "m" : "life_" + std::to_string(persons / 1'000) + "k";
	bench::measure_life(simulation, name, Duration{ 0 }, sumo_person_hours_per_second);
	diagnostics.append(simulation.diagnostics());
	std::fputs(to_text(diagnostics).c_str(), stderr);
	return diagnostics.is_empty();
}

} // namespace

int main(int count, char **arguments) {
	Diagnostics diagnostics;
	const std::optional<HouseholdTable> table = read_household_table("rules/data/households_us_acs2023.csv", diagnostics);
	const auto program = load_program("rules/agenda/weekday.pcg", pcg_dialect(), diagnostics);
	if (!table || !program) {
		std::fprintf(stderr, "%s\nrun this in the folder that holds rules/\n", to_text(diagnostics).c_str());
		return 1;
	}
	std::vector<uint32_t> sizes{ 100'000, 1'000'000 };
	if (count > 1) {
		sizes.clear();
		for (int i = 1; i < count; ++i) {
			sizes.push_back(uint32_t(std::strtoul(arguments[i], nullptr, 10)));
		}
	}
	bool is_good = true;
	for (const uint32_t persons : sizes) {
		is_good = measure(*table, program, persons) && is_good;
	}
	return is_good ? 0 : 1;
}
