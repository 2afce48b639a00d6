#include <doctest/doctest.h>

#include "core/sim/invariants.h"
#include "core/sim/simulation.h"
#include "tests/core/sim/town.h"

using namespace pcg;
using namespace pcg::test;

namespace {

// A house at 0 m, a park from 100 m to 140 m; everybody walks 1 m/s.
struct ParkTown {
	Town town;
	BuildingId home = town.building("house", 0.0f);
	ZoneId park = town.zone("park", 100.0f, -20.0f, 40.0f);
	Recorder recorder;

	PersonId add_person() {
		town.household(home);
		return town.person();
	}
	Simulation &run(SimTime until = moment(0, 20)) {
		Simulation &simulation = town.simulate();
		simulation.add_observer(recorder);
		simulation.start(moment(0, 0));
		simulation.advance_to(until);
		return simulation;
	}
};

} // namespace

TEST_CASE("a delayed rule waits, walks to the zone, sits down and is cut short at the end of its time") {
	ParkTown t;
	const ObjectId bench = t.town.bench(110.0f, 0.0f);
	t.town.rules("GoToPark"
				 " GoToPark --> wait(2) goToZone(\"park\") set(bench, findObject(\"bench\", 20))"
				 " goToObject(bench) interact(bench, \"sit\") waitUntilNextTask()");
	const PersonId otto = t.add_person();
	t.town.delayed(otto, at(8), at(12), "GoToPark");
	Simulation &simulation = t.run(moment(0, 9));
	CHECK(simulation.state(otto) == PersonState::AtPlace);
	CHECK(simulation.view(otto).place == target_of(bench));
	CHECK(simulation.view(otto).pose == AgentPose::Sit);
	CHECK(!simulation.is_place_free(bench));
	simulation.advance_to(moment(0, 13));
	CHECK(t.recorder.of(otto) ==
			Lines{ "08:00:02 0 left-building building 0", "08:00:02 0 set-out zone 0", "08:01:42 0 arrived zone 0",
					"08:01:42 0 set-out object 0", "08:01:52 0 arrived object 0", "08:01:52 0 used-object object 0",
					"12:00:00 0 rule-cut", "12:00:00 0 left-object object 0", "12:00:00 0 set-out building 0",
					"12:01:50 0 entered-building building 0" });
	CHECK(simulation.is_place_free(bench));
}

TEST_CASE("the first person takes the bench and the second goes elsewhere") {
	ParkTown t;
	t.town.bench(110.0f, 0.0f);
	t.town.bench(130.0f, 0.0f);
	t.town.rules("Sit Sit --> goToZone(\"park\") set(bench, findObject(\"bench\", 50))"
				 " case isValid(bench): goToObject(bench) interact(bench, \"sit\") waitUntilNextTask() else: wait(60)");
	const PersonId first = t.add_person();
	const PersonId second = t.add_person();
	const PersonId third = t.add_person();
	for (PersonId id : { first, second, third }) {
		t.town.delayed(id, at(8), at(12), "Sit");
	}
	Simulation &simulation = t.run(moment(0, 8, 5));
	// Two sit, on different benches; the third found none, waited a minute and is on the way home since 08:02:40.
	CHECK(simulation.view(first).pose == AgentPose::Sit);
	CHECK(simulation.view(second).pose == AgentPose::Sit);
	CHECK(simulation.view(first).place != simulation.view(second).place);
	CHECK(simulation.state(third) == PersonState::Inside);
	CHECK(t.recorder.has("08:02:40 2 rule-ended"));
	CHECK(t.recorder.has("08:04:20 2 entered-building building 0"));
}

TEST_CASE("a place is reserved from goToObject on, so nobody walks there in vain") {
	ParkTown t;
	const ObjectId bench = t.town.bench(110.0f, 0.0f);
	t.town.rules("Sit Sit --> goToObject(0) interact(0, \"sit\") waitUntilNextTask()");
	const PersonId first = t.add_person();
	const PersonId second = t.add_person();
	t.town.delayed(first, at(8), at(9), "Sit");
	t.town.delayed(second, at(8), at(9), "Sit");
	Simulation &simulation = t.run(moment(0, 8, 0, 30));
	CHECK(!simulation.is_place_free(bench));
	CHECK(simulation.state(first) == PersonState::Walking);
	CHECK(simulation.state(second) == PersonState::Inside);
	CHECK(t.recorder.has("08:00:00 1 no-free-place object 0"));
	CHECK(t.recorder.has("08:00:00 1 rule-ended"));
}

