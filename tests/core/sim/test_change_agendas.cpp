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
