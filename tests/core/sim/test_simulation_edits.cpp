#include <doctest/doctest.h>

#include "core/sim/invariants.h"
#include "core/sim/lived_log.h"
#include "tests/core/sim/commuter.h"

using namespace pcg;
using namespace pcg::test;

TEST_CASE("an inserted entry holds on its day, and the agenda goes on behind it") {
	Commuter t;
	Simulation &simulation = t.start();
	CHECK(t.visit(at(12), at(13), 0));
	simulation.advance_to(moment(0, 20));
	CHECK(t.recorder.of(t.ana) ==
			Lines{ "08:00:00 0 left-building building 0", "08:00:00 0 set-out building 1", "08:10:00 0 entered-building building 1",
					"12:00:00 0 left-building building 1", "12:00:00 0 set-out building 2", "12:08:20 0 entered-building building 2",
					"13:00:00 0 left-building building 2", "13:00:00 0 set-out building 1", "13:08:20 0 entered-building building 1",
					"16:00:00 0 left-building building 1", "16:00:00 0 set-out building 0", "16:10:00 0 entered-building building 0" });
	t.recorder.lines.clear();
	simulation.advance_to(moment(1, 20));
	CHECK(t.recorder.of(t.ana).size() == 6);
}

TEST_CASE("an entry whose time has come begins at once; what cannot be is refused") {
	Commuter t;
	Simulation &simulation = t.start(moment(0, 8, 4)); // 240 m from home, 140 m behind the plaza
	CHECK(t.visit(at(8), at(9), 0));
	simulation.advance_to(moment(0, 8, 30));
	CHECK(t.recorder.has("08:06:20 0 entered-building building 2"));
	CHECK(!t.visit(at(10), at(10), 0));
	CHECK(!t.town.insert(PersonId(9), Town::entry(TaskKind::GoToBuilding, at(10), at(11), index_of(t.plaza)), 0));
	simulation.jump_to(moment(0, 8, 8)); // a jump knows of it too
	CHECK(simulation.view(t.ana).place == target_of(t.plaza));
}

TEST_CASE("an agenda that was changed for every week is lived from then on") {
	Commuter t;
	Simulation &simulation = t.start();
	simulation.advance_to(moment(0, 8, 4)); // on the way to work, 240 m from home
	CHECK(t.visit(at(12), at(13)));
	simulation.advance_to(moment(0, 8, 30));
	CHECK(t.recorder.has("08:10:00 0 entered-building building 1")); // the walk went on
	CHECK(t.visit(at(8), at(9)));
	simulation.advance_to(moment(0, 20));
	CHECK(t.recorder.has("08:38:20 0 entered-building building 2"));
	CHECK(t.recorder.has("09:08:20 0 entered-building building 1"));
	CHECK(t.recorder.has("12:08:20 0 entered-building building 2"));
	CHECK(t.recorder.has("13:08:20 0 entered-building building 1"));
	t.recorder.lines.clear();
	simulation.advance_to(moment(1, 8, 10));
	CHECK(t.recorder.has("08:01:40 0 entered-building building 2"));
}

TEST_CASE("somebody whom the game took over goes on with its day from where it is given back") {
	Commuter t;
	Simulation &simulation = t.start();
	InvariantChecker checker(simulation);
	simulation.jump_to(moment(0, 7));
	simulation.advance_to(moment(0, 8, 1));
	CHECK(simulation.take_over(t.ana));
	CHECK(!simulation.take_over(t.ana));
	CHECK(simulation.view(t.ana).presence == Presence::Taken);
	CHECK(simulation.position(t.ana).x == 60.0f);
	CHECK(simulation.place_taken(t.ana, { 400.0f, 0.0f, 300.0f }));
	simulation.advance_to(moment(0, 9));
	checker.check();
	CHECK(simulation.outside_count() == 1);
	CHECK(simulation.release(t.ana));
	CHECK(!simulation.release(t.ana));
	CHECK(!simulation.place_taken(t.ana, { 0.0f, 0.0f, 0.0f }));
	simulation.advance_to(moment(0, 12));
	simulation.flush_lived();
	checker.finish();
	CHECK(t.recorder.of(t.ana) ==
			Lines{ "08:00:00 0 left-building building 0", "08:00:00 0 set-out building 1", "08:01:00 0 taken-over",
					"09:00:00 0 released", "09:00:00 0 set-out building 1",
					"09:06:00 0 entered-building building 1" }); // 360.6 m
	CHECK(checker.broken_total() == 0);
}

