#include <doctest/doctest.h>

#include "core/sim/simulation.h"
#include "tests/core/sim/town.h"

using namespace pcg;
using namespace pcg::test;

TEST_CASE("a person walks to work and back at the agenda's times, straight and at its speed") {
	Town town;
	const BuildingId home = town.building("house", 0.0f);
	const BuildingId work = town.building("workplace", 130.0f);
	town.household(home);
	const PersonId ana = town.person(30.0f, 1.3f);
	town.stay(ana, at(0), at(7, 55), home);
	town.go(ana, at(7, 55), at(8), work);
	town.stay(ana, at(8), at(16), work);
	town.go(ana, at(16), at(16, 5), home);
	town.stay(ana, at(16, 5), at(24), home);
	Simulation &simulation = town.simulate();
	Recorder recorder;
	simulation.add_observer(recorder);
	simulation.start(moment(0, 0));
	CHECK(simulation.state(ana) == PersonState::Inside);
	CHECK(simulation.inside_count(home) == 1);

	simulation.advance_to(moment(0, 7, 55, 50)); // 50 s x 1.3 m/s
	CHECK(simulation.state(ana) == PersonState::Walking);
	CHECK(simulation.position(ana).x == doctest::Approx(65.0));
	CHECK(simulation.outside_count() == 1);
	CHECK(simulation.inside_count(home) == 0);
	CHECK(simulation.view(ana).facing.x == doctest::Approx(1.0));
	CHECK(simulation.view(ana).place == target_of(work));

	simulation.advance_to(moment(1, 0));
	CHECK(recorder.of(ana) ==
			Lines{ "07:55:00 0 left-building building 0", "07:55:00 0 set-out building 1",
					"07:56:40 0 entered-building building 1", "16:00:00 0 left-building building 1",
					"16:00:00 0 set-out building 0", "16:01:40 0 entered-building building 0" });
	CHECK(simulation.statistics().trips == 2);
	CHECK(simulation.statistics().peak_outside == 1);
	CHECK(simulation.statistics().peak_time == moment(0, 7, 55));
	CHECK(simulation.statistics().late_arrivals == 0);
}

TEST_CASE("stayInside elsewhere walks there first and is late; the rest of the day goes on from there") {
	Town town;
	const BuildingId home = town.building("house", 0.0f);
	const BuildingId work = town.building("workplace", 600.0f);
	const BuildingId shop = town.building("shop", 600.0f, 300.0f);
	town.household(home);
	const PersonId ana = town.person();
	town.stay(ana, at(0), at(8), home);
	town.stay(ana, at(8), at(9), work); // ten minutes away
	town.go(ana, at(9), at(9, 3), shop); // five minutes away: not there when the next entry begins
	town.stay(ana, at(9, 3), at(24), work);
	Simulation &simulation = town.simulate();
	Recorder recorder;
	simulation.add_observer(recorder);
	simulation.start(moment(0, 7));
	simulation.advance_to(moment(0, 12));
	CHECK(recorder.of(ana) ==
			Lines{ "08:00:00 0 left-building building 0", "08:00:00 0 set-out building 1",
					"08:10:00 0 entered-building building 1", "08:10:00 0 arrived-late building 1",
					"09:00:00 0 left-building building 1", "09:00:00 0 set-out building 2",
					"09:03:00 0 set-out building 1", // turns round half-way
					"09:06:00 0 entered-building building 1", "09:06:00 0 arrived-late building 1" });
	CHECK(simulation.statistics().late_arrivals == 2);
}

TEST_CASE("nobody is late for what a newer entry left of an older one") {
	Town town;
	const BuildingId home = town.building("house", 0.0f);
	const BuildingId work = town.building("workplace", 300.0f);
	town.household(home);
	const PersonId ana = town.person();
	town.stay(ana, at(0), at(8), home);
	town.go(ana, at(8), at(9), work);
	town.stay(ana, at(9), at(24), home); // of stayInside(0h, 24h, home), which the walk to work split
	town.tasks[0].back().is_start_cut = true;
	Simulation &simulation = town.simulate();
	Recorder recorder;
	simulation.add_observer(recorder);
	simulation.start(moment(0, 0));
	simulation.advance_to(moment(1, 0));
	CHECK(recorder.has("09:05:00 0 entered-building building 0"));
	CHECK(simulation.statistics().late_arrivals == 0);
	CHECK(simulation.statistics().count(SimEventKind::ArrivedLate) == 0);
}

