#include <doctest/doctest.h>

#include "core/population/names.h"
#include "core/sim/day_story.h"
#include "tests/core/sim/town.h"

using namespace pcg;
using namespace pcg::test;

TEST_CASE("a school run reads like one") {
	Town town;
	const BuildingId home = town.building("house", 0.0f);
	const BuildingId school = town.building("school", 130.0f);
	town.household(home);
	town.person(); // alone, and never goes out
	town.household(home);
	const PersonId adult = town.person(36.0f, 1.0f);
	const PersonId child = town.person(8.0f, 1.0f);
	town.population.persons[2].name = 1;
	town.stay(child, at(8), at(16), school);
	town.accompany(adult, { child }, at(7, 50), at(8), school);
	Simulation &simulation = town.simulate();
	LivedLog log;
	simulation.add_observer(log);
	simulation.start(moment(0, 0));
	simulation.advance_to(moment(0, 12));
	simulation.flush_lived();

	CHECK(choose_household(town.population, log) == HouseholdId(1));
	const std::string a(first_names(Gender::Woman)[0]);
	const std::string c(first_names(Gender::Woman)[1]);
	const std::vector<std::string> story =
			tell_day(town.city, town.population, log, HouseholdId(1), moment(0, 0), moment(1, 0));
	CHECK(story == std::vector<std::string>{ "07:50 " + a + " (36) leaves home with " + c + " (8) for the school",
						   "07:52 " + a + " and " + c + " are at the school",
						   "08:00 " + a + " leaves the school for home", "08:02 " + a + " is at home" });
}