TEST_CASE("a bench with two seats takes two persons, side by side") {
	ParkTown t;
	t.town.bench(110.0f, 0.0f, 2);
	t.town.rules("Sit Sit --> interact(0, \"sit\") waitUntilNextTask()");
	const PersonId first = t.add_person();
	const PersonId second = t.add_person();
	const PersonId third = t.add_person();
	for (PersonId id : { first, second, third }) {
		t.town.delayed(id, at(8), at(9), "Sit");
	}
	Simulation &simulation = t.run(moment(0, 8, 30));
	CHECK(simulation.position(first).x == 110.0f);
	CHECK(simulation.position(second).x == 111.0f);
	CHECK(simulation.state(third) == PersonState::Inside);
}

TEST_CASE("a zone that does not exist ends the rule, and the person goes on to the next entry") {
	ParkTown t;
	t.town.rules("Go Go --> goToZone(\"beach\") wait(1h)");
	const BuildingId shop = t.town.building("shop", 60.0f);
	const PersonId ana = t.add_person();
	t.town.delayed(ana, at(8), at(9), "Go");
	t.town.stay(ana, at(9), at(10), shop);
	Simulation &simulation = t.run();
	CHECK(simulation.statistics().count(SimEventKind::Unreachable) == 1);
	CHECK(t.recorder.has("08:00:00 0 rule-ended"));
	CHECK(t.recorder.has("08:00:00 0 set-out building 1")); // what follows without a hole
	CHECK(t.recorder.has("10:01:00 0 entered-building building 0"));
}

TEST_CASE("a rule that ends early with a hole behind it sends the person home") {
	ParkTown t;
	t.town.rules("Go Go --> goToZone(\"park\") wait(10m)");
	const PersonId ana = t.add_person();
	t.town.delayed(ana, at(8), at(9), "Go");
	t.run();
	CHECK(t.recorder.of(ana) ==
			Lines{ "08:00:00 0 left-building building 0", "08:00:00 0 set-out zone 0", "08:01:40 0 arrived zone 0",
					"08:11:40 0 rule-ended", "08:11:40 0 set-out building 0", "08:13:20 0 entered-building building 0" });
}

TEST_CASE("errands: goToBuilding(building) and stayInside(seconds) inside a rule") {
	ParkTown t;
	const BuildingId shop = t.town.building("shop", 60.0f);
	t.town.rules("Shop Shop --> goToBuilding(findBuilding(\"shop\")) stayInside(15m) goToBuilding(home)");
	const PersonId ana = t.add_person();
	t.town.delayed(ana, at(8), at(9), "Shop");
	t.run();
	CHECK(index_of(shop) == 1);
	CHECK(t.recorder.of(ana) ==
			Lines{ "08:00:00 0 left-building building 0", "08:00:00 0 set-out building 1",
					"08:01:00 0 entered-building building 1", "08:16:00 0 left-building building 1",
					"08:16:00 0 set-out building 0", "08:17:00 0 entered-building building 0", "08:17:00 0 rule-ended" });
}

TEST_CASE("who leaves at the moment of coming in leaves by the same door") {
	ParkTown t;
	const BuildingId shop = t.town.building("shop", 60.0f);
	Entrance back;
	back.building = shop;
	back.position = { 80.0f, 0.0f, 0.0f };
	t.town.city.add_entrance(back);
	const BuildingId office = t.town.building("workplace", 200.0f);
	t.town.rules("Pass Pass --> goToBuilding(1) goToBuilding(2) wait(10m) goToBuilding(1) stayInside(1m) goToBuilding(home)");
	const PersonId ana = t.add_person();
	t.town.delayed(ana, at(8), at(9), "Pass");
	t.run();
	CHECK(index_of(office) == 2);
	CHECK(t.recorder.has("08:01:00 0 entered-building building 1")); // by the front at 60 m
	CHECK(t.recorder.has("08:03:20 0 entered-building building 2")); // 140 m on, not 120 m from the back
	CHECK(t.recorder.has("08:15:20 0 entered-building building 1")); // by the back at 80 m
	CHECK(t.recorder.has("08:17:20 0 entered-building building 0")); // a minute later, by the front: 60 m
}

TEST_CASE("a rule cut while walking leaves the person where it is, on its way to the next entry") {
	ParkTown t;
	t.town.rules("Go Go --> goToZone(\"park\") waitUntilNextTask()");
	const PersonId ana = t.add_person();
	t.town.delayed(ana, at(8), at(8, 0, 40), "Go");
	t.run();
	CHECK(t.recorder.has("08:00:40 0 rule-cut"));
	CHECK(t.recorder.has("08:01:20 0 entered-building building 0"));
}

