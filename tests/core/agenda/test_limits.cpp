#include <doctest/doctest.h>

#include <string>

#include "agenda_fixture.h"

using namespace pcg;

// What a hostile or careless author may write: each ends in a message, and the rest of the city lives on.
namespace {

AgendaFixture two_households() {
	AgendaFixture fixture;
	fixture.add_building("house", 0);
	fixture.add_household(BuildingId(0));
	fixture.add_person(40);
	fixture.add_household(BuildingId(0));
	fixture.add_person(41);
	return fixture;
}

} // namespace

TEST_CASE("a rule set of 100,000 rules is read and used") {
	AgendaFixture fixture = two_households();
	std::string rules = "@StartRule\nHousehold --> members { true: R0 }\n";
	constexpr int count = 100'000;
	for (int i = 0; i < count; ++i) {
		rules += "R" + std::to_string(i) + " --> case " + std::to_string(i) + " == age: stayInside(0h, 1h, home) else: ";
		rules += i + 1 < 100 ? "R" + std::to_string(i + 1) + "\n" : "delayedRule(0h, 1h, R" + std::to_string((i + 1) % count) + ")\n";
	}
	REQUIRE(fixture.generate(rules));
	CHECK(fixture.diagnostics.error_count() == 0);
	CHECK(fixture.day_of(PersonId(0)) == "00:00-01:00 stay 0");
}

