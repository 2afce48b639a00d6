#include <doctest/doctest.h>

#include "core/base/random.h"
#include "core/sim/simulation.h"
#include "tests/core/sim/town.h"

using namespace pcg;
using namespace pcg::test;

namespace {

// Forty persons who go to one place after the other all day, with some chains of walks that are too long for their entries.
void fill_with_walkers(Town &town) {
	Random random(5);
	std::vector<BuildingId> buildings;
	for (int i = 0; i < 12; ++i) {
		buildings.push_back(town.building("house", float(random.uniform(0, 900)), float(random.uniform(0, 900))));
	}
	for (int i = 0; i < 40; ++i) {
		town.household(buildings[random.index(12)]);
		const PersonId id = town.person(30.0f, float(random.uniform(0.8, 1.6)));
		int32_t time = at(6) + int32_t(random.index(3'600'000));
		while (time < at(21)) {
			const int32_t end = time + int32_t(random.index(3) == 0 ? random.index(600'000) : random.index(7'200'000)) + 1000;
			if (random.chance(0.5)) {
				town.go(id, time, end, buildings[random.index(12)]);
			} else {
				town.stay(id, time, end, buildings[random.index(12)]);
			}
			time = end + (random.chance(0.2) ? 900'000 : 0);
		}
	}
}

} // namespace

TEST_CASE("after a jump walks and stays are as if the time had been lived") {
	for (int hour : { 0, 3, 7, 8, 9, 12, 15, 18, 20, 22, 23, 30, 33 }) {
		Town lived, jumped;
		fill_with_walkers(lived);
		fill_with_walkers(jumped);
		Simulation &a = lived.simulate();
		Simulation &b = jumped.simulate();
		a.start(moment(0, 0));
		a.advance_to(moment(0, hour, 17, 31));
		b.start(moment(3, 13));
		b.jump_to(moment(0, hour, 17, 31)); // backwards
		CHECK(a.outside_count() == b.outside_count());
		for (uint32_t i = 0; i < a.person_count(); ++i) {
			const PersonView x = a.view(PersonId(i));
			const PersonView y = b.view(PersonId(i));
			REQUIRE(x.state == y.state);
			REQUIRE(x.place == y.place);
			if (x.state == PersonState::Walking) { // doors of a lived stay may differ from those of a jump; here are one each
				REQUIRE(x.position == y.position);
				REQUIRE(x.arrival == y.arrival);
			}
			REQUIRE(x.entry.start == y.entry.start);
		}
	}
}

TEST_CASE("after a jump the future is as if the time had been lived") {
	Town lived, jumped;
	fill_with_walkers(lived);
	fill_with_walkers(jumped);
	Simulation &a = lived.simulate();
	Simulation &b = jumped.simulate();
	a.start(moment(0, 0));
	a.advance_to(moment(0, 10, 3));
	b.start(moment(0, 10, 3));
	Recorder after_a, after_b;
	a.add_observer(after_a);
	b.add_observer(after_b);
	a.advance_to(moment(2, 0));
	b.advance_to(moment(2, 0));
	CHECK(after_a.lines.size() > 300);
	CHECK(after_a.lines == after_b.lines);
}

namespace {

// Twenty persons with floating tasks and two slots a day, one of which begins the evening before.
void fill_with_idlers(Town &town) {
	Random random(9);
	town.rules("Errand Errand --> goToBuilding(findBuilding(\"shop\")) stayInside(rand(2m, 12m)) Rest --> wait(rand(5m, 9m))");
	const BuildingId shop = town.building("shop", 100.0f);
	town.building("shop", 160.0f);
	for (int i = 0; i < 20; ++i) {
		town.household(town.building("house", float(random.uniform(0, 300)), float(random.uniform(0, 300))));
		const PersonId id = town.person();
		if (i % 2) {
			town.person(); // somebody without tasks
		}
		town.stay(id, at(1), at(9), town.population.households.back().home);
		town.task(id, TaskKind::FloatingSlot, at(9), at(10), 0xFFFFFFFF);
		town.stay(id, at(10), at(14), i % 3 ? shop : town.population.households.back().home);
		town.task(id, TaskKind::FloatingSlot, at(14), at(15), 0xFFFFFFFF);
		town.task(id, TaskKind::FloatingSlot, at(23), at(25), 0xFFFFFFFF);
		for (size_t task = 0; task < 2 + random.index(3); ++task) {
			town.floating(id, at(0, 15), random.chance(0.5) ? "Errand" : "Rest", float(random.index(2)));
		}
	}
}

} // namespace

TEST_CASE("after a jump nobody does a floating task again that the day has seen") {
	for (const SimTime time : { moment(1, 0, 20), moment(1, 9, 20), moment(1, 12), moment(1, 14, 30), moment(1, 20) }) {
		Town lived, jumped;
		fill_with_idlers(lived);
		fill_with_idlers(jumped);
		Simulation &a = lived.simulate();
		Simulation &b = jumped.simulate();
		a.start(moment(0, 5));
		a.advance_to(time);
		b.start(moment(3, 12));
		b.jump_to(time);
		Recorder after_a, after_b;
		a.add_observer(after_a);
		b.add_observer(after_b);
		a.advance_to(moment(2, 0));
		b.advance_to(moment(2, 0));
		CHECK(after_a.lines == after_b.lines);
		CHECK(a.statistics().count(SimEventKind::FloatingTaskStarted) > 30);
	}
}

TEST_CASE("a jump into a group's walk finds all of it together") {
	Town town;
	const BuildingId home = town.building("house", 0.0f);
	const BuildingId school = town.building("school", 600.0f);
	town.household(home);
	const PersonId ana = town.person(36.0f, 1.3f);
	const PersonId leo = town.person(8.0f, 1.0f);
	town.stay(leo, at(8), at(16), school);
	town.stay(ana, at(8), at(24), home);
	town.accompany(ana, { leo }, at(7, 50), at(8), school);
	Simulation &simulation = town.simulate();
	simulation.start(moment(0, 0));
	simulation.jump_to(moment(4, 7, 55)); // five minutes at 1.0 m/s
	CHECK(simulation.position(ana).x == doctest::Approx(300.0));
	CHECK(simulation.position(leo) == simulation.position(ana));
	CHECK(simulation.outside_count() == 2);
	simulation.jump_to(moment(2, 12));
	CHECK(simulation.inside_count(school) == 1);
	CHECK(simulation.inside_count(home) == 1);
	CHECK(simulation.outside_count() == 0);
}