TEST_CASE("holes are spent at home") {
	Town town;
	const BuildingId home = town.building("house", 0.0f);
	const BuildingId shop = town.building("shop", 60.0f);
	town.household(home);
	const PersonId ana = town.person();
	town.go(ana, at(10), at(11), shop);
	Simulation &simulation = town.simulate();
	Recorder recorder;
	simulation.add_observer(recorder);
	simulation.start(moment(0, 0));
	simulation.advance_to(moment(1, 0));
	CHECK(recorder.of(ana) ==
			Lines{ "10:00:00 0 left-building building 0", "10:00:00 0 set-out building 1",
					"10:01:00 0 entered-building building 1", "11:00:00 0 left-building building 1",
					"11:00:00 0 set-out building 0", "11:01:00 0 entered-building building 0" });
}

TEST_CASE("night shifts cross midnight and day masks hold") {
	Town town;
	const BuildingId home = town.building("house", 0.0f);
	const BuildingId work = town.building("workplace", 60.0f);
	town.household(home);
	const PersonId ana = town.person();
	town.go(ana, at(22), at(30), work, DayMask(1 << 6)); // Sunday night, into Monday
	Simulation &simulation = town.simulate();
	Recorder recorder;
	simulation.add_observer(recorder);
	simulation.start(moment(0, 3)); // the Sunday before counts too: she is at work
	CHECK(simulation.inside_count(work) == 1);
	simulation.advance_to(moment(6, 21));
	CHECK(recorder.of(ana) == Lines{ "06:00:00 0 left-building building 1", "06:00:00 0 set-out building 0",
									 "06:01:00 0 entered-building building 0" });
	simulation.advance_to(moment(7, 3));
	CHECK(simulation.inside_count(work) == 1);
	CHECK(simulation.view(ana).entry.end == moment(7, 6));
}

TEST_CASE("who cannot get there stays where it is, and that is reported") {
	Town town;
	const BuildingId home = town.building("house", 0.0f);
	const BuildingId gone = town.building("workplace", 60.0f);
	town.city.remove_building(gone);
	town.household(home);
	const PersonId ana = town.person();
	town.go(ana, at(8), at(16), gone);
	Simulation &simulation = town.simulate();
	simulation.start(moment(0, 0));
	simulation.advance_to(moment(0, 12));
	CHECK(simulation.state(ana) == PersonState::Inside);
	CHECK(simulation.inside_count(home) == 1);
	CHECK(simulation.statistics().count(SimEventKind::Unreachable) == 1);
	CHECK(simulation.statistics().trips == 0);
}

TEST_CASE("a person without a home or a way is nowhere, and nothing breaks") {
	Town town;
	town.household(BuildingId::Invalid);
	const PersonId ana = town.person();
	town.go(ana, at(8), at(16), BuildingId(99));
	Simulation &simulation = town.simulate();
	simulation.start(moment(0, 0));
	simulation.advance_to(moment(2, 0));
	CHECK(simulation.state(ana) == PersonState::Inside);
	CHECK(simulation.outside_count() == 0);
}

TEST_CASE("the nearest door is used, in and out") {
	Town town;
	const BuildingId home = town.building("house", 0.0f);
	Entrance back;
	back.building = home;
	back.type = town.city.types.find("house");
	back.position = { 20.0f, 0.0f, 0.0f };
	town.city.add_entrance(back);
	const BuildingId shop = town.building("shop", 80.0f);
	town.household(home);
	const PersonId ana = town.person();
	town.go(ana, at(10), at(11), shop);
	Simulation &simulation = town.simulate();
	Recorder recorder;
	simulation.add_observer(recorder);
	simulation.start(moment(0, 0));
	simulation.advance_to(moment(0, 12));
	CHECK(recorder.has("10:01:00 0 entered-building building 1")); // 60 m, not 80
	CHECK(simulation.position(ana).x == 20.0f);
}