TEST_CASE("a run-time error ends the rule and is told with the person, the simulation goes on") {
	ParkTown t;
	t.town.rules("Go Go --> wait(1 / (count() - count()))");
	const PersonId ana = t.add_person();
	t.town.delayed(ana, at(8), at(9), "Go");
	Simulation &simulation = t.run();
	CHECK(simulation.statistics().count(SimEventKind::RuleFailed) == 1);
	REQUIRE(simulation.diagnostics().error_count() == 1);
	const Diagnostic &error = simulation.diagnostics().list()[0];
	CHECK(error.file == "day.pcg");
	CHECK(error.message.find("person 0 of household 0, day 0, 08:00:00") != std::string::npos);
	CHECK(simulation.state(ana) == PersonState::Inside);
}

TEST_CASE("a run-time error is told once for its place in the rules, however often it happens") {
	ParkTown t;
	t.town.rules("Go Go --> wait(1 / (count() - count()))");
	for (int i = 0; i < 3; ++i) {
		t.town.delayed(t.add_person(), at(8), at(9), "Go");
	}
	Simulation &simulation = t.run(moment(2, 0));
	CHECK(simulation.statistics().count(SimEventKind::RuleFailed) == 6); // three persons on two days
	CHECK(simulation.diagnostics().error_count() == 1);
}

TEST_CASE("a zone and an object that the city has not are one warning each, with the place that asks first") {
	ParkTown t;
	t.town.rules("Go Go --> set(bench, findObject(\"bench\", 20))\n Sit\nSit --> goToZone(\"garden\")\nOther --> goToZone(\"garden\")");
	t.town.delayed(t.add_person(), at(8), at(9), "Go");
	t.town.delayed(t.add_person(), at(8), at(9), "Go");
	t.town.delayed(t.add_person(), at(10), at(11), "Other");
	Simulation &simulation = t.run();
	REQUIRE(simulation.diagnostics().warning_count() == 2);
	const Diagnostic &bench = simulation.diagnostics().list()[0], &garden = simulation.diagnostics().list()[1];
	CHECK(bench.message == "the city has no object of type 'bench'");
	CHECK(bench.hint == "add lots whose rules make one: @Object(\"bench\") before the rule of its shape");
	CHECK(garden.message == "the city has no zone of type 'garden'");
	CHECK(garden.hint == "add lots whose rules make one: zone(\"garden\")");
	CHECK(garden.file == "day.pcg");
	CHECK(garden.line == 3);
}

TEST_CASE("a name that the city has for something else is a missing type too, also in its first use after a time jump") {
	ParkTown t;
	t.town.rules("Go Go --> goToZone(\"house\")");
	t.town.delayed(t.add_person(), at(8), at(9), "Go");
	Simulation &simulation = t.run(moment(0, 1));
	simulation.jump_to(moment(0, 20));
	simulation.advance_to(moment(1, 20));
	REQUIRE(simulation.diagnostics().warning_count() == 1);
	CHECK(simulation.diagnostics().list()[0].message == "the city has no zone of type 'house'");
}

TEST_CASE("a rule that never waits is stopped") {
	ParkTown t;
	t.town.rules("Go Go --> wait(0) Go");
	t.town.delayed(t.add_person(), at(8), at(9), "Go");
	Simulation &simulation = t.run();
	CHECK(simulation.diagnostics().error_count() == 1);
	CHECK(simulation.now() == moment(0, 20));
}

TEST_CASE("a rule that begins again after each wait goes on all day, and for good") {
	ParkTown t;
	t.town.rules("Patrol Patrol --> set(n, 1) wait(20) case n > 0: Look(n) else: wait(1)  Look(n) --> goToZone(\"park\") wait(5) Patrol");
	const PersonId otto = t.add_person();
	t.town.delayed(otto, at(0), at(24), "Patrol");
	Simulation &simulation = t.run(moment(0, 23, 59));
	CHECK(simulation.diagnostics().list().empty());
	CHECK(simulation.statistics().count(SimEventKind::RuleEnded) == 0);
	CHECK(simulation.statistics().count(SimEventKind::SetOut) > 3000); // once in 25 s
	const size_t bytes = simulation.save().size();
	simulation.advance_to(moment(0, 23, 59, 50));
	CHECK(simulation.save().size() <= bytes + 200);
}

TEST_CASE("a rule that begins again after no time to speak of is stopped") {
	ParkTown t;
	t.town.rules("Spin Spin --> wait(0.001) Spin");
	t.town.delayed(t.add_person(), at(8), at(9), "Spin");
	Simulation &simulation = t.run();
	CHECK(simulation.diagnostics().has_errors());
	CHECK(simulation.statistics().handled_moments < 2000);
}

