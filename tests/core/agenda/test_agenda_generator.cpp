#include <doctest/doctest.h>

#include <atomic>
#include <cmath>

#include "agenda_fixture.h"

using namespace pcg;

namespace {

// Households of one to four persons with homes along a street.
AgendaFixture street(size_t households) {
	AgendaFixture fixture;
	fixture.add_building("school", 300);
	for (int i = 0; i < 20; ++i) {
		fixture.add_building("workplace", 1000.0f + 70.0f * float(i));
	}
	Random random(4, 4);
	for (size_t i = 0; i < households; ++i) {
		fixture.add_household(fixture.add_building("house", float(10 * i)));
		const size_t members = 1 + random.index(4);
		for (size_t k = 0; k < members; ++k) {
			fixture.add_person(k == 0 ? 40.0f : float(random.index(90)));
		}
	}
	return fixture;
}

std::string everybodys_monday(const AgendaFixture &fixture) {
	std::string text;
	for (uint32_t i = 0; i < fixture.population.persons.size(); ++i) {
		text += fixture.day_of(PersonId(i)) + "\n";
	}
	return text;
}

const char *const random_rules = R"(
attr hours = 2
@StartRule
Household -->
	members { true: Day }
Day -->
	set(start, rand(0, 20h))
	stayInside(start, start + hours * 1h, home)
)";

} // namespace

TEST_CASE("any number of threads writes the same agendas and the same messages") {
	AgendaFixture one = street(1500);
	AgendaFixture many = street(1500);
	one.options.work.threads = 1;
	many.options.work.threads = 5;
	const std::string rules = R"(
@StartRule
Household -->
	members { age < 18: goToBuilding(7h, 8h, findBuilding("workplace"))
	        | true: goToBuilding(7h, 8h, findBuilding("office")) }
	members { chooseMember(true): Lead }
	case household.id % 100 == 77: members { true: stayInside(0, 1 / (count() - count()), home) }
Lead -->
	accompany(7h + 1, age < 18)
	floatingTask(rand(1, 100), Rest)
Rest -->
	wait(1)
)";
	REQUIRE(one.generate(rules));
	REQUIRE(many.generate(rules));
	CHECK(everybodys_monday(one) == everybodys_monday(many));
	CHECK(to_text(one.diagnostics) == to_text(many.diagnostics));
	CHECK(one.diagnostics.error_count() == 1); // of the households 77, 177 .. 1477
	CHECK(to_text(one.diagnostics).find("and the same 14 times more") != std::string::npos);
	REQUIRE(one.agendas.groups.size() == many.agendas.groups.size());
	REQUIRE(one.agendas.groups.size() > 256);
	for (const Task &task : one.agendas.tasks) {
		CHECK(task.origin < one.agendas.origins.size());
		CHECK((task.kind != TaskKind::Accompany || task.target < one.agendas.groups.size()));
	}
	REQUIRE(one.agendas.floating_tasks.size() == 1500);
	CHECK(one.agendas.floating_tasks[1234].duration_ms == many.agendas.floating_tasks[1234].duration_ms);
}

TEST_CASE("what a household draws does not depend on the others") {
	AgendaFixture all = street(40);
	AgendaFixture few = street(20);
	REQUIRE(all.generate(random_rules));
	REQUIRE(few.generate(random_rules));
	for (uint32_t i = 0; i < few.population.persons.size(); ++i) {
		CHECK(all.day_of(PersonId(i)) == few.day_of(PersonId(i)));
	}
	AgendaFixture other = street(20);
	other.options.seed = 2;
	REQUIRE(other.generate(random_rules));
	CHECK(other.day_of(PersonId(0)) != few.day_of(PersonId(0)));
}

TEST_CASE("attributes can be set from outside, and a wrong name is told with the closest") {
	AgendaFixture fixture = street(1);
	fixture.options.overrides.push_back({ "hours", 3.0 });
	REQUIRE(fixture.generate(random_rules));
	CHECK(fixture.problems() == "");
	const Task task = fixture.agendas.tasks_of(PersonId(0))[0];
	CHECK(task.end_ms - task.start_ms == 3 * 3'600'000);

	AgendaFixture wrong = street(1);
	wrong.options.overrides.push_back({ "huors", 3.0 });
	wrong.generate(random_rules);
	REQUIRE(wrong.problems() == "unknown-attribute");
	CHECK(wrong.diagnostics.list()[0].hint == "did you mean 'hours'?");
	CHECK(wrong.agendas.tasks.empty());
	CHECK(wrong.agendas.person_count() == wrong.population.persons.size());
}

