#include <doctest/doctest.h>

#include "../agenda/agenda_fixture.h"
#include "core/io/agenda_csv.h"

using namespace pcg;

TEST_CASE("agendas are a row for each entry and day, with the numbers of the files") {
	AgendaFixture fixture;
	fixture.add_building("house", 0);
	fixture.add_building("school", 100);
	fixture.add_household(BuildingId(0));
	fixture.add_person(40);
	fixture.add_person(6.5f, Gender::Man);
	REQUIRE(fixture.generate("@StartRule\nHousehold --> members { age < 18: Child } members { age >= 18: Adult }\n"
							 "Child --> days(\"mon\") { goToBuilding(8h, 8h + 0.25, 1) }\n"
							 "Adult --> accompany(8h, age < 18) days(\"mon\") { delayedRule(23h, 25h, Rest) floatingTask(90, Rest, 2) }\n"
							 "Rest --> wait(1)"));
	FileIds buildings;
	buildings.add(70);
	buildings.add(71);
	FileIds persons;
	persons.add(500);
	persons.add(501);
	AgendaCsvIds ids;
	ids.buildings = &buildings;
	ids.persons = &persons;
	CHECK(agendas_to_csv(fixture.agendas, fixture.population, *fixture.program, ids, std::nullopt) ==
			"household,person,age,gender,day,start,end,kind,target,detail\n"
			"0,500,40,w,mon,28800,28800.25,accompany,71,leader 500 joiners 501\n"
			"0,500,40,w,mon,82800,90000,delayedRule,,Rest\n"
			"0,500,40,w,mon,,90,floatingTask,,Rest priority 2\n"
			"0,501,6.5,m,mon,28800,28800.25,accompany,71,leader 500 joiners 501\n");
	CHECK(agendas_to_csv(fixture.agendas, fixture.population, *fixture.program, ids, 5) ==
			"household,person,age,gender,day,start,end,kind,target,detail\n");
}