TEST_CASE("who sits sits down once") {
	ParkTown t;
	t.town.bench(110.0f, 0.0f);
	t.town.rules("Sit Sit --> interact(0, \"sit\") wait(10) interact(0, \"sit\") wait(10)");
	t.town.delayed(t.add_person(), at(8), at(9), "Sit");
	Simulation &simulation = t.run();
	CHECK(simulation.statistics().count(SimEventKind::UsedObject) == 1);
	CHECK(t.recorder.has("08:02:10 0 rule-ended")); // 110 m, 20 s
}

TEST_CASE("time and day in a rule are those of the simulation, and so is the place of the person") {
	ParkTown t;
	t.town.bench(110.0f, 0.0f);
	// 120 m from home: only within reach of 20 m once the person is in the park.
	t.town.rules("Go Go --> [ case time >= 8h && time < 8h1m && day == 0: wait(60) goToZone(\"park\") ]"
				 " case isValid(findObject(\"bench\", 20)): goToObject(findObject(\"bench\", 20)) waitUntilNextTask()");
	const PersonId ana = t.add_person();
	t.town.delayed(ana, at(8), at(9), "Go");
	Simulation &simulation = t.run(moment(0, 8, 30));
	CHECK(simulation.view(ana).place == target_of(ObjectId(0)));
}

TEST_CASE("floating slots take the highest priority that fits, then what fits the rest, then nothing") {
	ParkTown t;
	t.town.building("shop", 60.0f);
	t.town.rules("Walk Walk --> goToZone(\"park\") waitUntilNextTask()"
				 " Shop --> goToBuilding(findBuilding(\"shop\")) stayInside(10m)"
				 " Long --> wait(1)");
	const PersonId ana = t.add_person();
	t.town.task(ana, TaskKind::FloatingSlot, at(16), at(17), 0xFFFFFFFF);
	t.town.floating(ana, at(2), "Long", 9.0f); // does not fit
	t.town.floating(ana, at(0, 30), "Shop", 2.0f);
	t.town.floating(ana, at(0, 40), "Walk", 1.0f);
	Simulation &simulation = t.run(moment(1, 20));
	const Lines day{ "16:00:00 0 floating-task-started", "16:00:00 0 left-building building 0", "16:00:00 0 set-out building 1",
		"16:01:00 0 entered-building building 1", "16:11:00 0 rule-ended", "16:11:00 0 floating-task-started",
		"16:11:00 0 left-building building 1", "16:11:00 0 set-out zone 0", "16:11:40 0 arrived zone 0",
		"16:51:00 0 rule-cut", // its 40 minutes are over; nothing else fits into nine, so home it is
		"16:51:00 0 set-out building 0", "16:52:40 0 entered-building building 0" };
	Lines twice = day;
	twice.insert(twice.end(), day.begin(), day.end()); // the pool is full again at midnight
	CHECK(t.recorder.of(ana) == twice);
	CHECK(simulation.state(ana) == PersonState::Inside);
}

TEST_CASE("a jump finds those who sit on the bench, one for each place") {
	ParkTown t;
	t.town.bench(110.0f, 0.0f);
	t.town.rules("Sit Sit --> goToZone(\"park\") set(bench, findObject(\"bench\", 50))"
				 " case isValid(bench): goToObject(bench) interact(bench, \"sit\") waitUntilNextTask() else: waitUntilNextTask()");
	const PersonId first = t.add_person();
	const PersonId second = t.add_person();
	t.town.delayed(first, at(8), at(12), "Sit");
	t.town.delayed(second, at(8), at(12), "Sit");
	Simulation &simulation = t.town.simulate();
	InvariantChecker checker(simulation);
	simulation.start(moment(0, 0));
	for (int day : { 0, 3, 1 }) {
		simulation.jump_to(moment(day, 10));
		checker.check();
		CHECK(simulation.view(first).pose == AgentPose::Sit);
		CHECK(simulation.state(second) == PersonState::AtPlace);
		CHECK(simulation.view(second).place == target_of(t.park));
		simulation.jump_to(moment(day, 8, 0, 50));
		CHECK(simulation.position(first).x == doctest::Approx(50.0));
	}
	simulation.jump_to(moment(0, 11, 59));
	simulation.advance_to(moment(0, 13));
	simulation.flush_lived();
	checker.finish();
	CHECK(checker.broken_total() == 0);
	CHECK(simulation.outside_count() == 0);
	CHECK(simulation.is_place_free(ObjectId(0)));
}
