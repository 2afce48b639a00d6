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
	FileNumbers ids;
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

TEST_CASE("a walk together lists who comes along on the day of the row") {
	AgendaFixture fixture;
	fixture.add_building("house", 0);
	fixture.add_building("school", 100);
	fixture.add_household(BuildingId(0));
	for (float age : { 40.0f, 42.0f, 8.0f, 9.0f }) {
		fixture.add_person(age);
	}
	REQUIRE(fixture.generate("@StartRule\nHousehold --> members { age < 18: goToBuilding(8h, 9h, 1) } members { age == 40: accompany(8h, age < 18) }\n"
							 "members { age == 42: days(\"mon\") { accompany(8h, age == 9) } }"));
	CHECK(agendas_to_csv(fixture.agendas, fixture.population, *fixture.program, {}, 0) ==
			"household,person,age,gender,day,start,end,kind,target,detail\n"
			"0,0,40,w,mon,28800,32400,accompany,1,leader 0 joiners 2\n"
			"0,1,42,w,mon,28800,32400,accompany,1,leader 1 joiners 3\n"
			"0,2,8,w,mon,28800,32400,accompany,1,leader 0 joiners 2\n"
			"0,3,9,w,mon,28800,32400,accompany,1,leader 1 joiners 3\n");
	const std::string tuesday = agendas_to_csv(fixture.agendas, fixture.population, *fixture.program, {}, 1);
	CHECK(tuesday.find("0,3,9,w,tue,28800,32400,accompany,1,leader 0 joiners 2 3\n") != std::string::npos);
}

TEST_CASE("agendas that are written part by part are the same table, with the same messages") {
	AgendaFixture fixture;
	const BuildingId home = fixture.add_building("house", 0);
	fixture.add_building("school", 100);
	for (int i = 0; i < 700; ++i) {
		fixture.add_household(home);
		fixture.add_person(40);
		fixture.add_person(7, Gender::Man);
	}
	REQUIRE(fixture.generate(R"(
@StartRule
Household -->
	members { age < 18: task("go") { goToBuilding(8h, 8h + rand(1, 60), 1) } }
	members { age >= 18: requires("go") { accompany(8h, age < 18) } floatingTask(rand(1, 99), Rest) }
	case household.id % 100 == 77: members { true: stayInside(0, 1 / (count() - count()), home) }
Rest --> wait(1)
)"));
	const std::string whole = agendas_to_csv(fixture.agendas, fixture.population, *fixture.program, {}, std::nullopt);
	std::string text;
	AgendaCsvWriter writer(fixture.population, *fixture.program, {}, std::nullopt, [&text](std::string_view bytes) { text += bytes; });
	Diagnostics diagnostics;
	size_t last_done = 0;
	bool is_rising = true;
	AgendaOptions options = fixture.options;
	options.work.progress = [&](size_t done, size_t total) {
		is_rising = is_rising && done >= last_done && total == 700;
		last_done = done;
	};
	const StraightLinePaths paths(fixture.city);
	const auto take = [&writer](const AgendaSet &part, PersonId first) { writer.write(part, first); };
	CHECK(generate_agendas_in_parts(*fixture.program, fixture.city, paths, fixture.population, options, 300, take, diagnostics));
	CHECK(text == whole);
	CHECK(is_rising);
	CHECK(last_done == 700);
	CHECK(to_text(diagnostics) == to_text(fixture.diagnostics));
	CHECK(diagnostics.error_count() == 1);
}
