#include <doctest/doctest.h>

#include "core/sim/invariants.h"
#include "tests/core/sim/town.h"

using namespace pcg;
using namespace pcg::test;

TEST_CASE("other agendas and rules are taken over by everybody where they are") {
	Town town;
	const BuildingId home = town.building("house", 0.0f);
	const BuildingId work = town.building("workplace", 100.0f);
	const BuildingId shop = town.building("shop", 50.0f, 40.0f);
	town.household(home);
	const PersonId ana = town.person(), leo = town.person(8.0f), eva = town.person(), max = town.person();
	town.rules("Rest Rest --> wait(2h)");
	town.go(ana, at(8), at(16), work);
	town.accompany(eva, { leo }, at(8), at(16), work);
	town.delayed(max, at(7), at(10), "Rest");
	Simulation &simulation = town.simulate();
	simulation.start(moment(0, 6));
	simulation.advance_to(moment(0, 8, 0, 50));
	REQUIRE(simulation.position(ana).x == doctest::Approx(50.0));
	const std::vector<glm::vec3> before{ simulation.position(ana), simulation.position(leo), simulation.position(eva) };

	simulation.change_agendas([&] {
		town.groups.clear();
		for (std::vector<Task> &tasks : town.tasks) {
			tasks.clear();
		}
		town.rules("First attr where = \"house\" First --> wait(1s) Buy --> goToBuilding(findBuilding(where)) wait(1m)");
		town.go(ana, at(8), at(16), shop);
		town.delayed(max, at(7), at(10), "Buy");
		town.write_agendas();
		return town.program;
	}, { { "where", "shop" } });
	CHECK(simulation.position(ana) == before[0]);
	CHECK(simulation.position(leo) == before[1]);
	CHECK(simulation.position(eva) == before[2]);
	simulation.advance_to(moment(0, 8, 1, 31)); // 40 m, then through the door
	CHECK(simulation.state(ana) == PersonState::Inside);
	CHECK(simulation.view(ana).place.building() == shop);
	CHECK(simulation.view(leo).place.building() == home); // nothing is planned, and nobody leads
	CHECK(simulation.view(eva).place.building() == home);
	CHECK(simulation.view(max).place.building() == shop); // by the new rule, from the beginning
	simulation.advance_to(moment(1, 6));
	CHECK(simulation.diagnostics().is_empty());
}

namespace {

// An adult takes two children to school, one from another house on the way: home 0 m, club 60 m, school 200 m, all at 1 m/s.
struct SchoolRun {
	Town town;
	BuildingId home = town.building("house", 0.0f), club = town.building("leisure", 60.0f), school = town.building("school", 200.0f);
	PersonId leo, ana, mia; // the leader is neither the first nor the last
	Recorder recorder;
	Simulation *simulation = nullptr;
	std::unique_ptr<InvariantChecker> checker;

	explicit SchoolRun(int32_t start = at(8), int32_t end = at(9)) {
		town.household(home);
		leo = town.person(8.0f);
		ana = town.person();
		mia = town.person(6.0f);
		write(start, end);
		simulation = &town.simulate();
		simulation->add_observer(recorder);
		checker = std::make_unique<InvariantChecker>(*simulation);
		simulation->start(SimTime{ start - at(1) });
	}
	void write(int32_t start, int32_t end) {
		town.stay(mia, start - at(3), start, club);
		town.accompany(ana, { leo, mia }, start, end, school);
		if (end < at(23)) {
			town.stay(leo, end, end + at(1), school);
			town.stay(mia, end, end + at(1), school);
		}
	}
	void renew() {
		simulation->change_agendas([&] {
			town.write_agendas();
			return town.program;
		});
	}
	Lines arrivals_of(PersonId id) const {
		Lines lines = recorder.of(id);
		std::erase_if(lines, [](const std::string &line) { return line.find("entered-building") == std::string::npos; });
		return lines;
	}
	// Of the two children.
	bool is_anybody_alone() const {
		bool is_alone = false;
		for (const PersonId child : { leo, mia }) {
			const PersonView view = simulation->view(child);
			is_alone |= view.state == PersonState::Walking && !is_valid(view.leader);
		}
		return is_alone;
	}
	// Looks every five seconds; then nothing may have gone wrong since the start.
	void live_until(SimTime end) {
		while (simulation->now() < end) {
			simulation->step(Duration::seconds(5));
			checker->check();
			REQUIRE_FALSE(is_anybody_alone());
		}
		CHECK(checker->broken_total() == 0);
		CHECK(simulation->statistics().count(SimEventKind::PatienceRanOut) == 0);
		simulation->flush_lived();
		checker->finish();
	}
};

} // namespace

