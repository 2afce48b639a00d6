// The simulation alone, on straight lines: 100,000 persons in 10,000 buildings who go to work or school, shop and come home; and the same for
// 1,000, 10,000 and a million, to see what a person costs.
// Peer: SUMO, whose non-interacting persons take 6.8 s for 12 h of 20,000 (in persons x hours a second).
#include <chrono>
#include <string>

#include <sys/resource.h>

#include "bench/allocation_count.h"
#include "bench/figure.h"
#include "core/base/random.h"
#include "core/navigation/straight_line_paths.h"
#include "core/sim/simulation.h"

using namespace pcg;

namespace {

constexpr uint32_t persons_per_building = 10;
constexpr uint32_t household_size = 2;
constexpr double sumo_person_hours_per_second = 20'000.0 * 12.0 / 6.8;
constexpr int32_t minute = 60'000;

double seconds_since(std::chrono::steady_clock::time_point start) {
	return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void build_city(CityModel &city, uint32_t building_count) {
	const TypeId type = city.types.add("house");
	for (uint32_t i = 0; i < building_count; ++i) {
		Entrance entrance;
		entrance.building = city.add_building();
		entrance.type = type;
		entrance.position = { float(i % 100) * 30.0f, 0.0f, float(i / 100 % 100) * 30.0f };
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

// Home, work, a shop on the way, home, with times that differ from person to person.
void build_agendas(const Population &population, AgendaSet &agendas, Random &random) {
	const uint32_t building_count = uint32_t(population.persons.size()) / persons_per_building;
	for (uint32_t i = 0; i < population.persons.size(); ++i) {
		const BuildingId home = population.home_of(PersonId(i));
		const BuildingId work = BuildingId(uint32_t(random.index(building_count)));
		const BuildingId shop = BuildingId(uint32_t(random.index(building_count)));
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

// 60 frames a second at 60 times real time, when the most are on their way.
void measure_peak(Simulation &simulation, const std::string &name) {
	simulation.jump_to(SimTime::at(0, Duration::hours(8)));
	simulation.step(Duration::minutes(10));
	constexpr int frames = 600;
	const uint64_t before = bench::heap.allocations;
	const auto start = std::chrono::steady_clock::now();
	for (int frame = 0; frame < frames; ++frame) {
		simulation.step(Duration::seconds(1.0));
	}
	bench::print(name + "_frame_at_peak", seconds_since(start) / frames * 1000.0, "ms");
	bench::print(name + "_allocations_per_frame", double(bench::heap.allocations - before) / frames, "allocations");
}

double resident_mb() {
	rusage usage{};
	getrusage(RUSAGE_SELF, &usage);
	return double(usage.ru_maxrss) / 1024.0;
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

	auto start = std::chrono::steady_clock::now();
	simulation.start(SimTime{});
	bench::print(name + "_start", seconds_since(start), "s");
	start = std::chrono::steady_clock::now();
	simulation.advance_to(SimTime::at(1, {}));
	const double day = seconds_since(start);
	bench::print(name + "_day", day, "s");
	bench::print(name + "_person_hours_per_second", person_count * 24.0 / day, "person h/s", sumo_person_hours_per_second);
	bench::print(name + "_trips", double(simulation.statistics().trips), "trips");
	start = std::chrono::steady_clock::now();
	simulation.jump_to(SimTime::at(2, Duration::hours(8)));
	bench::print(name + "_jump", seconds_since(start) * 1000.0, "ms");
	measure_peak(simulation, name);
	bench::print(name + "_memory", resident_mb(), "MB");
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