namespace {

// The way to whatever lies at `behind` goes around a wall, 100 m to the side and back.
class WalledPaths : public StraightLinePaths {
public:
	WalledPaths(const CityModel &city, glm::vec3 behind) : StraightLinePaths(city), _behind(behind) {}
	void find_path(glm::vec3 from, glm::vec3 to, std::vector<glm::vec3> &points) const override {
		points.assign({ from, to });
		if (from == _behind || to == _behind) {
			points.assign({ from, from + glm::vec3(0.0f, 0.0f, 100.0f), to + glm::vec3(0.0f, 0.0f, 100.0f), to });
		}
	}

private:
	glm::vec3 _behind;
};

} // namespace

TEST_CASE("of several doors the one with the shortest walk is used, not the nearest as the crow flies") {
	Town town;
	const BuildingId home = town.building("house", 0.0f);
	Entrance back;
	back.building = home;
	back.position = { 20.0f, 0.0f, 0.0f };
	town.city.add_entrance(back);
	const BuildingId shop = town.building("shop", 80.0f);
	town.household(home);
	const PersonId ana = town.person();
	town.go(ana, at(10), at(11), shop);
	town.simulate();
	const WalledPaths paths(town.city, back.position);
	Simulation simulation(town.city, paths, town.population, town.agendas, nullptr, {}, town.host);
	Recorder recorder;
	simulation.add_observer(recorder);
	simulation.start(moment(0, 9));
	simulation.advance_to(moment(0, 12));
	CHECK(recorder.has("10:01:20 0 entered-building building 1")); // 80 m, not 260
	CHECK(simulation.position(ana).x == 0.0f);
}

TEST_CASE("steps of any size give the same events") {
	const auto run = [](Duration step) {
		Town town;
		const BuildingId home = town.building("house", 0.0f);
		const BuildingId work = town.building("workplace", 333.0f, 77.0f);
		for (int i = 0; i < 20; ++i) {
			town.household(home);
			const PersonId id = town.person(30.0f, 0.9f + 0.03f * float(i));
			town.go(id, at(8) + i * 777, at(16), work);
			town.stay(id, at(16), at(24), home);
		}
		Simulation &simulation = town.simulate();
		Recorder recorder;
		simulation.add_observer(recorder);
		simulation.start(moment(0, 0));
		while (simulation.now() < moment(1, 0)) {
			simulation.advance_to(std::min(simulation.now() + step, moment(1, 0)));
		}
		return recorder.lines;
	};
	const Lines whole = run(one_day);
	CHECK(whole.size() > 100);
	CHECK(run(Duration::seconds(1)) == whole);
	CHECK(run(Duration::seconds(7)) == whole);
	CHECK(run(Duration::minutes(1)) == whole);
}

namespace {

class BodyCounter : public AgentHost {
public:
	int bodies = 0, walks = 0, wrong = 0;
	std::vector<bool> has_body = std::vector<bool>(10);

	void spawn_agent(PersonId id, glm::vec3) override {
		wrong += has_body[index_of(id)];
		has_body[index_of(id)] = true;
		++bodies;
	}
	void walk_agent(PersonId id, std::span<const glm::vec3> path, float) override {
		wrong += !has_body[index_of(id)] || path.size() < 2;
		++walks;
	}
	void free_agent(PersonId id) override {
		wrong += !has_body[index_of(id)];
		has_body[index_of(id)] = false;
		--bodies;
	}
};

} // namespace

TEST_CASE("bodies exist exactly while their persons are outdoors, across jumps too") {
	Town town;
	const BuildingId home = town.building("house", 0.0f);
	const BuildingId work = town.building("workplace", 600.0f);
	town.household(home);
	const PersonId ana = town.person();
	town.go(ana, at(8), at(16), work);
	town.simulate();
	BodyCounter bodies;
	Simulation simulation(town.city, town.paths, town.population, town.agendas, nullptr, {}, bodies);
	simulation.start(moment(0, 0));
	CHECK(bodies.bodies == 0);
	simulation.advance_to(moment(0, 8, 5));
	CHECK(bodies.bodies == 1);
	CHECK(bodies.walks == 1);
	simulation.jump_to(moment(0, 16, 5)); // on the way home
	CHECK(bodies.bodies == 1);
	CHECK(bodies.walks == 2);
	simulation.advance_to(moment(0, 17));
	CHECK(bodies.bodies == 0);
	CHECK(bodies.wrong == 0);
}
