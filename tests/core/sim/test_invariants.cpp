#include <doctest/doctest.h>

#include "core/sim/invariants.h"
#include "core/sim/lived_log.h"
#include "tests/core/sim/random_town.h"

using namespace pcg;
using namespace pcg::test;

TEST_CASE("all promises hold over random days, stepped and jumped") {
	for (uint64_t seed = 1; seed <= 12; ++seed) {
		Town town;
		fill_at_random(town, seed);
		Simulation &simulation = town.simulate();
		InvariantChecker checker(simulation);
		simulation.start(moment(0, 0));
		Random random(seed);
		while (simulation.now() < moment(2, 0)) {
			simulation.step(Duration{ int64_t(random.index(90'000)) });
			checker.check();
			if (random.chance(0.002)) {
				simulation.jump_to(simulation.now() + Duration::minutes(int64_t(random.index(400)) - 100));
			}
		}
		simulation.flush_lived();
		checker.finish();
		for (const std::string &example : checker.examples()) {
			MESSAGE(example);
		}
		CHECK(checker.broken_total() == 0);
		CHECK(simulation.statistics().trips > 100);
	}
}

TEST_CASE("random days are the same for every step") {
	for (uint64_t seed : { 3, 4 }) {
		Lines reference;
		for (int64_t step : { 86'400'000, 997, 61'000 }) {
			Town town;
			fill_at_random(town, seed);
			Simulation &simulation = town.simulate();
			Recorder recorder;
			simulation.add_observer(recorder);
			simulation.start(moment(0, 4));
			while (simulation.now() < moment(0, 22)) {
				simulation.advance_to(std::min(simulation.now() + Duration{ step }, moment(0, 22)));
			}
			if (reference.empty()) {
				reference = recorder.lines;
			}
			CHECK(recorder.lines == reference);
		}
	}
}

namespace {

// Somebody at home whom the checker watches; tests then tell the checker lies.
struct Watched {
	Town town;
	BuildingId home = town.building("house", 0.0f);
	BuildingId work = town.building("workplace", 500.0f);
	PersonId ana;
	std::unique_ptr<InvariantChecker> checker;

	Watched() {
		town.household(home);
		ana = town.person();
		town.go(ana, at(8), at(16), work);
		Simulation &simulation = town.simulate();
		checker = std::make_unique<InvariantChecker>(simulation);
		simulation.start(moment(0, 7));
		checker->check();
	}
	LivedSpan at_home(SimTime start, SimTime end) const {
		LivedSpan span;
		span.person = ana;
		span.start = start;
		span.end = end;
		span.place = target_of(home);
		return span;
	}
};

} // namespace

TEST_CASE("the checker sees a person that appears elsewhere") {
	Watched watched;
	watched.checker->on_lived(watched.at_home(moment(0, 7), moment(0, 8)));
	LivedSpan span = watched.at_home(moment(0, 8), moment(0, 9));
	span.state = PersonState::Waiting;
	span.position = { 77.0f, 0.0f, 0.0f };
	span.place = {};
	CHECK(watched.checker->broken_total() == 0);
	watched.checker->on_lived(span);
	CHECK(watched.checker->broken(Promise::NoTeleport) == 1);
}

TEST_CASE("the checker sees a walk that is faster than the person") {
	Watched watched;
	const glm::vec3 path[] = { { 0.0f, 0.0f, 0.0f }, { 500.0f, 0.0f, 0.0f } };
	LivedSpan span = watched.at_home(moment(0, 7), moment(0, 7, 1));
	span.state = PersonState::Walking;
	span.position = path[1];
	span.path = path;
	span.last_metre = 500.0;
	watched.checker->on_lived(span);
	CHECK(watched.checker->broken(Promise::NoTeleport) == 1);
}

TEST_CASE("the checker sees gaps in lives, doors used twice and walks without a way") {
	Watched watched;
	watched.checker->on_lived(watched.at_home(moment(0, 7, 5), moment(0, 8)));
	CHECK(watched.checker->broken(Promise::DayCovered) == 1);
	watched.checker->on_event({ moment(0, 8), watched.ana, SimEventKind::EnteredBuilding, target_of(watched.work), {} });
	CHECK(watched.checker->broken(Promise::NoTwoPlaces) == 1);
	watched.checker->on_event({ moment(0, 8), watched.ana, SimEventKind::SetOut, target_of(watched.work), {} });
	CHECK(watched.checker->broken(Promise::NoWalkToNowhere) == 1);
}

namespace {

// Ana brings Leo to school, and fetches Mia before, who is 50 m away.
struct SchoolRun {
	Town town;
	BuildingId home = town.building("house", 0.0f), far = town.building("house", 50.0f), school = town.building("school", 600.0f);
	PersonId ana, leo, mia;
	Simulation *simulation = nullptr;

	SchoolRun() {
		town.household(home);
		ana = town.person();
		leo = town.person(8.0f, 1.0f);
		mia = town.person(8.0f, 1.0f);
		town.stay(mia, at(6), at(8), far);
		town.accompany(ana, { leo, mia }, at(8), at(12), school);
		simulation = &town.simulate();
	}
	// Ten metres of a walk of Leo's.
	LivedSpan span(SimTime start) const {
		const PersonView view = simulation->view(leo);
		LivedSpan span;
		span.person = leo;
		span.start = start;
		span.end = start + Duration{ 10'000 };
		span.state = PersonState::Walking;
		span.place = view.place;
		span.entry = view.entry;
		span.leader = view.leader;
		span.path = view.path;
		span.first_metre = 10.0;
		span.last_metre = 20.0;
		span.position = { 20.0f, 0.0f, 0.0f };
		return span;
	}
};

} // namespace

TEST_CASE("the checker sees a child of a group without its leader, on the way to others too") {
	SchoolRun run;
	InvariantChecker checker(*run.simulation);
	run.simulation->start(moment(0, 7));
	run.simulation->advance_to(moment(0, 8, 0, 10));
	checker.check();
	CHECK(checker.broken_total() == 0);
	CHECK(run.simulation->view(run.leo).place == target_of(run.far));
	checker.on_lived(run.span(moment(0, 8, 0, 10)));
	checker.check();
	CHECK(checker.broken(Promise::NoChildAlone) == 1);
}

TEST_CASE("a child whose leader is gone goes on alone, which is counted; who does so without having waited breaks the promise") {
	SchoolRun run;
	InvariantChecker checker(*run.simulation);
	run.simulation->start(moment(0, 7));
	run.simulation->advance_to(moment(0, 8, 2)); // all three, on the way to school
	LivedSpan span = run.span(moment(0, 8, 2));
	CHECK(span.place == target_of(run.school));
	span.leader = PersonId::Invalid;
	run.simulation->remove_person(run.ana);
	run.simulation->advance_to(moment(0, 9));
	run.simulation->flush_lived();
	checker.check();
	CHECK(checker.broken_total() == 0);
	CHECK(checker.children_alone_after_waiting() == 2);
	InvariantChecker deaf(*run.simulation); // has not heard that they waited in vain
	deaf.on_jump(moment(0, 8, 2), moment(0, 8, 2));
	deaf.on_event({ moment(0, 8, 2), run.leo, SimEventKind::SetOut, target_of(run.school), {} });
	deaf.on_lived(span);
	CHECK(deaf.broken(Promise::NoChildAlone) == 1);
}

TEST_CASE("the checker sees who stands about although there is a way, after a jump too, and who holds a seat without going there") {
	Town town;
	const BuildingId home = town.building("house", 0.0f);
	const BuildingId work = town.building("workplace", 300.0f);
	town.bench(10.0f, 0.0f);
	town.rules("Sit Sit --> goToObject(0) wait(1h)");
	town.household(home);
	const PersonId ana = town.person();
	town.go(ana, at(8), at(16), work);
	town.delayed(ana, at(17), at(18), "Sit");
	Simulation &simulation = town.simulate();
	InvariantChecker checker(simulation);
	simulation.start(moment(0, 12));
	checker.check();
	CHECK(checker.broken_total() == 0);
	AgendaSet &agendas = town.agendas; // which the simulation is not told
	const std::vector<Task, UntouchedAllocator<Task>> tasks = agendas.tasks;
	agendas.tasks[0].target = index_of(home);
	checker.on_jump(moment(0, 12), moment(0, 12));
	checker.check();
	CHECK(checker.broken(Promise::RightBuilding) == 1);
	agendas.tasks = tasks;
	simulation.advance_to(moment(0, 17, 30));
	checker.check();
	CHECK(checker.broken(Promise::NoDoubleSeat) == 0);
	CHECK(simulation.place_holder(ObjectId(0), 0) == ana);
}

TEST_CASE("a life is told without gaps, and each stretch with the entry that it served") {
	Town town;
	const BuildingId home = town.building("house", 0.0f);
	const BuildingId work = town.building("workplace", 60.0f);
	town.household(home);
	const PersonId ana = town.person();
	town.go(ana, at(8), at(16), work);
	Simulation &simulation = town.simulate();
	LivedLog log;
	simulation.add_observer(log);
	simulation.start(moment(0, 0));
	simulation.advance_to(moment(1, 0));
	simulation.flush_lived();
	const std::vector<LivedEntry> lived = log.of(ana);
	REQUIRE(lived.size() == 5);
	CHECK(lived[0].state == PersonState::Inside);
	CHECK(lived[0].end == moment(0, 8));
	CHECK(lived[1].state == PersonState::Walking);
	CHECK(lived[1].end == moment(0, 8, 1));
	CHECK(lived[1].metres == doctest::Approx(60.0));
	CHECK(lived[1].planned_kind == TaskKind::GoToBuilding);
	CHECK(lived[1].planned_end == moment(0, 16));
	CHECK(lived[2].place == target_of(work));
	CHECK(lived[2].end == moment(0, 16));
	CHECK(lived[3].planned_task == PlannedEntry::hole);
	CHECK(lived[4].end == moment(1, 0));
}
