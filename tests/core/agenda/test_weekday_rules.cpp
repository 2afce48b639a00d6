#include <doctest/doctest.h>

#include "agenda_fixture.h"
#include "core/io/household_csv.h"
#include "core/population/population_generator.h"

using namespace pcg;

namespace {

// Home at 0 m, school at 450 m, work at 900 m.
AgendaFixture town() {
	AgendaFixture fixture;
	fixture.add_building("house", 0);
	fixture.add_building("school", 450);
	fixture.add_building("workplace", 900);
	return fixture;
}

// Everybody or nobody of an age does errands, so that the outcome is certain.
void set_shoppers(AgendaFixture &fixture, double adults, double elders) {
	fixture.options.overrides.push_back({ "adultShoppers", adults });
	fixture.options.overrides.push_back({ "elderShoppers", elders });
}

} // namespace

TEST_CASE("the weekday rules compile without a word") {
	AgendaFixture fixture = town();
	REQUIRE(fixture.generate_file("rules/agenda/weekday.pcg"));
	CHECK(fixture.problems() == "");
	REQUIRE(fixture.generate_file("rules/agenda/weekend.pcg"));
	CHECK(fixture.problems() == "");
}

TEST_CASE("the same adult brings the children to school, works and fetches them") {
	AgendaFixture fixture = town();
	fixture.add_household(BuildingId(0));
	const PersonId mother = fixture.add_person(40, Gender::Woman, 1.5f);
	const PersonId boy = fixture.add_person(6, Gender::Man, 0.9f);
	const PersonId girl = fixture.add_person(10, Gender::Woman, 1.2f);
	REQUIRE(fixture.generate_file("rules/agenda/weekday.pcg"));
	CHECK(fixture.problems() == "");
	// 450 m at the family's pace of 0.75 m/s are 10 minutes; 450 m at 1.5 m/s are 5 minutes.
	const std::string child = "00:00-07:50 stay 0; 07:50-08:00 accompany to 1; 08:00-16:00 stay 1; 16:00-16:10 accompany to 0; 16:10-24:00 stay 0";
	CHECK(fixture.day_of(boy) == child);
	CHECK(fixture.day_of(girl) == child);
	CHECK(fixture.day_of(mother) ==
			"00:00-07:50 stay 0; 07:50-08:00 accompany to 1; 08:00-15:50 go 2; 15:50-16:00 go 1; 16:00-16:10 accompany to 0; 16:10-24:00 stay 0");
	REQUIRE(fixture.agendas.groups.size() == 2);
	for (const Group &group : fixture.agendas.groups) {
		CHECK(group.leader == mother);
		CHECK(group.joiners == std::vector<PersonId>{ boy, girl });
	}
}

TEST_CASE("children who are old enough go alone at their own pace, and nobody stays behind for them") {
	AgendaFixture fixture = town();
	set_shoppers(fixture, 0.0, 0.0);
	fixture.add_household(BuildingId(0));
	const PersonId father = fixture.add_person(40, Gender::Man, 1.5f);
	const PersonId boy = fixture.add_person(12, Gender::Man, 1.25f);
	fixture.add_household(BuildingId(0));
	const PersonId mother = fixture.add_person(40, Gender::Woman, 1.5f);
	const PersonId elder_sister = fixture.add_person(17, Gender::Woman, 1.5f);
	const PersonId little_sister = fixture.add_person(11, Gender::Woman, 1.0f);
	REQUIRE(fixture.generate_file("rules/agenda/weekday.pcg"));
	CHECK(fixture.problems() == "");
	// 450 m at 1.25 m/s are 6 minutes, at 1.5 m/s 5 minutes, at the family's pace 10.
	CHECK(fixture.day_of(boy) == "00:00-07:54 stay 0; 07:54-08:00 go 1; 08:00-16:00 stay 1; 16:00-16:06 go 0; 16:06-24:00 stay 0");
	CHECK(fixture.day_of(elder_sister) == "00:00-07:55 stay 0; 07:55-08:00 go 1; 08:00-16:00 stay 1; 16:00-16:05 go 0; 16:05-24:00 stay 0");
	CHECK(fixture.day_of(father).find("accompany") == std::string::npos);
	CHECK(fixture.day_of(father).find("stay 2") != std::string::npos);
	REQUIRE(fixture.agendas.groups.size() == 2);
	for (const Group &group : fixture.agendas.groups) {
		CHECK(group.leader == mother);
		CHECK(group.joiners == std::vector<PersonId>{ little_sister });
	}
}