TEST_CASE("who was inside steps out when it is taken over; a jump leaves it with the game") {
	Commuter t;
	Simulation &simulation = t.start(moment(0, 10));
	CHECK(simulation.take_over(t.ana));
	CHECK(simulation.inside_count(t.work) == 0);
	CHECK(simulation.position(t.ana).x == 600.0f);
	simulation.jump_to(moment(2, 3));
	CHECK(simulation.view(t.ana).presence == Presence::Taken);
	CHECK(simulation.position(t.ana).x == 600.0f);
	CHECK(simulation.outside_count() == 1);
	CHECK(simulation.release(t.ana));
	simulation.advance_to(moment(2, 4));
	CHECK(simulation.inside_count(t.home) == 1);
	CHECK(simulation.outside_count() == 0);
}

TEST_CASE("a group whose leader is taken over walks on alone; one whose member is taken walks on with the rest") {
	for (const bool is_leader : { true, false }) {
		Town town;
		const BuildingId home = town.building("house", 0.0f);
		const BuildingId school = town.building("school", 300.0f);
		town.household(home);
		const PersonId ana = town.person(36.0f, 1.0f);
		const PersonId leo = town.person(8.0f, 1.0f);
		const PersonId mia = town.person(6.0f, 1.0f);
		town.accompany(ana, { leo, mia }, at(8), at(9), school);
		Simulation &simulation = town.simulate();
		Recorder recorder;
		simulation.add_observer(recorder);
		InvariantChecker checker(simulation);
		simulation.start(moment(0, 7));
		simulation.advance_to(moment(0, 8, 2));
		CHECK(simulation.take_over(is_leader ? ana : leo));
		simulation.advance_to(moment(0, 8, 30));
		CHECK(recorder.has("08:05:00 2 entered-building building 1"));
		CHECK(recorder.has("08:05:00 1 entered-building building 1") == is_leader);
		CHECK(recorder.has("08:05:00 0 entered-building building 1") == !is_leader);
		CHECK(recorder.has("08:02:00 2 patience-ran-out building 1") == is_leader);
		CHECK(simulation.release(is_leader ? ana : leo)); // the walk is over without it: on with its day, or after them
		simulation.advance_to(moment(0, 8, 40));
		CHECK(recorder.has("08:33:00 1 entered-building building 1") == !is_leader);
		CHECK(recorder.has("08:32:00 0 entered-building building 0") == is_leader);
		simulation.advance_to(moment(0, 12));
		CHECK(simulation.inside_count(home) == 3);
		simulation.flush_lived();
		checker.finish();
		CHECK(checker.broken_total() == 0);
	}
}

TEST_CASE("who is removed leaves its group, its seat and its building, and is seen no more") {
	Commuter t;
	Simulation &simulation = t.start(moment(0, 8, 5));
	CHECK(simulation.outside_count() == 1);
	CHECK(simulation.remove_person(t.ana));
	CHECK(!simulation.remove_person(t.ana));
	CHECK(!simulation.take_over(t.ana));
	CHECK(t.visit(at(12), at(13), 0)); // with nobody to live it
	CHECK(simulation.outside_count() == 0);
	simulation.advance_to(moment(1, 10));
	CHECK(t.recorder.lines.back() == "08:05:00 0 removed");
	simulation.jump_to(moment(1, 8, 5));
	CHECK(simulation.outside_count() == 0);
	CHECK(simulation.view(t.ana).presence == Presence::Removed);
}

