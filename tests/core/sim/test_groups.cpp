#include <doctest/doctest.h>

#include "core/sim/invariants.h"
#include "core/sim/simulation.h"
#include "tests/core/sim/town.h"

using namespace pcg;
using namespace pcg::test;

namespace {

// The paper's teaser: an adult brings two children to school, works, picks up the same two, goes home.
// home 0 m, school 130 m, work 390 m; the adult walks 1.3 m/s, Leo 1.0 m/s, Mia 1.25 m/s.
struct Family {
	Town town;
	BuildingId home = town.building("house", 0.0f);
	BuildingId school = town.building("school", 130.0f);
	BuildingId work = town.building("workplace", 390.0f);
	PersonId ana, leo, mia;
	Recorder recorder;

	explicit Family(int32_t leaves_work = at(15, 55)) {
		town.household(home);
		ana = town.person(36.0f, 1.3f);
		leo = town.person(8.0f, 1.0f);
		mia = town.person(6.0f, 1.25f);
		town.stay(ana, at(0), at(7, 50), home);
		town.stay(ana, at(8, 5), at(15, 30), work);
		town.go(ana, at(8), at(8, 5), work);
		town.stay(ana, at(15, 30), leaves_work, work);
		town.go(ana, leaves_work, at(16), school);
		town.stay(ana, at(16, 10), at(24), home);
		for (PersonId child : { leo, mia }) {
			town.stay(child, at(0), at(7, 50), home);
			town.stay(child, at(8), at(16), school);
			town.stay(child, at(16, 10), at(24), home);
		}
		town.accompany(ana, { leo, mia }, at(7, 50), at(8), school);
		town.accompany(ana, { leo, mia }, at(16), at(16, 10), home);
	}
	Simulation &run() {
		Simulation &simulation = town.simulate();
		simulation.add_observer(recorder);
		simulation.start(moment(0, 0));
		simulation.advance_to(moment(1, 0));
		return simulation;
	}
};

} // namespace

TEST_CASE("an adult brings two children to school, works, picks up the same two and goes home") {
	Family family;
	Simulation &simulation = family.run();
	// 130 m at the slowest member's 1.0 m/s: 130 s; 260 m alone at 1.3 m/s: 200 s.
	CHECK(family.recorder.of(family.ana) ==
			Lines{ "07:50:00 0 left-building building 0", "07:50:00 0 set-out building 1",
					"07:52:10 0 entered-building building 1", "08:00:00 0 left-building building 1",
					"08:00:00 0 set-out building 2", "08:03:20 0 entered-building building 2",
					"15:55:00 0 left-building building 2", "15:55:00 0 set-out building 1",
					"15:58:20 0 entered-building building 1", "16:00:00 0 left-building building 1",
					"16:00:00 0 set-out building 0", "16:02:10 0 entered-building building 0" });
	const std::string child[] = { "1", "2" };
	for (uint32_t i = 1; i <= 2; ++i) {
		const std::string id = child[i - 1];
		CHECK(family.recorder.of(PersonId(i)) ==
				Lines{ "07:50:00 " + id + " left-building building 0", "07:50:00 " + id + " set-out building 1",
						"07:52:10 " + id + " entered-building building 1", "16:00:00 " + id + " left-building building 1",
						"16:00:00 " + id + " set-out building 0", "16:02:10 " + id + " entered-building building 0" });
	}
	CHECK(simulation.statistics().late_arrivals == 0);
	CHECK(simulation.statistics().count(SimEventKind::PatienceRanOut) == 0);
}

TEST_CASE("members of a group are at one place all the way") {
	Family family;
	Simulation &simulation = family.town.simulate();
	simulation.start(moment(0, 7, 45));
	simulation.advance_to(moment(0, 7, 51, 5));
	CHECK(simulation.position(family.ana).x == doctest::Approx(65.0));
	CHECK(simulation.position(family.leo) == simulation.position(family.ana));
	CHECK(simulation.position(family.mia) == simulation.position(family.ana));
	CHECK(simulation.view(family.mia).leader == family.ana);
	CHECK(simulation.outside_count() == 3);
}

TEST_CASE("joiners wait inside for a leader who is late") {
	Family family(at(15, 59)); // at school at 16:02:20
	Simulation &simulation = family.run();
	CHECK(family.recorder.of(family.leo) ==
			Lines{ "07:50:00 1 left-building building 0", "07:50:00 1 set-out building 1",
					"07:52:10 1 entered-building building 1", "16:02:20 1 left-building building 1",
					"16:02:20 1 set-out building 0", "16:04:30 1 entered-building building 0" });
	CHECK(simulation.statistics().count(SimEventKind::PatienceRanOut) == 0);
}

