#include <doctest/doctest.h>

#include "core/sim/invariants.h"
#include "tests/core/sim/random_town.h"

using namespace pcg;
using namespace pcg::test;

namespace {

void fill(Town &town, uint64_t seed) {
	fill_at_random(town, seed);
	add_rules_at_random(town, seed);
}

// The same in every field of the statistics.
void check_equal(const SimulationStatistics &a, const SimulationStatistics &b) {
	CHECK(a.trips == b.trips);
	CHECK(a.late_arrivals == b.late_arrivals);
	CHECK(a.outside == b.outside);
	CHECK(a.peak_outside == b.peak_outside);
	CHECK(a.peak_time == b.peak_time);
	CHECK(a.handled_moments == b.handled_moments);
	CHECK(a.events == b.events);
}

} // namespace

namespace {

// What happened worth saving, over all states that were tried.
struct Seen {
	uint32_t walking = 0, sitting = 0, events = 0;
};

// Saves, loads into another simulation, and lives on in both.
void check_future(Simulation &original, Simulation &copy, Duration future, Seen &seen) {
	const std::string bytes = original.save();
	Diagnostics diagnostics;
	REQUIRE(copy.restore(bytes, diagnostics));
	CHECK(copy.save() == bytes);
	CHECK(copy.now() == original.now());
	for (uint32_t i = 0; i < original.person_count(); ++i) {
		const PersonView view = copy.view(PersonId(i));
		REQUIRE(view.position == original.position(PersonId(i)));
		REQUIRE(view.place == original.view(PersonId(i)).place);
		seen.walking += view.state == PersonState::Walking;
		seen.sitting += view.pose == AgentPose::Sit;
	}
	Recorder after_original, after_copy;
	original.add_observer(after_original);
	copy.add_observer(after_copy);
	original.step(future);
	copy.step(future);
	CHECK(after_original.lines == after_copy.lines);
	check_equal(original.statistics(), copy.statistics());
	CHECK(copy.save() == original.save());
	seen.events += uint32_t(after_copy.lines.size());
	original.remove_observer(after_original);
	copy.remove_observer(after_copy);
}

} // namespace

TEST_CASE("after loading the future is the same as without, at any time of random days") {
	Random random(7);
	Seen seen;
	for (uint64_t seed = 1; seed <= 6; ++seed) {
		Town lived, loaded;
		fill(lived, seed);
		fill(loaded, seed);
		Simulation &original = lived.simulate();
		original.start(moment(0, 4));
		for (int round = 0; round < 6; ++round) {
			original.step(Duration{ int64_t(random.index(9'000'000)) });
			check_future(original, loaded.simulate(), Duration{ 20'000'000 + int64_t(random.index(50'000'000)) }, seen);
		}
	}
	CHECK(seen.walking > 50);
	CHECK(seen.sitting > 5);
	CHECK(seen.events > 3000);
}

TEST_CASE("attributes that the host set are kept, for the rules that run later") {
	Town town;
	const BuildingId home = town.building("house", 0.0f), shop = town.building("shop", 60.0f);
	town.household(home);
	const PersonId otto = town.person();
	town.rules("Errand attr pause = 1h attr where = \"house\" attr goes = false Errand --> wait(pause) case goes: goToBuilding(findBuilding(where))");
	town.delayed(otto, at(8), at(20), "Errand");
	SimulationSettings settings;
	settings.overrides = { { "pause", 7200.0 }, { "where", "shop" }, { "goes", true } };
	Simulation &original = town.simulate(settings);
	original.start(moment(0, 6));
	const std::string bytes = original.save();
	Simulation &loaded = town.simulate();
	Diagnostics diagnostics;
	REQUIRE(loaded.restore(bytes, diagnostics));
	CHECK(loaded.settings().overrides.size() == 3);
	CHECK(loaded.save() == bytes);
	Recorder recorder;
	loaded.add_observer(recorder);
	loaded.advance_to(moment(0, 11));
	CHECK(recorder.has("10:00:00 0 set-out building " + std::to_string(index_of(shop))));
	loaded.remove_observer(recorder);
}

