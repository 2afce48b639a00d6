#include <doctest/doctest.h>

#include "agenda_fixture.h"
#include "core/agenda/agenda_edit.h"
#include "core/base/random.h"

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
	AgendaChange insert(PersonId person, const Task &task, std::optional<int64_t> day = std::nullopt) {
		return insert_task(fixture.agendas, fixture.population, person, task, day);
	}
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
	REQUIRE(change.dropped.size() == 2);
	CHECK(change.dropped[0].person == family.parent);
	CHECK(change.dropped[0].reason == Unmet::Lost);
	CHECK(change.dropped[1].person == family.child);
	CHECK(change.dropped[1].reason == Unmet::Leaderless);
	CHECK(change.dropped[1].task.kind == TaskKind::Accompany);
	CHECK(change.dropped[1].task.days == monday);
	CHECK(family.fixture.day_of(family.child, 0) == "07:50-08:00 go 1; 08:00-16:00 stay 1");
	CHECK(family.fixture.day_of(family.child, 1).starts_with("07:50-08:00 accompany to 1; "));
	CHECK(family.fixture.day_of(family.parent, 0) == "07:00-09:00 stay 0");
}

TEST_CASE("who walks with a leader on one day is told of that day") {
	Family family;
	const uint32_t group = family.fixture.agendas.tasks_of(family.child)[0].target;
	REQUIRE(family.insert(family.child, stay(7, 9, family.home), 8).is_inserted);
	CHECK(joiners_on_day(family.fixture.agendas, group, 1) == std::vector{ family.child });
	CHECK(joiners_on_day(family.fixture.agendas, group, 8).empty());
	CHECK(joiners_on_day(family.fixture.agendas, group, 15) == std::vector{ family.child });
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

TEST_CASE("an entry for one day obeys the same rule there, and leaves all other weeks alone") {
	Family family;
	const AgendaChange change = family.insert(family.child, stay(10, 11, family.home), 8); // the second Tuesday
	CHECK(change.is_inserted);
	CHECK(change.changed == std::vector<PersonId>{ family.child });
	CHECK(change.dropped.empty());
	const std::string usual = family.fixture.day_of(family.child, 7);
	CHECK(family.fixture.day_of(family.child, 8) ==
			"07:50-08:00 accompany to 1; 08:00-10:00 stay 1; 10:00-11:00 stay 0; 11:00-16:00 stay 1; 16:00-16:10 accompany to 0");
	CHECK(family.fixture.day_of(family.child, 1) == usual);
	CHECK(family.fixture.day_of(family.child, 9) == usual);
	CHECK(family.fixture.agendas.agenda_of(family.child).single_days.size() == 1);
	CHECK(family.fixture.agendas.agenda_of(family.parent).single_days.empty());
	forget_days_before(family.fixture.agendas, 9);
	CHECK(family.fixture.day_of(family.child, 8) == usual);
}

TEST_CASE("a child that falls ill on one Monday is not fetched on that Monday") {
	Family family;
	const AgendaChange change = family.insert(family.child, stay(0, 24, family.home), 14);
	CHECK(change.changed == std::vector<PersonId>{ family.parent, family.child });
	REQUIRE(change.dropped.size() == 1);
	CHECK(change.dropped[0].person == family.parent);
	CHECK(change.dropped[0].reason == Unmet::Lost);
	CHECK(change.dropped[0].day == 14);
	CHECK(change.dropped[0].task.days == monday);
	CHECK(family.fixture.day_of(family.child, 14) == "00:00-24:00 stay 0");
	CHECK(family.fixture.day_of(family.parent, 14) == "07:50-08:00 accompany to 1");
	CHECK(family.fixture.day_of(family.parent, 7) == "07:50-08:00 accompany to 1; 16:00-16:10 accompany to 0");
	CHECK(family.fixture.day_of(family.parent, 21) == "07:50-08:00 accompany to 1; 16:00-16:10 accompany to 0");
}

TEST_CASE("an entry for one day that runs past midnight cuts the next day too, and one may begin on the day before or after") {
	Family family;
	Task night = stay(20, 33, family.home);
	REQUIRE(family.insert(family.child, night, 6).is_inserted);
	CHECK(family.fixture.day_of(family.child, 6).ends_with("; 20:00-33:00 stay 0"));
	CHECK(family.fixture.day_of(family.child, 7) == "09:00-16:00 stay 1"); // it was not brought, so nobody fetches it
	CHECK(family.fixture.day_of(family.child, 0).starts_with("07:50"));
	REQUIRE(family.insert(family.child, stay(34, 35, family.home), 14).is_inserted);
	CHECK(family.fixture.day_of(family.child, 15) ==
			"07:50-08:00 accompany to 1; 08:00-10:00 stay 1; 10:00-11:00 stay 0; 11:00-16:00 stay 1; 16:00-16:10 accompany to 0");
	REQUIRE(family.insert(family.child, stay(-4, -3, family.home), 22).is_inserted);
	CHECK(family.fixture.day_of(family.child, 21).ends_with("; 20:00-21:00 stay 0"));
}

TEST_CASE("the week changes around what is for one day; what the newer entry of every week overlaps gives way there too") {
	Family family;
	REQUIRE(family.insert(family.child, stay(18, 20, family.school), 7).is_inserted);
	REQUIRE(family.insert(family.child, stay(19, 21, family.home)).is_inserted);
	CHECK(family.fixture.day_of(family.child, 7).ends_with("18:00-19:00 stay 1; 19:00-21:00 stay 0"));
	CHECK(family.fixture.day_of(family.child, 8).ends_with("16:10 accompany to 0; 19:00-21:00 stay 0"));
	const AgendaChange change = family.insert(family.child, stay(0, 24, family.home, monday));
	REQUIRE(change.dropped.size() == 1); // of every Monday: the one that was another is told with it
	CHECK(!change.dropped[0].day);
	CHECK(family.fixture.day_of(family.child, 7) == "00:00-24:00 stay 0");
	CHECK(family.fixture.day_of(family.parent, 7) == "07:50-08:00 accompany to 1");
	CHECK(family.fixture.agendas.agenda_of(family.child).single_days.empty()); // it is like the week now
}

namespace {

constexpr int tens_a_day = 144; // ten minutes each

// Who holds each ten minutes of some days: what was said, and what the agenda says.
class TensOfMinutes {
public:
	static constexpr int days = 22;

	void paint(int64_t day, int first, int length, int who) {
		for (int64_t i = day * tens_a_day + first; i < day * tens_a_day + first + length; ++i) {
			if (i >= 0 && i < int64_t(_owner.size())) {
				overlaps += _owner[size_t(i)] != -1;
				_owner[size_t(i)] = who;
			}
		}
	}
	bool operator==(const TensOfMinutes &other) const { return _owner == other._owner; }

	int overlaps = 0;

private:
	std::vector<int> _owner = std::vector<int>(size_t(days) * tens_a_day, -1);
};

bool is_on(DayMask days, int64_t day) { return (days >> (day + 7) % 7) & 1; }

void insert_at_random(Family &family, Random &random, int newest, TensOfMinutes &expected) {
	const int first = int(random.index(tens_a_day * 3)) - tens_a_day, length = 1 + int(random.index(tens_a_day));
	Task task;
	task.start_ms = first * 600'000;
	task.end_ms = task.start_ms + length * 600'000;
	task.target = uint32_t(newest);
	task.days = DayMask(1 + random.index(127));
	const bool is_single = random.chance(0.6);
	const int64_t single = int64_t(random.index(TensOfMinutes::days));
	REQUIRE(family.insert(family.child, task, is_single ? std::optional(single) : std::nullopt).is_inserted);
	for (int64_t day = -4; day < TensOfMinutes::days + 4; ++day) {
		if (is_single ? day == single : is_on(task.days, day)) {
			expected.paint(day, first, length, newest);
		}
	}
}

} // namespace

TEST_CASE("whatever is inserted for days and weeks, every minute belongs to the newest entry over it") {
	for (uint64_t seed = 1; seed <= 40; ++seed) {
		Random random(seed, 77);
		Family family;
		family.fixture.agendas.changed[index_of(family.child)] = {}; // an empty week
		TensOfMinutes expected, found;
		for (int newest = 0; newest < 25; ++newest) {
			insert_at_random(family, random, newest, expected);
		}
		const AgendaView agenda = family.fixture.agendas.agenda_of(family.child);
		for (int64_t day = -1; day < TensOfMinutes::days; ++day) {
			for (const Task &task : agenda.on(day)) {
				if (is_on(task.days, day)) {
					found.paint(day, task.start_ms / 600'000, (task.end_ms - task.start_ms) / 600'000, int(task.target));
				}
			}
		}
		CHECK(found.overlaps == 0);
		CHECK(found == expected);
	}
}

TEST_CASE("households that come later get agendas of their own behind the others") {
	Family family;
	AgendaFixture &fixture = family.fixture;
	const size_t groups = fixture.agendas.groups.size();
	Population more;
	more.households.push_back({ .home = family.home, .first_member = PersonId(0), .member_count = 2 });
	more.persons.push_back({ .household = HouseholdId(0), .age = 41.0f });
	more.persons.push_back({ .household = HouseholdId(0), .age = 7.0f });
	append_population(fixture.population, more);
	AgendaOptions options;
	options.first_household = HouseholdId(1);
	const StraightLinePaths paths(fixture.city);
	const AgendaSet later = generate_agendas(*fixture.program, fixture.city, paths, fixture.population, options, fixture.diagnostics);
	CHECK(later.person_count() == 2);
	append_agendas(fixture.agendas, later);
	CHECK(fixture.agendas.person_count() == 4);
	CHECK(fixture.day_of(PersonId(2)) == fixture.day_of(family.parent));
	CHECK(fixture.day_of(PersonId(3)) == fixture.day_of(family.child));
	CHECK(fixture.agendas.groups.size() == 2 * groups);
	CHECK(fixture.agendas.groups.back().leader == PersonId(2));
	const auto lines_of = [&](PersonId person) {
		std::vector<std::pair<std::string, uint32_t>> lines;
		for (const Task &task : fixture.agendas.tasks_of(person)) {
			const TaskOrigin &origin = fixture.agendas.origins.at(task.origin);
			lines.push_back({ origin.rule, origin.line });
		}
		return lines;
	};
	CHECK_FALSE(lines_of(PersonId(2)).empty());
	CHECK(lines_of(PersonId(2)) == lines_of(family.parent));
	CHECK(lines_of(PersonId(3)) == lines_of(family.child));
	const AgendaChange change = family.insert(PersonId(3), stay(0, 24, family.home, monday));
	REQUIRE(change.dropped.size() == 1);
	CHECK(change.dropped[0].person == PersonId(2));
	CHECK(fixture.agendas.names[change.dropped[0].name] == "bring");
}

TEST_CASE("what cannot be inserted changes nothing") {
	Family family;
	CHECK_FALSE(family.insert(PersonId(99), stay(1, 2, family.home)).is_inserted);
	CHECK_FALSE(family.insert(family.child, stay(2, 2, family.home)).is_inserted);
	CHECK_FALSE(family.insert(family.child, stay(2, 3, family.home, 0)).is_inserted);
	CHECK(family.insert(family.child, stay(0, 30, family.home)).changed.empty());
	CHECK_FALSE(family.insert(family.child, stay(3, 2, family.home), 5).is_inserted);
	CHECK(family.fixture.agendas.changed.empty());
}