TEST_CASE("households that are added live from then on where their agendas want them") {
	Commuter t;
	Simulation &simulation = t.start();
	simulation.advance_to(moment(0, 8, 5));
	Population &people = t.town.population;
	people.households.push_back({ t.plaza, PersonId(1), 2 });
	Person newcomer;
	newcomer.household = HouseholdId(1);
	newcomer.walking_speed = 1.0f;
	people.persons.insert(people.persons.end(), 2, newcomer);
	CHECK(!simulation.take_in_people()); // without agendas
	CHECK(simulation.person_count() == 1);
	AgendaSet &agendas = t.town.agendas;
	Task walk;
	walk.kind = TaskKind::GoToBuilding;
	walk.start_ms = at(8);
	walk.end_ms = at(9);
	walk.target = index_of(t.work);
	agendas.tasks.push_back(walk);
	agendas.first_task.insert(agendas.first_task.end(), 2, uint32_t(agendas.tasks.size()));
	agendas.first_floating_task.insert(agendas.first_floating_task.end(), 2, 0);
	CHECK(simulation.take_in_people());
	CHECK(simulation.person_count() == 3);
	CHECK(simulation.outside_count() == 2);
	CHECK(simulation.position(PersonId(1)).x == 400.0f); // since 8:00 from the plaza at 100 m
	CHECK(simulation.inside_count(t.plaza) == 1);
	simulation.advance_to(moment(0, 10));
	CHECK(t.recorder.has("08:05:00 2 added building 2"));
	CHECK(t.recorder.has("08:08:20 1 entered-building building 1"));
	CHECK(t.recorder.has("09:08:20 1 entered-building building 2"));
}

TEST_CASE("a bench that is dragged away is followed; one that is removed is left for another") {
	Sitter t;
	Simulation &simulation = t.start(moment(0, 9));
	InvariantChecker checker(simulation);
	simulation.jump_to(moment(0, 9));
	CHECK(simulation.view(t.otto).pose == AgentPose::Sit);
	t.town.city.move_object(t.near, { 125.0f, 0.0f, 0.0f });
	simulation.advance_to(moment(0, 9, 1));
	checker.check();
	CHECK(t.recorder.of(t.otto) ==
			Lines{ "09:00:00 0 goal-changed object 0", "09:00:00 0 left-object object 0", "09:00:00 0 set-out zone 0",
					"09:00:00 0 arrived zone 0", "09:00:00 0 set-out object 0", "09:00:15 0 arrived object 0",
					"09:00:15 0 used-object object 0" });
	const ObjectId other = t.town.bench(105.0f, 0.0f);
	t.town.city.remove_object(t.near);
	simulation.advance_to(moment(0, 9, 2));
	CHECK(simulation.view(t.otto).place == target_of(other));
	CHECK(t.recorder.has("09:01:20 0 used-object object 1")); // 20 m back
	t.town.city.remove_object(other);
	simulation.advance_to(moment(0, 9, 10));
	CHECK(simulation.state(t.otto) == PersonState::Inside);
	simulation.flush_lived();
	checker.finish();
	CHECK(checker.broken_total() == 0);
}

TEST_CASE("a bench that is moved while somebody walks to it is met where it is; so is a park") {
	Sitter t;
	Simulation &simulation = t.start(moment(0, 7));
	simulation.advance_to(moment(0, 8, 0, 50)); // 50 m from home
	t.town.city.move_zone(t.park, { { 60.0f, 0.0f, -5.0f }, { 60.0f, 0.0f, 5.0f }, { 80.0f, 0.0f, 5.0f }, { 80.0f, 0.0f, -5.0f } }, 3.0f);
	simulation.advance_to(moment(0, 8, 1, 5)); // in the park at 60 m since 8:01:00, at 65 m
	CHECK(t.recorder.has("08:01:00 0 arrived zone 0"));
	t.town.city.move_object(t.near, { 85.0f, 0.0f, 0.0f });
	simulation.advance_to(moment(0, 8, 2));
	CHECK(t.recorder.has("08:01:25 0 used-object object 0"));
}