namespace {

// A house 10, a school 7, a shop 9; households 50 and 77 of persons 100, 101 and 205, 1; a bench 300.
struct NumberedTown {
	AgendaFixture fixture;
	FileIds buildings, households, persons, objects;

	NumberedTown() {
		const BuildingId home = fixture.add_building("house", 0);
		fixture.add_building("school", 100);
		fixture.add_building("shop", 50);
		for (const int64_t number : { 10, 7, 9 }) {
			buildings.add(number);
		}
		for (const int64_t number : { 50, 77 }) {
			fixture.add_household(home);
			households.add(number);
			fixture.add_person(40);
			fixture.add_person(12);
		}
		for (const int64_t number : { 100, 101, 205, 1 }) {
			persons.add(number);
		}
		CityObject bench;
		bench.type = fixture.city.types.add("bench");
		bench.places = { { { 0, 0, 0 }, { 0, 0, 1 } } };
		fixture.city.add_object(bench);
		objects.add(300);
		fixture.options.numbers = { .buildings = &buildings, .objects = &objects, .households = &households, .persons = &persons };
	}
};

} // namespace

TEST_CASE("rules and messages know the ids of the user's files") {
	NumberedTown town;
	AgendaFixture &fixture = town.fixture;
	REQUIRE(fixture.generate(R"(
@StartRule
Household -->
	case household.id == 50 && home == 10 && findObject("bench") == 300:
		members { person.id == 101: goToBuilding(8h, 9h, 7) | 100: stayInside(8h, 9h, findBuilding("shop")) }
	case household.id == 77 && findNearestBuilding("school", home) == 7 && getDistance(home, 7) == 100:
		members { chooseMember(person.id == 1): stayInside(1h, 2h, 7) }
		members { person.id == 205: stayInside(1h, 2h, 0) }
	else: goToBuilding(8h, 9h, 7)
)"));
	CHECK(fixture.day_of(PersonId(0)) == "08:00-09:00 stay 2");
	CHECK(fixture.day_of(PersonId(1)) == "08:00-09:00 go 1");
	CHECK(fixture.day_of(PersonId(2)) == "");
	CHECK(fixture.day_of(PersonId(3)) == "01:00-02:00 stay 1");
	REQUIRE(fixture.problems() == "no-building");
	CHECK(fixture.diagnostics.list()[0].message ==
			"household 77: 'stayInside' is given 0, which is no building of the city, so nothing is inserted");
}

TEST_CASE("ids that rules cannot tell apart or take for none are counted from 0") {
	AgendaFixture fixture;
	fixture.add_household(fixture.add_building("house", 0));
	fixture.add_person(40);
	FileIds buildings, households;
	buildings.add(-4);
	households.add((int64_t(1) << 53) + 1);
	fixture.options.numbers = { .buildings = &buildings, .households = &households };
	REQUIRE(fixture.generate("@StartRule\nHousehold --> case home == 0 && household.id == 0: members { true: stayInside(1h, 2h, home) stayInside(1h, 2h, 5) }"));
	CHECK(fixture.day_of(PersonId(0)) == "01:00-02:00 stay 0");
	REQUIRE(fixture.problems() == "no-building");
	CHECK(fixture.diagnostics.list()[0].message.starts_with("household 9007199254740993: "));
	CHECK(fixture.diagnostics.list()[0].hint ==
			"an id of the city's file is below 0 or above 2^53, so rules count buildings from 0 in the order of the file: find one by its type, as in "
			"findBuilding(\"school\")");
}

TEST_CASE("what a text means to an attribute depends on the rules; a value of another type or for a constant is told") {
	AgendaFixture fixture = street(1);
	REQUIRE(fixture.generate("attr start = 8h\nattr kind = \"shop\"\nattr open = true\nanything = rand(0, 1)\nconst last = 9h\n"
							 "@StartRule\nHousehold --> members { true: stayInside(start, start + 1, home) }"));
	const Program &program = *fixture.program;
	CHECK(attribute_value(program, "start", "8h30m") == AttributeValue(30'600.0));
	CHECK(attribute_value(program, "start", "-5m") == AttributeValue(-300.0));
	CHECK(attribute_value(program, "start", "2.5") == AttributeValue(2.5));
	CHECK(attribute_value(program, "start", "8x") == AttributeValue("8x"));
	CHECK(attribute_value(program, "kind", "5") == AttributeValue("5"));
	CHECK(attribute_value(program, "open", "false") == AttributeValue(false));
	const auto problem_of = [&](const char *name, AttributeValue value) {
		const std::optional<Diagnostic> problem = attribute_problem(program, { name, std::move(value) });
		return problem ? std::string(problem->id) + ": " + problem->message + " / " + problem->hint : std::string();
	};
	CHECK(problem_of("start", 9.0) == "");
	CHECK(problem_of("anything", 0.5) == "");
	CHECK(problem_of("strat", 9.0) == "unknown-attribute: 'strat' is no attribute of the rules / did you mean 'start'?");
	CHECK(problem_of("last", 9.0) == "const-attribute: 'last' is const in the rules and cannot be set from outside / declare it with attr");
	CHECK(problem_of("start", "soon") == "attribute-type: 'start' is a number in the rules, not text / give it a value of that type");
	CHECK(problem_of("start", double(NAN)).starts_with("attribute-not-finite: 'start' is given "));
	CHECK(problem_of("anything", double(INFINITY)).starts_with("attribute-not-finite: "));
	fixture.options.overrides = { { "start", true }, { "last", 1.0 } };
	fixture.diagnostics = Diagnostics();
	fixture.generate("attr start = 8h\nconst last = 9h\n@StartRule\nHousehold --> members { true: stayInside(start, last, home) }");
	CHECK(fixture.problems() == "attribute-type const-attribute");
	CHECK(fixture.agendas.tasks.empty());
}

TEST_CASE("another start rule can be named; a missing one is an error and nobody has entries") {
	AgendaFixture fixture = street(3);
	fixture.options.start_rule = "Other";
	REQUIRE(fixture.generate("@StartRule\nHousehold --> members { true: stayInside(1h, 2h, home) }\nOther --> members { true: stayInside(3h, 4h, home) }"));
	CHECK(fixture.day_of(PersonId(0)) == "03:00-04:00 stay " + std::to_string(index_of(fixture.population.households[0].home)));
	AgendaFixture missing = street(3);
	missing.options.start_rule = "Nothing";
	missing.generate("@StartRule\nHousehold --> members { true: stayInside(1h, 2h, home) }");
	REQUIRE(missing.problems() == "no-start-rule");
	CHECK(missing.diagnostics.list()[0].hint == "name another start rule, or none for the one that is marked @StartRule");
	CHECK(missing.agendas.tasks_of(PersonId(0)).empty());
	AgendaFixture misspelt = street(3);
	misspelt.options.start_rule = "Houshold";
	misspelt.generate("@StartRule\nHousehold --> members { true: stayInside(1h, 2h, home) }");
	REQUIRE(misspelt.problems() == "no-start-rule");
	CHECK(misspelt.diagnostics.list()[0].hint == "did you mean 'Household'?");
}

TEST_CASE("each type that the city lacks is one warning, also where one call asks for several of them") {
	AgendaFixture fixture = street(600); // more than one batch of households
	REQUIRE(fixture.generate("@StartRule\nHousehold --> members { true: Visit(\"zoo\") Visit(\"park\") }\n"
							 "Visit(type) --> set(goal, findBuilding(type)) set(bench, findObject(type))\n"));
	REQUIRE(fixture.problems() == "unknown-type unknown-type unknown-type unknown-type");
	const std::vector<Diagnostic> &told = fixture.diagnostics.list();
	CHECK(told[0].message == "the city has no building of type 'zoo'");
	CHECK(told[0].hint == "add lots whose rules make one: entrance(\"zoo\")");
	CHECK(told[0].line == 3);
	CHECK(told[1].message == "the city has no object of type 'zoo'");
	CHECK(told[2].message == "the city has no building of type 'park'");
	CHECK(told[3].message == "the city has no object of type 'park'");
}

TEST_CASE("rules that read the day draw the same on each day, and entries equal on all days are one") {
	AgendaFixture fixture = street(1);
	REQUIRE(fixture.generate("@StartRule\nHousehold --> set(start, rand(0, 10h)) case day >= 0: members { true: Day }\n"
							 "Day --> stayInside(start, start + 1h, home) floatingTask(60, Rest)\nRest --> wait(1)"));
	CHECK(fixture.problems() == "");
	REQUIRE(fixture.agendas.tasks_of(PersonId(0)).size() == 1);
	CHECK(fixture.agendas.tasks_of(PersonId(0))[0].days == pcg::all_days);
	CHECK(fixture.agendas.floating_tasks_of(PersonId(0)).size() == 7); // one for each day
}

TEST_CASE("nobody, or a household without members, is no trouble") {
	AgendaFixture nobody;
	REQUIRE(nobody.generate(random_rules));
	CHECK(nobody.agendas.person_count() == 0);
	AgendaFixture empty;
	empty.add_household(BuildingId::Invalid);
	REQUIRE(empty.generate(random_rules));
	CHECK(empty.problems() == "");
}

TEST_CASE("a household whose home is gone gets a warning and no entries there") {
	AgendaFixture fixture;
	fixture.add_household(BuildingId::Invalid);
	fixture.add_person(30);
	REQUIRE(fixture.generate(random_rules));
	CHECK(fixture.problems() == "no-building");
	CHECK(fixture.agendas.tasks.empty());
}

TEST_CASE("an agenda that grows without end is an error") {
	AgendaFixture fixture = street(1);
	REQUIRE(fixture.generate("@StartRule\nHousehold --> members { true: More(0) }\n"
							 "More(n) --> stayInside(n * 10, n * 10 + 5, home) case n % 900 < 899: More(n + 1) else: [ More2(n + 1) ]\n"
							 "More2(n) --> stayInside(n, n + 1, home)"));
	CHECK(fixture.diagnostics.error_count() == 0);
	AgendaFixture endless = street(1);
	REQUIRE(endless.generate("@StartRule\nHousehold --> members { true: Half(0, 13) }\n"
							 "Half(at, depth) --> case depth > 0: Half(at, depth - 1) Half(at + pow(2, depth - 1), depth - 1) "
							 "else: stayInside(at, at + 0.5, home)"));
	CHECK(endless.problems() == "agenda-too-long");
	CHECK(endless.agendas.tasks_of(PersonId(0)).size() > 4000);
}

TEST_CASE("generation can be cancelled") {
	AgendaFixture fixture = street(600);
	const std::atomic<bool> cancel = true;
	fixture.options.work.cancel = &cancel;
	REQUIRE(fixture.generate(random_rules));
	CHECK(fixture.problems() == "cancelled");
	CHECK(fixture.agendas.person_count() == fixture.population.persons.size());
}

TEST_CASE("chooseMember decides ties with equal chances") {
	AgendaFixture fixture;
	const BuildingId home = fixture.add_building("house", 0);
	for (int i = 0; i < 3000; ++i) {
		fixture.add_household(home);
		fixture.add_person(40);
		fixture.add_person(41);
		fixture.add_person(42);
		fixture.add_person(12);
	}
	REQUIRE(fixture.generate("@StartRule\nHousehold --> members { chooseMember(age >= 18): stayInside(0h, 1h, home) } "
							 "members { chooseMember(case age >= 18: 5 else: 1): stayInside(2h, 3h, home) }"));
	int chosen[2][4] = {};
	for (uint32_t i = 0; i < fixture.population.persons.size(); ++i) {
		for (const Task &task : fixture.agendas.tasks_of(PersonId(i))) {
			++chosen[task.start_ms > 0][i % 4];
		}
	}
	for (const auto &counts : chosen) {
		CHECK(counts[3] == 0);
		CHECK(counts[0] + counts[1] + counts[2] == 3000);
		for (int k = 0; k < 3; ++k) {
			CHECK(std::abs(counts[k] - 1000) < 104); // four standard deviations of a binomial count
		}
	}
}
