// The simulation alone, on straight lines: 100,000 persons in 10,000 buildings who go to work or school, shop and come home; and the same for
// 1,000, 10,000 and a million, to see what a person costs. life_bench has rules that run, groups and seats.
// Peer: SUMO, whose non-interacting persons take 6.8 s for 12 h of 20,000 (in persons x hours a second).
#include <algorithm>
#include <cmath>
#include <string>

#include "bench/living.h"
#include "core/base/random.h"
#include "core/navigation/straight_line_paths.h"
#include "core/sim/simulation.h"

using namespace pcg;

namespace {

constexpr uint32_t persons_per_building = 10;
constexpr uint32_t household_size = 2;
constexpr double sumo_person_hours_per_second = 20'000.0 * 12.0 / 6.8;
constexpr int32_t minute = 60'000;

// Buildings stand 30 m apart on a square.
uint32_t side_of(uint32_t building_count) { return uint32_t(std::ceil(std::sqrt(double(building_count)))); }

void build_city(CityModel &city, uint32_t building_count) {
	const TypeId type = city.types.add("house");
	const uint32_t side = side_of(building_count);
	for (uint32_t i = 0; i < building_count; ++i) {
		Entrance entrance;
		entrance.building = city.add_building();
		entrance.type = type;
		entrance.position = { float(i % side) * 30.0f, 0.0f, float(i / side) * 30.0f };
		city.add_entrance(entrance);
	}
}

void build_population(Population &population, uint32_t person_count, Random &random) {
	const uint32_t building_count = person_count / persons_per_building;
	for (uint32_t i = 0; i < person_count; ++i) {
		if (i % household_size == 0) {
			Household household;
			household.home = BuildingId(uint32_t(random.index(building_count)));
			household.first_member = PersonId(i);
			household.member_count = household_size;
			population.households.push_back(household);
		}
		Person person;
		person.household = HouseholdId(i / household_size);
		person.walking_speed = float(random.uniform(0.9, 1.6));
		population.persons.push_back(person);
	}
}

void add(AgendaSet &agendas, TaskKind kind, int32_t start, int32_t end, BuildingId target) {
	Task task;
	task.kind = kind;
	task.start_ms = start;
	task.end_ms = end;
	task.target = index_of(target);
	agendas.tasks.push_back(task);
}

// One of the 10,000 buildings around this one.
BuildingId find_near(BuildingId home, uint32_t building_count, Random &random) {
	constexpr uint32_t reach = 100;
	const uint32_t side = side_of(building_count), width = std::min(side, reach);
	const auto around = [&](uint32_t at) { return std::min(at > reach / 2 ? at - reach / 2 : 0, side - width) + uint32_t(random.index(width)); };
	const uint32_t x = around(index_of(home) % side), z = around(index_of(home) / side);
	return BuildingId(std::min(z * side + x, building_count - 1));
}

// Home, work, a shop on the way, home, with times that differ from person to person.
void build_agendas(const Population &population, AgendaSet &agendas, Random &random) {
	const uint32_t building_count = uint32_t(population.persons.size()) / persons_per_building;
	for (uint32_t i = 0; i < population.persons.size(); ++i) {
		const BuildingId home = population.home_of(PersonId(i));
		const BuildingId work = find_near(home, building_count, random);
		const BuildingId shop = find_near(home, building_count, random);
		const int32_t leave = 420 * minute + int32_t(random.index(90 * minute));
		const int32_t shopping = 960 * minute + int32_t(random.index(90 * minute));
		agendas.first_task.push_back(uint32_t(agendas.tasks.size()));
		agendas.first_floating_task.push_back(0);
		add(agendas, TaskKind::StayInside, 0, leave, home);
		add(agendas, TaskKind::GoToBuilding, leave, leave + 40 * minute, work);
		add(agendas, TaskKind::StayInside, leave + 40 * minute, shopping, work);
		add(agendas, TaskKind::GoToBuilding, shopping, shopping + 60 * minute, shop);
		add(agendas, TaskKind::StayInside, shopping + 60 * minute, 1440 * minute, home);
	}
	agendas.first_task.push_back(uint32_t(agendas.tasks.size()));
	agendas.first_floating_task.push_back(0);
}

void measure(uint32_t person_count, const std::string &name) {
	Random random(1);
	CityModel city;
	Population population;
	AgendaSet agendas;
	AgentHost host;
	build_city(city, person_count / persons_per_building);
	build_population(population, person_count, random);
	build_agendas(population, agendas, random);
	const StraightLinePaths paths(city);
	SimulationSettings settings;
	settings.has_live_bodies = false;
	Simulation simulation(city, paths, population, agendas, nullptr, settings, host);

	bench::measure_life(simulation, name, Duration::minutes(10), sumo_person_hours_per_second);
}

} // namespace

int main() {
	measure(1'000, "sim_1k");
	measure(10'000, "sim_10k");
	measure(100'000, "sim_100k");
	measure(1'000'000, "sim_1m");
	bench::print("sim_bytes_per_person", double(sizeof(PersonRecord)), "B");
	return 0;
}
