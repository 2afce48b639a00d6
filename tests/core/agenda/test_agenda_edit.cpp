#include <doctest/doctest.h>

#include "agenda_fixture.h"
#include "core/agenda/agenda_edit.h"

using namespace pcg;

namespace {

constexpr int32_t hour_ms = 3'600'000;
constexpr DayMask monday = 1;

Task stay(int start_hour, int end_hour, BuildingId building, DayMask days = all_days) {
	Task task;
	task.start_ms = start_hour * hour_ms;
	task.end_ms = end_hour * hour_ms;
	task.target = index_of(building);
	task.days = days;
	return task;
}

// A parent who brings a child to school and fetches it, if it was brought.
struct Family {
	AgendaFixture fixture;
	BuildingId home, school;
	PersonId parent, child;

	Family() {
		home = fixture.add_building("house", 0);
		school = fixture.add_building("school", 300);
		fixture.add_household(home);
		parent = fixture.add_person(40);
		child = fixture.add_person(6);
		REQUIRE(fixture.generate(R"(
@StartRule
Household -->
	members { age < 18: goToBuilding(7h50m, 8h, 1) stayInside(8h, 16h, 1) goToBuilding(16h, 16h10m, 0) }
	members { age > 18:
		task("bring") { accompany(8h - 2, age < 18) }
		requires("bring") { accompany(16h + 2, age < 18) } }
)"));
		REQUIRE(fixture.problems() == "");
	}
	AgendaChange insert(PersonId person, const Task &task) { return insert_task(fixture.agendas, fixture.population, person, task); }
};

} // namespace

TEST_CASE("an entry inserted later follows the same rule, and only that person's agenda changes") {
	Family family;
	const AgendaChange change = family.insert(family.child, stay(10, 11, family.home));
	CHECK(change.is_inserted);
	CHECK(change.changed == std::vector<PersonId>{ family.child });
	CHECK(change.dropped.empty());
	CHECK(family.fixture.day_of(family.child) ==
			"07:50-08:00 accompany to 1; 08:00-10:00 stay 1; 10:00-11:00 stay 0; 11:00-16:00 stay 1; 16:00-16:10 accompany to 0");
	CHECK(family.fixture.day_of(family.parent) == "07:50-08:00 accompany to 1; 16:00-16:10 accompany to 0");
}

TEST_CASE("a child that falls ill on Monday is not fetched on Monday") {
	Family family;
	const AgendaChange change = family.insert(family.child, stay(0, 24, family.home, monday));
	CHECK(change.changed == std::vector<PersonId>{ family.parent, family.child });
	REQUIRE(change.dropped.size() == 1);
	CHECK(change.dropped[0].person == family.parent);
	CHECK(change.dropped[0].reason == Unmet::Lost);
	CHECK(change.dropped[0].task.days == monday);
	CHECK(change.dropped[0].task.start_ms == 16 * hour_ms);
	CHECK(family.fixture.agendas.names[change.dropped[0].name] == "bring");
	CHECK(family.fixture.day_of(family.child, 0) == "00:00-24:00 stay 0");
	CHECK(family.fixture.day_of(family.parent, 0) == "07:50-08:00 accompany to 1");
	CHECK(family.fixture.day_of(family.parent, 1) == "07:50-08:00 accompany to 1; 16:00-16:10 accompany to 0");
}

TEST_CASE("a parent who cannot bring the child does not fetch it, and the child waits for nobody") {
	Family family;
	const AgendaChange change = family.insert(family.parent, stay(7, 9, family.home, monday));
	REQUIRE(change.dropped.size() == 1);
	CHECK(family.fixture.day_of(family.child, 0) == "07:50-08:00 accompany to 1; 08:00-16:00 stay 1");
	CHECK(family.fixture.day_of(family.parent, 0) == "07:00-09:00 stay 0");
}

TEST_CASE("entries inserted later can be named and required too") {
	Family family;
	AgendaSet &agendas = family.fixture.agendas;
	Task visit = stay(18, 19, family.school);
	visit.name = task_name(agendas, "visit");
	CHECK(task_name(agendas, "visit") == uint16_t(visit.name));
	CHECK(task_name(agendas, "bring") != uint16_t(visit.name));
	Task after = stay(20, 21, family.school);
	after.requirement = task_requirement(agendas, { uint16_t(visit.name), true, 0 });
	REQUIRE(family.insert(family.parent, visit).is_inserted);
	REQUIRE(family.insert(family.parent, after).dropped.empty());
	const AgendaChange change = family.insert(family.parent, stay(18, 20, family.home));
	REQUIRE(change.dropped.size() == 1);
	CHECK(change.dropped[0].task.start_ms == 20 * hour_ms);
	CHECK(family.fixture.day_of(family.parent) == "07:50-08:00 accompany to 1; 16:00-16:10 accompany to 0; 18:00-20:00 stay 0");
}

TEST_CASE("what cannot be inserted changes nothing") {
	Family family;
	CHECK_FALSE(family.insert(PersonId(99), stay(1, 2, family.home)).is_inserted);
	CHECK_FALSE(family.insert(family.child, stay(2, 2, family.home)).is_inserted);
	CHECK_FALSE(family.insert(family.child, stay(2, 3, family.home, 0)).is_inserted);
	CHECK(family.insert(family.child, stay(0, 30, family.home)).changed.empty());
	CHECK(family.fixture.agendas.changed.empty());
}