TEST_CASE("a household of 65,535 members is written, and rules that multiply its members are stopped") {
	AgendaFixture fixture;
	fixture.add_building("house", 0);
	fixture.add_building("shop", 100);
	fixture.add_household(BuildingId(0));
	for (int i = 0; i < 65'535; ++i) {
		fixture.add_person(i == 0 ? 40.0f : 10.0f);
	}
	fixture.add_household(BuildingId(0));
	const PersonId neighbor = fixture.add_person(41);
	REQUIRE(fixture.generate(R"(
@StartRule
Household -->
	members { true: stayInside(0h, 8h, home) }
	members { age < 18: goToBuilding(9h, 10h, 1) }
	[ case count() > 1: members { age == 40: accompany(9h + 1, age < 18) } ]
	members { true: members { true: stayInside(20h, 21h, home) } }
)"));
	CHECK(fixture.problems() == "step-limit");
	CHECK(fixture.diagnostics.list()[0].hint == "blocks and conditions run inside of each other here, and their numbers multiply: ask once beforehand and keep the answer");
	CHECK(fixture.day_of(PersonId(65'534)).find("09:00-10:00 accompany to 1") != std::string::npos);
	CHECK(fixture.day_of(neighbor) == "00:00-08:00 stay 0; 20:00-21:00 stay 0");
}

TEST_CASE("what multiplies is told from rules that call each other without an end") {
	const auto hint = [](const std::string &rules, int members = 4) {
		AgendaFixture fixture;
		fixture.add_building("house", 0);
		fixture.add_household(BuildingId(0));
		for (int i = 0; i < members; ++i) {
			fixture.add_person(40);
		}
		REQUIRE(fixture.generate("@StartRule\nHousehold --> " + rules));
		REQUIRE(fixture.problems() == "step-limit");
		return fixture.diagnostics.list()[0].hint;
	};
	std::string nested = "stayInside(0h, 1h, home)";
	for (int i = 0; i < 40; ++i) {
		nested = "members { true: " + nested + " }";
	}
	CHECK(hint(nested).starts_with("blocks and conditions run inside of each other"));
	CHECK(hint("members { count(age > 3) > 1: stayInside(0h, 1h, home) }", 2000).starts_with("blocks and conditions run inside of each other"));
	CHECK(hint("Twice(0)\nTwice(n) --> case n < 900: Twice(n + 1) Twice(n + 1)") == "do rules call each other without an end?");
}

TEST_CASE("rules that hand each other on, the last one first, are followed at once") {
	AgendaFixture fixture = two_households();
	std::string rules = "@StartRule\nHousehold --> members { true: delayedRule(0h, 1h, R99999) }\nR0 --> stayInside(0h, 1h, home)\n";
	for (int i = 1; i < 100'000; ++i) {
		rules += "R" + std::to_string(i) + " --> floatingTask(5m, R" + std::to_string(i - 1) + ")\n";
	}
	REQUIRE(fixture.generate(rules));
	CHECK(fixture.diagnostics.error_count() == 0);
	CHECK(fixture.diagnostics.warning_count() == 100'000); // each writes agendas when it runs later
}

TEST_CASE("one run-time error of every household is one message with a count") {
	AgendaFixture fixture;
	fixture.add_building("house", 0);
	for (int i = 0; i < 1000; ++i) {
		fixture.add_household(BuildingId(0));
		fixture.add_person(40);
	}
	REQUIRE(fixture.generate("@StartRule\nHousehold --> members { true: stayInside(0h, 8h, home) } members { true: stayInside(0, 1 / (count() - 1), home) }"));
	REQUIRE(fixture.problems() == "division-by-zero");
	CHECK(fixture.diagnostics.list()[0].message.find("household 0: ") == 0);
	CHECK(fixture.diagnostics.list()[0].message.find("and the same 999 times more") != std::string::npos);
	CHECK(fixture.day_of(PersonId(999)) == "00:00-08:00 stay 0");
}

TEST_CASE("an entry that is required by every household's is told once with a count") {
	AgendaFixture fixture;
	fixture.add_building("house", 0);
	for (int i = 0; i < 1000; ++i) {
		fixture.add_household(BuildingId(0));
		fixture.add_person(40);
	}
	REQUIRE(fixture.generate("@StartRule\nHousehold --> members { true: requires(\"work\") { stayInside(0h, 8h, home) } }"));
	REQUIRE(fixture.problems() == "requirement-unmet");
	CHECK(fixture.diagnostics.list()[0].message == "household 0: person 0 drops 'stayInside' at 00:00 (every day): nobody there has 'work', and the same 999 times more");
}

TEST_CASE("what is required in vain for different reasons is told for each") {
	AgendaFixture fixture;
	fixture.add_building("house", 0);
	for (int i = 0; i < 10; ++i) {
		fixture.add_household(BuildingId(0));
		fixture.add_person(i < 3 ? 40 : 50);
	}
	REQUIRE(fixture.generate("@StartRule\nHousehold --> members { age == 50: task(\"work\") { stayInside(2h, 10h, home) } }\n"
							 "members { true: after(\"work\") { stayInside(8h, 9h, home) } }"));
	REQUIRE(fixture.problems() == "requirement-unmet requirement-unmet");
	const std::vector<Diagnostic> &told = fixture.diagnostics.list();
	CHECK(told[0].message == "household 0: person 0 drops 'stayInside' at 08:00 (every day): nobody there has 'work', and the same 2 times more");
	CHECK(told[1].message == "household 3: person 3 drops 'stayInside' at 08:00 (every day): 'work' is not over by then, and the same 6 times more");
	CHECK(told[1].hint == "let 'work' end before, or this begin later");
}

TEST_CASE("names without end are an error") {
	AgendaFixture fixture;
	fixture.add_building("house", 0);
	fixture.add_household(BuildingId(0));
	fixture.add_person(40);
	REQUIRE(fixture.generate("@StartRule\nHousehold --> members { true: Again(0) }\n"
							 "Again(i) --> Name(\"a\" + i) Name(\"b\" + i) Name(\"c\" + i) Name(\"d\" + i) case i < 500: Again(i + 1)\n"
							 "Name(name) --> task(name) { stayInside(0h, 1h, home) }"));
	CHECK(fixture.problems() == "too-many-names");
	CHECK(fixture.day_of(PersonId(0)) == "00:00-01:00 stay 0");
}