TEST_CASE("a door that moves is walked to anew; a building that is gone sends people home") {
	Commuter t;
	Simulation &simulation = t.start();
	InvariantChecker checker(simulation);
	simulation.jump_to(moment(0, 7));
	simulation.advance_to(moment(0, 8, 5));
	t.town.city.move_entrance(t.town.city.entrance_of(t.work), { 300.0f, 0.0f, 400.0f }, { 0.0f, 0.0f, 1.0f });
	simulation.advance_to(moment(0, 9));
	CHECK(t.recorder.has("08:11:40 0 entered-building building 1")); // 400 m from where she was
	t.town.city.remove_building(t.work);
	simulation.advance_to(moment(0, 12));
	CHECK(t.recorder.has("09:08:20 0 entered-building building 0")); // 500 m
	CHECK(simulation.inside_count(t.work) == 0);
	simulation.advance_to(moment(1, 20)); // nobody can go there any more
	simulation.flush_lived();
	checker.finish();
	CHECK(checker.broken_total() == 0);
	CHECK(simulation.inside_count(t.home) == 1);
}

TEST_CASE("a game that calls the leader of a walk elsewhere, or takes it and gives it back at once, breaks no promise") {
	for (const bool is_taken : { false, true }) {
		Town town;
		const BuildingId home = town.building("house", 0.0f), school = town.building("school", 300.0f), shop = town.building("shop", 0.0f, 50.0f);
		town.household(home);
		const PersonId ana = town.person(36.0f, 1.0f), leo = town.person(8.0f, 1.0f);
		town.accompany(ana, { leo }, at(8), at(9), school);
		Simulation &simulation = town.simulate();
		InvariantChecker checker(simulation);
		LivedLog log;
		simulation.add_observer(log);
		simulation.start(moment(0, 7));
		simulation.advance_to(moment(0, 8, 2));
		if (is_taken) {
			CHECK(simulation.take_over(ana));
			CHECK(simulation.release(ana));
		} else {
			CHECK(town.insert(ana, Town::entry(TaskKind::StayInside, at(8, 2), at(8, 30), index_of(shop)), 0));
			CHECK(simulation.view(ana).entry.kind == TaskKind::Accompany); // until they are there
		}
		simulation.advance_to(moment(0, 8, 20));
		simulation.flush_lived();
		checker.finish();
		CHECK(checker.broken_total() == 0);
		CHECK(checker.children_alone_after_waiting() == (is_taken ? 1 : 0));
		const std::vector<LivedEntry> lived = log.of(ana);
		const auto walk = std::find_if(lived.begin(), lived.end(), [](const LivedEntry &entry) { return entry.state == PersonState::Walking; });
		REQUIRE(walk != lived.end());
		CHECK(walk->planned_kind == TaskKind::Accompany);
		CHECK(walk->planned_start == moment(0, 8));
	}
}

TEST_CASE("a child that waits for a leader whom a game calls elsewhere goes alone at once") {
	Town town;
	const BuildingId home = town.building("house", 0.0f), school = town.building("school", 100.0f), work = town.building("workplace", 300.0f);
	town.household(home);
	const PersonId ana = town.person(), leo = town.person(8.0f);
	town.accompany(ana, { leo }, at(8), at(9), school);
	town.tasks[index_of(ana)][0].start_ms = at(8, 20); // a newer entry took its beginning
	town.tasks[index_of(ana)][0].is_start_cut = true;
	town.stay(ana, at(7), at(8, 20), work);
	Simulation &simulation = town.simulate();
	Recorder recorder;
	simulation.add_observer(recorder);
	simulation.start(moment(0, 6));
	simulation.advance_to(moment(0, 8, 5));
	CHECK(recorder.of(leo).empty());
	CHECK(town.insert(ana, Town::entry(TaskKind::StayInside, at(8), at(9), index_of(work)), 0));
	simulation.advance_to(moment(0, 8, 59));
	CHECK(recorder.of(leo) == Lines{ "08:05:00 1 left-building building 0", "08:05:00 1 set-out building 1", "08:06:40 1 entered-building building 1" });
	CHECK(simulation.inside_count(work) == 1);
	simulation.advance_to(moment(1, 8, 31)); // the leader is late again on the next day, and comes
	CHECK(simulation.view(leo).place == target_of(school));
}
