#include "core/sim/invariants.h"
#include "tests/core/sim/town.h"

using namespace pcg;
using namespace pcg::test;

namespace {

constexpr float wall_x = 50.0f, gate_z = 30.0f;

// Straight lines, until a wall is built across the world, at x = 50 m, with a gate or without.
class WalledPaths : public StraightLinePaths {
public:
	using StraightLinePaths::StraightLinePaths;
	void build(bool has_gate) {
		_is_built = true;
		_has_gate = has_gate;
		++_revision;
	}

	void find_path(glm::vec3 from, glm::vec3 to, std::vector<glm::vec3> &points) const override {
		points.assign({ from, to });
		if (_is_built && crosses(from, to)) {
			_has_gate ? points.assign({ from, { wall_x, 0.0f, gate_z }, to }) : points.clear();
		}
	}
	uint64_t ground_revision() const override { return _revision; }
	bool is_walkable(std::span<const glm::vec3> line, uint64_t since) const override {
		bool is_free = true;
		for (size_t i = 1; i < line.size(); ++i) {
			is_free &= !crosses(line[i - 1], line[i]);
		}
		return is_free || _revision <= since;
	}

private:
	static bool crosses(glm::vec3 a, glm::vec3 b) { return (a.x < wall_x && b.x > wall_x) || (b.x < wall_x && a.x > wall_x); }

	bool _is_built = false, _has_gate = false;
	uint64_t _revision = 0;
};

// From the house at 0 m to the workplace, the school and a bench in a park at 100 m.
struct WalledTown {
	Town town;
	WalledPaths paths{ town.city };
	BuildingId home = town.building("house", 0.0f), work = town.building("workplace", 100.0f), school = town.building("school", 100.0f);
	PersonId ana, ben, eva, leo, max;
	Recorder recorder;

	WalledTown() {
		town.ground = &paths;
		town.zone("park", 100.0f, -10.0f, 20.0f);
		town.bench(100.0f, 0.0f);
		town.rules("Sit Sit --> goToObject(0) interact(0, \"sit\") waitUntilNextTask()");
		town.household(home);
		ana = town.person();
		ben = town.person(30.0f, 2.0f);
		eva = town.person();
		leo = town.person(8.0f);
		max = town.person();
		town.go(ana, at(8), at(16), work);
		town.go(ben, at(8), at(16), work);
		town.accompany(eva, { leo }, at(8), at(16), school);
		town.delayed(max, at(8), at(16), "Sit");
	}
};

} // namespace

TEST_CASE("walks lead round what is put in their way, alone, in a group and of a rule") {
	WalledTown t;
	Simulation &simulation = t.town.simulate();
	simulation.add_observer(t.recorder);
	InvariantChecker checker(simulation);
	simulation.start(moment(0, 7));
	simulation.advance_to(moment(0, 8, 0, 30)); // 30 m; Ben 60 m, behind the wall to be
	t.paths.build(true);
	const auto live_until = [&](SimTime end) {
		while (simulation.now() < end) {
			simulation.step(Duration::seconds(5));
			checker.check();
			CHECK(simulation.position(t.leo) == simulation.position(t.eva));
		}
	};
	live_until(moment(0, 8, 1, 5)); // 36.1 m to the gate
	CHECK(simulation.position(t.ana).z == doctest::Approx(gate_z).epsilon(0.05));
	CHECK(simulation.view(t.max).path.size() == 3);
	CHECK(simulation.view(t.leo).leader == t.eva);
	live_until(moment(0, 9));
	CHECK(t.recorder.has("08:00:50 1 entered-building building 1")); // 100 m at 2 m/s
	for (const char *line : { "0 entered-building building 1", "2 entered-building building 2", "3 entered-building building 2", "4 used-object object 0" }) {
		CHECK(t.recorder.has("08:02:04 " + std::string(line))); // and 58.3 m
	}
	CHECK(simulation.statistics().count(SimEventKind::GoalChanged) == 3);
	CHECK(simulation.statistics().trips == 5);
	simulation.flush_lived();
	checker.finish();
	CHECK(checker.broken_total() == 0);
}

TEST_CASE("where no way is left people stand, and go on as soon as there is one again") {
	WalledTown t;
	Simulation &simulation = t.town.simulate();
	InvariantChecker checker(simulation);
	simulation.start(moment(0, 7));
	simulation.advance_to(moment(0, 8, 0, 30));
	t.paths.build(false);
	simulation.advance_to(moment(0, 8, 1));
	CHECK(simulation.is_stranded(t.ana));
	CHECK(simulation.position(t.ana).x == doctest::Approx(30.0f));
	CHECK(simulation.is_place_free(ObjectId(0)));
	t.paths.build(true);
	simulation.advance_to(moment(0, 8, 1));
	CHECK(simulation.state(t.ana) == PersonState::Walking); // not only at 08:05:30
	checker.check();
	simulation.advance_to(moment(0, 9));
	CHECK(simulation.inside_count(t.work) == 2);
	checker.check();
	CHECK(checker.broken_total() == 0);
}

TEST_CASE("walks of a state that was saved before lead round what stands in their way now") {
	WalledTown t;
	Simulation &simulation = t.town.simulate();
	simulation.start(moment(0, 7));
	simulation.advance_to(moment(0, 8, 0, 30));
	const std::string bytes = simulation.save();
	t.paths.build(true);
	Simulation &loaded = t.town.simulate();
	Diagnostics diagnostics;
	REQUIRE(loaded.restore(bytes, diagnostics));
	loaded.step(Duration::seconds(1));
	CHECK(loaded.view(t.ana).path.size() == 3);
	CHECK(loaded.view(t.leo).path.size() == 3);
	CHECK(loaded.view(t.ben).path.size() == 2); // has gone by
	const std::string since = loaded.save();
	Simulation &again = t.town.simulate(); // where they lead round it already they stay as they are
	REQUIRE(again.restore(since, diagnostics));
	again.step(Duration::seconds(1));
	CHECK(again.statistics().count(SimEventKind::GoalChanged) == 3);
}