TEST_CASE("where the only adult is an elder, it brings the children and waits at home") {
	AgendaFixture fixture = town();
	fixture.add_household(BuildingId(0));
	const PersonId elder = fixture.add_person(70, Gender::Man, 0.75f);
	const PersonId child = fixture.add_person(8);
	REQUIRE(fixture.generate_file("rules/agenda/weekday.pcg"));
	CHECK(fixture.problems() == "");
	CHECK(fixture.day_of(elder) ==
			"00:00-07:50 stay 0; 07:50-08:00 accompany to 1; 08:00-15:45 go 0; 15:45-16:00 go 1; 16:00-16:10 accompany to 0; 16:10-24:00 stay 0");
	CHECK(fixture.day_of(child).find("07:50-08:00 accompany to 1") != std::string::npos);
}

TEST_CASE("of two adults one brings the children, the other goes straight to work") {
	AgendaFixture fixture = town();
	set_shoppers(fixture, 0.0, 0.0);
	int leaders[2] = {};
	for (int i = 0; i < 200; ++i) {
		fixture.add_household(BuildingId(0));
		fixture.add_person(40);
		fixture.add_person(42);
		fixture.add_person(7);
	}
	REQUIRE(fixture.generate_file("rules/agenda/weekday.pcg"));
	CHECK(fixture.problems() == "");
	REQUIRE(fixture.agendas.groups.size() == 400);
	for (size_t i = 0; i < 400; i += 2) {
		const Group &there = fixture.agendas.groups[i];
		const Group &back = fixture.agendas.groups[i + 1];
		CHECK(there.leader == back.leader);
		++leaders[index_of(there.leader) % 3];
		const PersonId other = PersonId(index_of(there.leader) + (index_of(there.leader) % 3 == 0 ? 1 : -1));
		CHECK(fixture.day_of(other).find("accompany") == std::string::npos);
		CHECK(fixture.day_of(other).find("stay 2") != std::string::npos);
	}
	// Each with probability 1/2: four standard deviations are 28.
	CHECK(leaders[0] > 72);
	CHECK(leaders[1] > 72);
}