TEST_CASE("a group walks on when the agendas are renewed by the same rules, on the way to a child and to the goal, in time or late") {
	// At the begin, while only the leader walks, while the first child walks with it, while all do; and after the entry is over.
	for (const int32_t end : { at(9), at(8, 2) }) {
		for (const int seconds : { 0, 1, 20, 59, 60, 61, 130, 199, 200, 201 }) {
			SchoolRun undisturbed(at(8), end), renewed(at(8), end);
			CAPTURE(seconds);
			CAPTURE(end);
			renewed.simulation->advance_to(moment(0, 8, 0, seconds));
			renewed.renew();
			CHECK(renewed.simulation->statistics().trips == (seconds >= 200 ? 5u : seconds >= 60 ? 2u : 0u));
			renewed.live_until(moment(0, 8, 30));
			undisturbed.live_until(moment(0, 8, 30));
			CHECK(renewed.recorder.of(renewed.leo) == undisturbed.recorder.of(undisturbed.leo));
			CHECK(renewed.arrivals_of(renewed.ana) == undisturbed.arrivals_of(undisturbed.ana)); // on her way home she sets out once more
			CHECK(renewed.recorder.of(renewed.mia) == undisturbed.recorder.of(undisturbed.mia));
			CHECK(renewed.simulation->statistics().late_arrivals == undisturbed.simulation->statistics().late_arrivals);
		}
	}
}

TEST_CASE("a group that walks over midnight walks on when the agendas are renewed then") {
	SchoolRun run(at(23, 59), at(24, 30));
	run.simulation->advance_to(moment(1, 0));
	REQUIRE(run.simulation->view(run.leo).leader == run.ana);
	run.renew();
	run.live_until(moment(1, 0, 20));
	CHECK(run.simulation->view(run.leo).place.building() == run.school);
	CHECK(run.simulation->view(run.mia).place.building() == run.school);
}

TEST_CASE("a group with another goal or leader sets out anew from where it is, all together") {
	for (const bool has_other_leader : { false, true }) {
		SchoolRun run;
		const BuildingId other_school = run.town.building("school", 150.0f, 80.0f);
		run.simulation->advance_to(moment(0, 8, 1, 40)); // all three, 40 m behind the club
		REQUIRE(run.simulation->position(run.mia).x == doctest::Approx(100.0f));
		run.town.groups.clear();
		for (std::vector<Task> &tasks : run.town.tasks) {
			tasks.clear();
		}
		run.town.accompany(has_other_leader ? run.leo : run.ana, { has_other_leader ? run.ana : run.leo, run.mia }, at(8), at(9), other_school);
		run.renew();
		CHECK(run.simulation->position(run.mia).x == doctest::Approx(100.0f));
		run.live_until(moment(0, 8, 30));
		for (const PersonId id : { run.leo, run.ana, run.mia }) {
			CHECK(run.simulation->view(id).place.building() == other_school);
		}
		CHECK(run.recorder.has("08:03:14 2 entered-building building 3")); // 94.3 m
	}
}

TEST_CASE("a leader does not wait for a child that the new agendas have at home") {
	SchoolRun run;
	run.town.tasks[index_of(run.mia)].clear();
	run.town.stay(run.mia, at(7), at(8, 5), run.club); // called to the group only then
	run.town.task(run.mia, TaskKind::Accompany, at(8, 5), at(9), 0);
	run.renew();
	run.simulation->advance_to(moment(0, 8, 2));
	REQUIRE(run.simulation->view(run.ana).place.building() == run.club); // waits there with Leo
	run.town.tasks[index_of(run.mia)].clear();
	run.town.stay(run.mia, at(7), at(20), run.club);
	run.renew();
	run.live_until(moment(0, 8, 10));
	CHECK(run.recorder.has("08:04:20 0 entered-building building 2"));
	CHECK(run.simulation->view(run.mia).place.building() == run.club);
}