TEST_CASE("a simulation that runs takes an older state, with what the game had changed") {
	Town town;
	fill(town, 3);
	Simulation &simulation = town.simulate();
	simulation.start(moment(0, 7));
	simulation.advance_to(moment(0, 9));
	REQUIRE(simulation.take_over(PersonId(2)));
	REQUIRE(simulation.remove_person(PersonId(5)));
	REQUIRE(town.insert(PersonId(1), Town::entry(TaskKind::StayInside, at(13), at(14), 0), 0));
	const std::string bytes = simulation.save();
	Recorder first, second;
	simulation.add_observer(first);
	simulation.advance_to(moment(1, 12));
	simulation.remove_observer(first);
	InvariantChecker checker(simulation);
	simulation.add_observer(second);
	Diagnostics diagnostics;
	REQUIRE(simulation.restore(bytes, diagnostics));
	CHECK(simulation.now() == moment(0, 9));
	CHECK(simulation.view(PersonId(2)).presence == Presence::Taken);
	CHECK(simulation.view(PersonId(5)).presence == Presence::Removed);
	CHECK(simulation.plan_at(PersonId(1), moment(0, 13, 30)).target == 0);
	checker.check();
	simulation.advance_to(moment(1, 12));
	CHECK(first.lines == second.lines);
	simulation.flush_lived();
	checker.finish();
	CHECK(checker.broken_total() - checker.broken(Promise::NoChildAlone) == 0);
}

TEST_CASE("who sat on a bench that is not there any more after loading gets up") {
	Town town, later;
	for (Town *each : { &town, &later }) {
		const BuildingId home = each->building("house", 0.0f);
		each->zone("park", 100.0f, -20.0f, 40.0f);
		each->bench(110.0f, 0.0f);
		each->rules("Sit Sit --> goToZone(\"park\") goToObject(0) interact(0, \"sit\") waitUntilNextTask()");
		each->household(home);
		each->delayed(each->person(), at(8), at(12), "Sit");
	}
	Simulation &simulation = town.simulate();
	simulation.start(moment(0, 9));
	CHECK(simulation.view(PersonId(0)).pose == AgentPose::Sit);
	Simulation &loaded = later.simulate();
	later.city.remove_object(ObjectId(0));
	Diagnostics diagnostics;
	REQUIRE(loaded.restore(simulation.save(), diagnostics));
	loaded.advance_to(moment(0, 10));
	CHECK(loaded.state(PersonId(0)) == PersonState::Inside);
}

TEST_CASE("a damaged state is refused or harmless, and a refusal changes nothing") {
	Town town, target;
	fill(town, 5);
	fill(target, 5);
	Simulation &original = town.simulate();
	original.start(moment(0, 0));
	original.advance_to(moment(0, 11));
	const std::string good = original.save();
	Simulation &simulation = target.simulate();
	simulation.start(moment(0, 6));
	Random random(11);
	int refused = 0;
	for (int i = 0; i < 3000; ++i) {
		std::string bytes = good;
		if (random.chance(0.1)) {
			bytes.resize(random.index(bytes.size()));
		} else {
			for (size_t count = 1 + random.index(3); count > 0; --count) {
				bytes[random.index(bytes.size())] = random.chance(0.3) ? char(0xFF) : char(random.index(256));
			}
		}
		const std::string before = simulation.save();
		Diagnostics diagnostics;
		if (!simulation.restore(bytes, diagnostics)) {
			++refused;
			CHECK(diagnostics.error_count() == 1);
			REQUIRE(simulation.save() == before);
		} else if (simulation.now() < moment(50, 0)) {
			simulation.advance_to(simulation.now() + Duration::hours(30)); // must not crash, whatever it says
			REQUIRE(simulation.restore(good, diagnostics));
		}
	}
	CHECK(refused > 1000);
}

TEST_CASE("a state of other people, other rules or a larger city is refused with the reason") {
	Town town;
	fill(town, 5);
	Simulation &simulation = town.simulate();
	simulation.start(moment(0, 9));
	const std::string bytes = simulation.save();
	const auto message_of = [&](Town &other) {
		Diagnostics diagnostics;
		REQUIRE(!other.simulate().restore(bytes, diagnostics));
		return diagnostics.list()[0].message;
	};
	Town others;
	fill(others, 6);
	CHECK(message_of(others).find("contradicts") != std::string::npos);
	Town ruled;
	fill(ruled, 5);
	ruled.rules("Park --> wait(1) Errand --> wait(2) Stroll --> wait(3)");
	CHECK(message_of(ruled).find("other rules") != std::string::npos);
	for (const char *change : { "wait(rand(0, 91))", "goToZone(\"Park\")" }) { // one number, one letter
		Town changed;
		fill(changed, 5);
		std::string rules = random_rules;
		const std::string_view was = change[0] == 'w' ? "wait(rand(0, 90))" : "goToZone(\"park\")";
		rules.replace(rules.find(was), was.size(), change);
		changed.rules(rules);
		CHECK(message_of(changed).find("other rules") != std::string::npos);
	}
	Town small;
	small.building("house", 0.0f);
	small.program = town.program;
	CHECK(message_of(small).find("parts of the city") != std::string::npos);
	Town elsewhere;
	fill(elsewhere, 5);
	elsewhere.city.origin = 7;
	CHECK(message_of(elsewhere).find("another city") != std::string::npos);
}