TEST_CASE("work that is too far to be back in time is not visited between the two walks") {
	AgendaFixture fixture;
	fixture.add_building("house", 0);
	fixture.add_building("school", 450);
	fixture.add_building("workplace", 13'000); // 3 h 29 m from the school at 1 m/s: twice that and an hour do not fit
	fixture.add_household(BuildingId(0));
	const PersonId father = fixture.add_person(40, Gender::Man);
	fixture.add_person(6);
	REQUIRE(fixture.generate_file("rules/agenda/weekday.pcg"));
	CHECK(fixture.day_of(father).find("08:00-15:47:30 go 0; 15:47:30-16:00 go 1") != std::string::npos);
}

TEST_CASE("a city without school or work leaves everybody at home") {
	AgendaFixture fixture;
	set_shoppers(fixture, 0.0, 0.0);
	fixture.add_building("house", 0);
	fixture.add_household(BuildingId(0));
	const PersonId adult = fixture.add_person(40);
	const PersonId child = fixture.add_person(6);
	REQUIRE(fixture.generate_file("rules/agenda/weekday.pcg"));
	CHECK(fixture.day_of(adult) == "00:00-24:00 stay 0");
	CHECK(fixture.day_of(child) == "00:00-24:00 stay 0");
	CHECK(fixture.diagnostics.error_count() == 0);
	CHECK(fixture.problems() == "unknown-type unknown-type"); // school and workplace, each once
}

TEST_CASE("in a town of real households only children who are old enough or have no adult walk alone, and who fetches one is there in time") {
	AgendaFixture fixture;
	for (int i = 0; i < 400; ++i) {
		fixture.add_building(i % 10 == 0 ? "school" : i % 3 == 0 ? "workplace" : "house", 35.0f * float(i), 40);
	}
	const std::optional<HouseholdTable> table = read_household_table("rules/data/households_us_acs2023.csv", fixture.diagnostics);
	REQUIRE(table.has_value());
	PopulationOptions people;
	people.persons = 3000;
	fixture.population = generate_population(*table, fixture.city, people, fixture.diagnostics);
	REQUIRE(fixture.generate_file("rules/agenda/weekday.pcg"));
	CHECK(fixture.problems() == "");
	int brought = 0, alone = 0, wrong = 0;
	for (uint32_t i = 0; i < fixture.population.persons.size(); ++i) {
		const float age = fixture.population.persons[i].age;
		if (age < 18.0f) {
			++(age < 12.0f ? brought : alone);
			for (const Task &task : fixture.agendas.tasks_of(PersonId(i))) {
				wrong += task.kind == (age < 12.0f ? TaskKind::GoToBuilding : TaskKind::Accompany);
			}
		}
	}
	CHECK(brought > 200);
	CHECK(alone > 100);
	CHECK(wrong == 0);
	int late = 0;
	const BuildingId no_building = BuildingId::Invalid;
	for (const Group &group : fixture.agendas.groups) {
		BuildingId before = no_building; // where the leader is told to be when the group sets out
		for (const Task &task : fixture.agendas.tasks_of(group.leader)) {
			before = task.end_ms == group.start_ms ? BuildingId(task.target) : before;
		}
		BuildingId children_at = no_building;
		for (const Task &task : fixture.agendas.tasks_of(group.joiners.front())) {
			children_at = task.end_ms == group.start_ms ? BuildingId(task.target) : children_at;
		}
		late += before != children_at;
	}
	CHECK(late == 0);
}

TEST_CASE("on a weekend some households go shopping together, led by one adult") {
	AgendaFixture fixture;
	fixture.add_building("house", 0);
	fixture.add_building("shop", 450);
	fixture.options.overrides.push_back({ "outgoing", 1.0 });
	fixture.add_household(BuildingId(0));
	const PersonId adult = fixture.add_person(40);
	const PersonId child = fixture.add_person(8);
	REQUIRE(fixture.generate_file("rules/agenda/weekend.pcg"));
	CHECK(fixture.problems() == "");
	REQUIRE(fixture.agendas.groups.size() == 2);
	CHECK(fixture.agendas.groups[0].leader == adult);
	CHECK(fixture.agendas.groups[0].goal == BuildingId(1));
	CHECK(fixture.agendas.groups[1].goal == BuildingId(0));
	// home, to the shop (10 minutes), an hour inside, home again
	const auto tasks = fixture.agendas.tasks_of(child);
	REQUIRE(tasks.size() == 5);
	CHECK(tasks[1].kind == TaskKind::Accompany);
	CHECK(tasks[1].end_ms - tasks[1].start_ms == 600'000);
	CHECK(tasks[2].end_ms - tasks[2].start_ms == 3'600'000);
	CHECK(tasks[3].kind == TaskKind::Accompany);
	CHECK(fixture.agendas.floating_tasks_of(adult).size() == 2);
}

TEST_CASE("elders go to the park by a delayed rule") {
	AgendaFixture fixture = town();
	set_shoppers(fixture, 0.0, 0.0);
	fixture.add_household(BuildingId(0));
	const PersonId elder = fixture.add_person(70);
	REQUIRE(fixture.generate_file("rules/agenda/weekday.pcg"));
	const auto tasks = fixture.agendas.tasks_of(elder);
	REQUIRE(tasks.size() == 3);
	CHECK(tasks[1].kind == TaskKind::DelayedRule);
	CHECK(fixture.program->rules[tasks[1].target].name == "GoToPark");
	CHECK(tasks[1].start_ms >= 27'000'000); // 7:30
	CHECK(tasks[1].start_ms < 30'600'000);
	CHECK(tasks[1].end_ms >= 41'400'000); // 11:30
	const TaskOrigin &origin = fixture.agendas.origins[tasks[1].origin];
	CHECK(origin.rule == "ElderWeekday");
	CHECK(origin.file == "rules/agenda/weekday.pcg");
	CHECK(origin.line > 0);
}

TEST_CASE("some adults and elders do errands in the morning instead") {
	AgendaFixture fixture = town();
	set_shoppers(fixture, 1.0, 1.0);
	fixture.add_household(BuildingId(0));
	fixture.add_person(40);
	fixture.add_person(70);
	REQUIRE(fixture.generate_file("rules/agenda/weekday.pcg"));
	CHECK(fixture.problems() == "");
	for (uint32_t person = 0; person < 2; ++person) {
		const auto tasks = fixture.agendas.tasks_of(PersonId(person));
		REQUIRE(tasks.size() == 3);
		CHECK(tasks[1].kind == TaskKind::DelayedRule);
		CHECK(fixture.program->rules[tasks[1].target].name == "GoShopping");
		CHECK(tasks[1].start_ms >= 30'600'000); // 8:30
		CHECK(tasks[1].start_ms < 41'400'000); // 11:30
		CHECK(tasks[1].end_ms == 46'800'000); // 13:00
	}
}

TEST_CASE("Listing 2 as printed gets the messages that it deserves") {
	AgendaFixture fixture;
	CHECK_FALSE(fixture.generate_file("rules/paper/weekday_as_printed.pcg"));
	bool has_visit_park = false;
	bool has_dots = false;
	for (const Diagnostic &diagnostic : fixture.diagnostics.list()) {
		CHECK(diagnostic.file == "rules/paper/weekday_as_printed.pcg");
		has_visit_park |= diagnostic.line == 31 && diagnostic.message.find("VisitPark") != std::string::npos &&
				diagnostic.hint.find("GoToPark") != std::string::npos;
		has_dots |= diagnostic.line == 49;
	}
	CHECK(has_visit_park);
	CHECK(has_dots);
	CHECK(fixture.diagnostics.error_count() == 2);
}

TEST_CASE("Listing 2 with its two slips corrected runs as it is") {
	AgendaFixture fixture = town();
	FileSourceProvider files;
	Result<std::string> text = files.read("rules/paper/weekday_as_printed.pcg");
	REQUIRE(text.is_ok());
	text->replace(text->find("VisitPark"), 9, "GoToPark");
	text->replace(text->find("..."), 3, "   ");
	fixture.add_household(BuildingId(0));
	const PersonId adult = fixture.add_person(40, Gender::Woman, 1.5f);
	const PersonId child = fixture.add_person(6, Gender::Man, 0.75f);
	REQUIRE(fixture.generate(*text));
	CHECK(fixture.problems() == "");
	CHECK(fixture.day_of(child) == "00:00-07:50 stay 0; 07:50-08:00 accompany to 1; 08:00-16:00 stay 1; 16:00-16:10 go 0; 16:10-24:00 stay 0");
	// The adult leaves for work between 7:45 and 7:55 and is pulled back to the school: why the mended rules write the day anew.
	CHECK(fixture.day_of(adult).find("07:50-08:00 accompany to 1") != std::string::npos);
}
