#include <doctest/doctest.h>

#include <set>

#include "agenda_fixture.h"
#include "core/io/household_csv.h"
#include "core/population/population_generator.h"
#include "core/sim/invariants.h"

using namespace pcg;

// Every rule set in rules/agenda is lived for a week in a small town: no promise of the simulation may break.
namespace {

void add_park(CityModel &city, std::string_view type, float x, float z) {
	Zone zone;
	zone.type = city.types.add(type);
	zone.polygon = { { x, 0.0f, z }, { x, 0.0f, z + 30.0f }, { x + 30.0f, 0.0f, z + 30.0f }, { x + 30.0f, 0.0f, z } };
	city.add_zone(std::move(zone));
	for (float seat = 0.0f; seat < 4.0f; ++seat) {
		CityObject bench;
		bench.type = city.types.add("bench");
		bench.position = { x + 5.0f + 5.0f * seat, 0.0f, z + 15.0f };
		bench.places = { { bench.position, { 0.0f, 0.0f, 1.0f } }, { bench.position + glm::vec3(0.6f, 0.0f, 0.0f), { 0.0f, 0.0f, 1.0f } } };
		city.add_object(std::move(bench));
	}
}

// 14 by 14 buildings 50 m apart, every type that the rules ask for, two parks and a square.
AgendaFixture make_town(uint32_t persons) {
	AgendaFixture fixture;
	for (int i = 0; i < 196; ++i) {
		const char *type = i % 31 == 7 ? "school" : i % 23 == 5 ? "restaurant" : i % 17 == 3 ? "shop" : i % 4 == 1 ? "workplace" : "house";
		Entrance entrance;
		entrance.building = fixture.city.add_building();
		entrance.type = fixture.city.types.add(type);
		entrance.position = { 50.0f * float(i % 14), 0.0f, 50.0f * float(i / 14) };
		entrance.capacity = 12;
		fixture.city.add_entrance(entrance);
	}
	add_park(fixture.city, "park", 110.0f, 110.0f);
	add_park(fixture.city, "park", 510.0f, 460.0f);
	add_park(fixture.city, "plaza", 310.0f, 310.0f);
	const std::optional<HouseholdTable> table = read_household_table("rules/data/households_us_acs2023.csv", fixture.diagnostics);
	REQUIRE(table.has_value());
	PopulationOptions people;
	people.persons = persons;
	fixture.population = generate_population(*table, fixture.city, people, fixture.diagnostics);
	return fixture;
}

struct Week {
	uint64_t trips = 0;
	uint64_t broken = 0;
	uint64_t run_out_of_patience = 0;
	std::string examples;
};

Week live(AgendaFixture &fixture) {
	const StraightLinePaths paths(fixture.city);
	AgentHost host;
	Simulation simulation(fixture.city, paths, fixture.population, fixture.agendas, fixture.program, {}, host);
	InvariantChecker checker(simulation);
	simulation.start(SimTime::at(0, {}));
	for (int quarter = 0; quarter < 7 * 24 * 4; ++quarter) {
		simulation.step(Duration::minutes(15));
		checker.check();
	}
	simulation.flush_lived();
	checker.finish();
	Week week;
	week.trips = simulation.statistics().trips;
	week.run_out_of_patience = simulation.statistics().count(SimEventKind::PatienceRanOut);
	week.broken = checker.broken_total();
	for (const std::string &example : checker.examples()) {
		week.examples += example + "\n";
	}
	CHECK(to_text(simulation.diagnostics()) == "");
	return week;
}

void check_week(const std::string &file, const std::set<std::string> &allowed_warnings = {}) {
	INFO(file);
	AgendaFixture fixture = make_town(500);
	REQUIRE(fixture.generate_file("rules/agenda/" + file));
	INFO(to_text(fixture.diagnostics));
	CHECK(fixture.diagnostics.error_count() == 0);
	for (const Diagnostic &diagnostic : fixture.diagnostics.list()) {
		CHECK(allowed_warnings.contains(std::string(diagnostic.id)));
	}
	const Week week = live(fixture);
	INFO(week.examples);
	CHECK(week.broken == 0);
	CHECK(week.run_out_of_patience == 0);
	CHECK(week.trips > 500);
}

} // namespace

TEST_CASE("a week of weekdays breaks no promise") { check_week("weekday.pcg"); }
TEST_CASE("a week of weekends breaks no promise") { check_week("weekend.pcg"); }
TEST_CASE("a mixed week breaks no promise") { check_week("mixed_week.pcg"); }
TEST_CASE("a week of school runs breaks no promise") { check_week("school_run.pcg", { "requirement-unmet" }); }
TEST_CASE("a week at the office breaks no promise") { check_week("office_lunch.pcg"); }
TEST_CASE("a week of retired people breaks no promise") { check_week("retired.pcg"); }
TEST_CASE("a week of night shifts breaks no promise") { check_week("night_shift.pcg"); }
TEST_CASE("a week of students breaks no promise") { check_week("students.pcg"); }
TEST_CASE("a week with a market day breaks no promise") { check_week("market_day.pcg", { "requirement-unmet" }); }
TEST_CASE("a week with an election breaks no promise") { check_week("election_sunday.pcg", { "requirement-unmet" }); }
TEST_CASE("a week of random walks breaks no promise") { check_week("random.pcg"); }
TEST_CASE("a week with an evacuation breaks no promise") { check_week("evacuation.pcg"); }