TEST_CASE("when nobody comes, joiners go alone after half an hour, and that is reported") {
	Family family;
	// The adult's afternoon walk is gone from its own agenda: it stays at work.
	std::vector<Task> &tasks = family.town.tasks[0];
	std::erase_if(tasks, [](const Task &task) { return task.start_ms >= at(15, 55); });
	family.town.stay(family.ana, at(15, 55), at(24), family.work);
	for (PersonId child : { family.leo, family.mia }) { // their entry lasts long enough to wait in it
		std::vector<Task> &own = family.town.tasks[index_of(child)];
		std::erase_if(own, [](const Task &task) { return task.start_ms == at(16, 10); });
		own.back().end_ms = at(17);
		family.town.stay(child, at(17), at(24), family.home);
	}
	Simulation &simulation = family.run();
	CHECK(family.recorder.has("16:30:00 1 patience-ran-out building 0"));
	CHECK(family.recorder.has("16:30:00 2 set-out building 0"));
	CHECK(family.recorder.has("16:32:10 1 entered-building building 0")); // 130 m at 1.0
	CHECK(family.recorder.has("16:31:44 2 entered-building building 0")); // 130 m at 1.25
	CHECK(simulation.statistics().count(SimEventKind::PatienceRanOut) == 2);
}

TEST_CASE("a leader who comes later than the children have patience finds them gone, and waits for nobody") {
	Town town;
	const BuildingId home = town.building("house", 0.0f), school = town.building("school", 100.0f), work = town.building("workplace", 300.0f);
	town.household(home);
	const PersonId ana = town.person();
	const PersonId leo = town.person(8.0f);
	town.accompany(ana, { leo }, at(8), at(12), school);
	town.tasks[index_of(ana)][0].start_ms = at(8, 40); // a newer entry took its beginning
	town.tasks[index_of(ana)][0].is_start_cut = true;
	town.stay(ana, at(7), at(8, 40), work);
	Simulation &simulation = town.simulate();
	Recorder recorder;
	simulation.add_observer(recorder);
	InvariantChecker checker(simulation);
	simulation.start(moment(0, 6));
	simulation.advance_to(moment(0, 9));
	CHECK(recorder.of(leo) == Lines{ "08:30:00 1 patience-ran-out building 1", "08:30:00 1 left-building building 0", "08:30:00 1 set-out building 1",
									 "08:31:40 1 entered-building building 1" });
	CHECK(!is_valid(simulation.view(ana).leader));
	CHECK(simulation.inside_count(work) == 1);
	simulation.advance_to(moment(0, 11, 59));
	CHECK(simulation.statistics().count(SimEventKind::PatienceRanOut) == 1);
	simulation.flush_lived();
	checker.finish();
	CHECK(checker.broken_total() == 0);
	CHECK(checker.children_alone_after_waiting() == 1);
}

TEST_CASE("the leader fetches joiners at different places, nearest first, before the goal") {
	Town town;
	const BuildingId home = town.building("house", 0.0f);
	const BuildingId near = town.building("school", 100.0f);
	const BuildingId far = town.building("school", 300.0f);
	town.household(home);
	const PersonId ana = town.person();
	const PersonId leo = town.person(8.0f);
	const PersonId mia = town.person(6.0f);
	town.stay(leo, at(8), at(16), far);
	town.stay(mia, at(8), at(16), near);
	town.accompany(ana, { leo, mia }, at(16), at(17), home);
	Simulation &simulation = town.simulate();
	Recorder recorder;
	simulation.add_observer(recorder);
	simulation.start(moment(0, 12));
	simulation.advance_to(moment(0, 20));
	CHECK(recorder.has("16:00:00 0 set-out building 1"));
	CHECK(recorder.has("16:01:40 2 left-building building 1"));
	CHECK(recorder.has("16:01:40 2 set-out building 2"));
	CHECK(recorder.has("16:05:00 1 left-building building 2"));
	for (const char *id : { "0", "1", "2" }) {
		CHECK(recorder.has(std::string("16:10:00 ") + id + " entered-building building 0"));
	}
	CHECK(simulation.statistics().count(SimEventKind::PatienceRanOut) == 0);
}

