#include <doctest/doctest.h>

#include "core/population/names.h"
#include "core/sim/saved_people.h"
#include "tests/core/sim/random_town.h"

using namespace pcg;
using namespace pcg::test;

namespace {

void fill(Town &town) {
	fill_at_random(town, 2);
	add_rules_at_random(town, 2);
	town.population.home_type = "flat";
	town.population.names = { "Zsófia" };
	town.population.persons[0].name = uint32_t(first_names(town.population.persons[0].gender).size());
	town.simulate();
	town.agendas.names = { "", "shopping" };
	town.agendas.requirements = { {}, { 1, true, 0 } };
	town.agendas.origins = { { "Rule", "day.pcg", 7 } };
	Task task;
	task.start_ms = at(9);
	task.end_ms = at(10);
	task.name = 1;
	task.days_later = 6;
	task.requirement = 1;
	town.agendas.changed[1] = { { task }, { { -3, { task } }, { 40, {} } } };
}

} // namespace

TEST_CASE("people and agendas come back as they were, with what was changed") {
	Town town;
	fill(town);
	const std::string bytes = people_to_bytes(town.population, town.agendas);
	SavedPeople people;
	REQUIRE(people_from_bytes(bytes, people));
	CHECK(people_to_bytes(people.population, people.agendas) == bytes);
	CHECK(people.population.home_type == "flat");
	CHECK(first_name(people.population, PersonId(0)) == "Zsófia");
	CHECK(people.population.persons.size() == town.population.persons.size());
	CHECK(people.population.persons[3].walking_speed == town.population.persons[3].walking_speed);
	CHECK(people.population.home_of(PersonId(4)) == town.population.home_of(PersonId(4)));
	CHECK(people.agendas.groups.size() == town.agendas.groups.size());
	CHECK(people.agendas.groups[0].joiners == town.agendas.groups[0].joiners);
	CHECK(people.agendas.origins[0].file == "day.pcg");
	CHECK(people.agendas.requirements == town.agendas.requirements);
	const std::span<const Task> tasks = people.agendas.tasks_of(PersonId(1));
	REQUIRE(tasks.size() == 1);
	CHECK(tasks[0].start_ms == at(9));
	CHECK(tasks[0].name == 1);
	CHECK(tasks[0].days_later == 6);
	CHECK(tasks[0].requirement == 1);
	CHECK(people.agendas.agenda_of(PersonId(1)).on(-3).size() == 1);
	CHECK(people.agendas.agenda_of(PersonId(1)).on(40).empty());
	CHECK(people.agendas.agenda_of(PersonId(1)).on(41).size() == 1);
}

TEST_CASE("people that contradict themselves are refused") {
	Town town;
	fill(town);
	const auto is_refused = [&](auto &&damage) {
		SavedPeople people{ town.population, town.agendas };
		damage(people.population, people.agendas);
		SavedPeople read;
		return !people_from_bytes(people_to_bytes(people.population, people.agendas), read);
	};
	CHECK(!is_refused([](Population &, AgendaSet &) {}));
	CHECK(is_refused([](Population &people, AgendaSet &) { people.persons[2].household = HouseholdId(99); }));
	CHECK(is_refused([](Population &people, AgendaSet &) { people.persons[2].walking_speed = 0.0f; }));
	CHECK(is_refused([](Population &people, AgendaSet &) { people.persons[2].name = 1'000'000; }));
	CHECK(is_refused([](Population &people, AgendaSet &) { people.names.clear(); }));
	CHECK(is_refused([](Population &people, AgendaSet &) { people.households[1].family_name = 1'000'000; }));
	CHECK(is_refused([](Population &people, AgendaSet &) { ++people.households[1].member_count; }));
	CHECK(is_refused([](Population &people, AgendaSet &) { people.persons.pop_back(); }));
	CHECK(is_refused([](Population &, AgendaSet &agendas) { agendas.first_task[1] = 99'999; }));
	CHECK(is_refused([](Population &, AgendaSet &agendas) { agendas.first_task.pop_back(); }));
	CHECK(is_refused([](Population &, AgendaSet &agendas) { agendas.tasks[0].end_ms = agendas.tasks[0].start_ms; }));
	CHECK(is_refused([](Population &, AgendaSet &agendas) { agendas.tasks[0].start_ms = -1; }));
	CHECK(is_refused([](Population &, AgendaSet &agendas) { agendas.tasks[0].name = 2; }));
	CHECK(is_refused([](Population &, AgendaSet &agendas) { agendas.groups[0].leader = PersonId::Invalid; }));
	CHECK(is_refused([](Population &, AgendaSet &agendas) { agendas.requirements[1].outer = 1; }));
	CHECK(is_refused([](Population &, AgendaSet &agendas) { agendas.requirements[1].name = 2; }));
	CHECK(is_refused([](Population &, AgendaSet &agendas) { agendas.changed[1].week.push_back({}); }));
	CHECK(is_refused([](Population &, AgendaSet &agendas) { agendas.changed[1].single_days[0].tasks.push_back({}); }));
	CHECK(is_refused([](Population &, AgendaSet &agendas) { agendas.changed[1].single_days[0].day = 40; }));
	SavedPeople read;
	const std::string bytes = people_to_bytes(town.population, town.agendas);
	CHECK(!people_from_bytes(bytes + '\0', read));
	CHECK(!people_from_bytes(bytes.substr(0, bytes.size() - 1), read));
}
