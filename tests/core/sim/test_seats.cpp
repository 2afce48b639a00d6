#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "core/sim/invariants.h"
#include "tests/core/sim/commuter.h"

using namespace pcg;
using namespace pcg::test;

namespace {

// Three persons who want to sit on one bench all morning, and look for a seat every minute.
struct Sitters {
	Sitter town;
	std::vector<PersonId> persons;
	Simulation *simulation = nullptr;

	Sitters() {
		Town &t = town.town;
		t.rules("Sit Sit --> set(bench, findObject(\"bench\")) case isValid(bench): goToObject(bench) interact(bench, \"sit\")"
				" waitUntilNextTask() else: wait(1m) Sit");
		t.household(town.home);
		for (int i = 0; i < 3; ++i) {
			persons.push_back(t.person());
			t.delayed(persons.back(), at(8), at(12), "Sit");
		}
		simulation = &t.simulate();
		simulation->start(moment(0, 7));
	}
	void set_seats(size_t count) {
		CityObject bench = town.town.city.object(town.near);
		bench.places.resize(count);
		for (size_t i = 0; i < count; ++i) {
			bench.places[i] = { bench.position + glm::vec3(float(i), 0.0f, 0.0f), { 0.0f, 0.0f, 1.0f } };
		}
		town.town.city.put_object(town.near, bench);
	}
	size_t seated() const {
		return size_t(std::count_if(persons.begin(), persons.end(), [&](PersonId id) { return simulation->view(id).pose == AgentPose::Sit; }));
	}
};

} // namespace

TEST_CASE("a bench that gets and loses seats: who sits on one that is left stays, and who has lost its seat finds another or none") {
	Sitters t;
	Simulation &simulation = *t.simulation;
	InvariantChecker checker(simulation);
	simulation.jump_to(moment(0, 7));
	simulation.advance_to(moment(0, 9));
	CHECK(t.seated() == 1);
	t.set_seats(3);
	simulation.advance_to(moment(0, 9, 10));
	checker.check();
	CHECK(t.seated() == 3);
	CHECK(simulation.view(t.persons[0]).object_place == 0);
	t.set_seats(1);
	for (PersonId id : t.persons) {
		CHECK(std::isfinite(simulation.view(id).facing.z)); // before the simulation has heard of it
	}
	simulation.advance_to(moment(0, 9, 20));
	checker.check();
	CHECK(t.seated() == 1);
	CHECK(simulation.view(t.persons[0]).pose == AgentPose::Sit);
	CHECK(simulation.place_holder(t.town.near, 1) == PersonId::Invalid);
	simulation.flush_lived();
	checker.finish();
	CHECK(checker.broken_total() == 0);
}

TEST_CASE("a state of three on a bench is loaded after the bench has lost seats") {
	Sitters t;
	Simulation &simulation = *t.simulation;
	InvariantChecker checker(simulation);
	t.set_seats(3);
	simulation.jump_to(moment(0, 9));
	CHECK(t.seated() == 3);
	const std::string bytes = simulation.save();
	t.set_seats(1);
	Diagnostics diagnostics;
	CHECK(simulation.restore(bytes, diagnostics));
	simulation.advance_to(moment(0, 9));
	checker.check();
	CHECK(t.seated() == 1);
	CHECK(checker.broken_total() == 0);
}