TEST_CASE("nobody is late because agendas were renewed") {
	Town town;
	const BuildingId home = town.building("house", 0.0f), work = town.building("workplace", 600.0f);
	town.household(home);
	const PersonId ana = town.person(), ben = town.person();
	town.stay(ana, at(0), at(8), home);
	town.stay(ana, at(8), at(16), work); // sets out then: late by ten minutes
	town.stay(ben, at(0), at(24), home);
	Simulation &simulation = town.simulate();
	simulation.start(moment(0, 3));
	const auto renew = [&] {
		simulation.change_agendas([&] {
			town.write_agendas();
			return town.program;
		});
	};
	renew();
	simulation.advance_to(moment(0, 4));
	renew();
	CHECK(simulation.statistics().late_arrivals == 0);
	simulation.advance_to(moment(0, 8, 5));
	renew();
	simulation.advance_to(moment(0, 9));
	CHECK(simulation.statistics().late_arrivals == 1); // on the way it was late already
	renew();
	CHECK(simulation.statistics().late_arrivals == 1);
	simulation.advance_to(moment(1, 0));
	renew(); // the day's first entries begin at that moment
	simulation.advance_to(moment(1, 9));
	CHECK(simulation.statistics().late_arrivals == 2);
}

TEST_CASE("floating tasks that were done today are not done again after a renewal, but for the one that it breaks off") {
	Town town;
	const BuildingId home = town.building("house", 0.0f);
	town.household(home);
	const PersonId ana = town.person(), ben = town.person();
	town.rules("Call Swim Read Call --> wait(10m) Swim --> wait(20m) Read --> wait(30m)");
	for (const PersonId id : { ana, ben }) {
		town.task(id, TaskKind::FloatingSlot, at(8), at(20), 0xFFFFFFFF);
	}
	town.floating(ana, at(0, 10), "Call", 3.0f);
	town.floating(ana, at(0, 10), "Call", 3.0f); // twice
	town.floating(ana, at(0, 20), "Swim", 2.0f);
	town.floating(ana, at(0, 30), "Read", 1.0f);
	Simulation &simulation = town.simulate();
	Recorder recorder;
	simulation.add_observer(recorder);
	simulation.start(moment(0, 6));
	simulation.advance_to(moment(0, 8, 30)); // two calls, and half of the swimming
	simulation.change_agendas([&] {
		town.rules("Read Call Swim Extra Extra --> wait(1m) Call --> wait(10m) Swim --> wait(20m) Read --> wait(30m)"); // other numbers
		town.floating_tasks.assign(2, {});
		town.floating(ben, at(0, 10), "Call", 3.0f);
		town.floating(ana, at(0, 30), "Read", 1.0f);
		town.floating(ana, at(0, 15), "Call", 3.0f); // not the same one
		town.floating(ana, at(0, 10), "Call", 3.0f);
		town.floating(ana, at(0, 10), "Call", 3.0f);
		town.floating(ana, at(0, 20), "Swim", 2.0f);
		town.write_agendas();
		return town.program;
	});
	recorder.lines.clear();
	simulation.advance_to(moment(0, 19));
	CHECK(recorder.has("08:40:00 1 rule-ended"));
	CHECK(recorder.of(ana) == Lines{ "08:40:00 0 rule-ended", "08:40:00 0 floating-task-started", "09:00:00 0 rule-ended", "09:00:00 0 floating-task-started",
									 "09:30:00 0 rule-ended" });
	recorder.lines.clear();
	simulation.advance_to(moment(1, 19));
	CHECK(std::count_if(recorder.lines.begin(), recorder.lines.end(),
				  [](const std::string &line) { return line.find(" 0 floating-task-started") != std::string::npos; }) == 5); // a new day
}