TEST_CASE("the leader waits inside for a joiner who is still on its way there") {
	Town town;
	const BuildingId home = town.building("house", 0.0f);
	const BuildingId school = town.building("school", 100.0f);
	const BuildingId club = town.building("leisure", 400.0f);
	town.household(home);
	const PersonId ana = town.person();
	const PersonId leo = town.person(8.0f);
	town.stay(leo, at(10), at(15, 58), club);
	town.go(leo, at(15, 58), at(16), school); // five minutes away: there at 16:03
	town.accompany(ana, { leo }, at(16), at(17), home);
	Simulation &simulation = town.simulate();
	Recorder recorder;
	simulation.add_observer(recorder);
	simulation.start(moment(0, 12));
	simulation.advance_to(moment(0, 20));
	CHECK(recorder.has("16:01:40 0 entered-building building 1"));
	CHECK(recorder.has("16:03:00 1 entered-building building 1"));
	CHECK(recorder.has("16:03:00 0 left-building building 1"));
	CHECK(recorder.has("16:04:40 1 entered-building building 0"));
	CHECK(recorder.has("16:04:40 0 entered-building building 0"));
}

TEST_CASE("who waited in vain until its entry was over goes on with the next one, which may be another group") {
	Town town;
	const BuildingId home = town.building("house", 0.0f);
	const BuildingId school = town.building("school", 100.0f);
	town.household(home);
	const PersonId ana = town.person();
	const PersonId ben = town.person();
	const PersonId leo = town.person(8.0f);
	town.stay(ben, at(8), at(16, 10), school);
	town.stay(leo, at(8), at(16), school);
	town.accompany(ana, { leo }, at(16), at(16, 10), home);
	town.accompany(ben, { leo }, at(16, 10), at(17), home);
	std::erase_if(town.tasks[index_of(ana)], [](const Task &task) { return task.kind == TaskKind::Accompany; }); // Ana never comes
	Simulation &simulation = town.simulate();
	Recorder recorder;
	simulation.add_observer(recorder);
	simulation.start(moment(0, 12));
	simulation.advance_to(moment(0, 20));
	CHECK(recorder.has("16:30:00 2 patience-ran-out building 0"));
	CHECK(recorder.has("16:30:00 2 set-out building 0"));
	CHECK(recorder.has("16:30:00 1 set-out building 0"));
	CHECK(recorder.has("16:31:40 2 entered-building building 0"));
	CHECK(recorder.has("16:31:40 1 entered-building building 0"));
}

TEST_CASE("a child who waited in vain is counted on its next walk to the group's goal, whatever entry that serves") {
	Town town;
	const BuildingId home = town.building("house", 0.0f), school = town.building("school", 100.0f), club = town.building("leisure", 50.0f);
	town.household(home);
	const PersonId ana = town.person(), leo = town.person(8.0f), mia = town.person(6.0f), ida = town.person(17.0f);
	town.accompany(ana, { leo, mia, ida }, at(8), at(8, 10), school); // shorter than the children have patience
	std::erase_if(town.tasks[index_of(ana)], [](const Task &task) { return task.kind == TaskKind::Accompany; }); // Ana never comes
	town.stay(leo, at(8, 10), at(12), school);
	town.stay(leo, at(12), at(13), home);
	town.stay(leo, at(13), at(14), school); // no walk of that group's any more
	town.stay(mia, at(8, 10), at(12), club);
	town.stay(mia, at(12), at(13), school);
	town.stay(ida, at(8, 10), at(12), school);
	Simulation &simulation = town.simulate();
	InvariantChecker checker(simulation);
	simulation.start(moment(0, 6));
	simulation.advance_to(moment(0, 8, 29));
	CHECK(checker.children_alone_after_waiting() == 0);
	simulation.advance_to(moment(0, 20));
	CHECK(simulation.statistics().count(SimEventKind::PatienceRanOut) == 3);
	CHECK(checker.children_alone_after_waiting() == 2);
	CHECK(checker.broken_total() == 0);
}

TEST_CASE("a group that is at its goal already does not go out to come in again") {
	Town town;
	const BuildingId school = town.building("school", 0.0f);
	town.household(school);
	const PersonId ana = town.person(), leo = town.person(8.0f);
	town.accompany(ana, { leo }, at(8), at(9), school);
	Simulation &simulation = town.simulate();
	Recorder recorder;
	simulation.add_observer(recorder);
	simulation.start(moment(0, 6));
	simulation.advance_to(moment(0, 20));
	CHECK(recorder.of(ana).empty());
	CHECK(recorder.of(leo).empty());
}
