#pragma once

#include "core/base/random.h"
#include "tests/core/sim/town.h"

// Towns full of days that nobody thought up, for tests of what must always hold.
namespace pcg::test {

// Households of an adult and up to three children with days full of stays, walks and group walks, late ones among them.
inline void fill_at_random(Town &town, uint64_t seed) {
	Random random(seed);
	std::vector<BuildingId> buildings;
	for (int i = 0; i < 15; ++i) {
		buildings.push_back(town.building(i % 3 ? "house" : "school", float(random.uniform(0, 700)), float(random.uniform(0, 700))));
	}
	for (int i = 0; i < 12; ++i) {
		town.household(buildings[random.index(15)]);
		const PersonId adult = town.person(40.0f, float(random.uniform(0.9, 1.6)));
		std::vector<PersonId> children;
		for (size_t child = random.index(4); child > 0; --child) {
			children.push_back(town.person(8.0f, float(random.uniform(0.6, 1.2))));
		}
		std::vector<int32_t> times(children.size() + 1, at(5) + int32_t(random.index(7'200'000)));
		while (times[0] < at(20)) {
			for (size_t member = 0; member < times.size(); ++member) {
				const int32_t end = times[member] + 1000 + int32_t(random.index(random.chance(0.3) ? 300'000 : 5'000'000));
				const PersonId id = member == 0 ? adult : children[member - 1];
				random.chance(0.5) ? town.go(id, times[member], end, buildings[random.index(15)])
								   : town.stay(id, times[member], end, buildings[random.index(15)]);
				times[member] = end;
			}
			if (!children.empty() && random.chance(0.8)) { // all entries before it end, then the walk together
				const int32_t start = *std::max_element(times.begin(), times.end());
				const int32_t end = start + 1000 + int32_t(random.index(1'800'000));
				town.accompany(adult, children, start, end, buildings[random.index(15)]);
				std::fill(times.begin(), times.end(), end);
			}
		}
	}
}

// Rules of every kind that a delayed rule can be: waits, zones, seats, errands, draws, groups, parameters and text.
inline constexpr const char *random_rules =
		"Park --> wait(rand(0, 90)) goToZone(\"park\") set(bench, findObject(\"bench\", 60))"
		" case isValid(bench): goToObject(bench) interact(bench, \"sit\") waitUntilNextTask() else: wait(10m) Park"
		" Errand --> set(shop, findBuilding(\"school\")) goToBuilding(shop) stayInside(rand(2m, 20m)) goToBuilding(home)"
		" Stroll --> 40%: Round(3, \"park\") 30%: Errand else: wait(5m) Stroll"
		" Round(n, type) --> case n > 0: goToZone(type) [ set(n, n - 1) wait(n * 60) Errand ] Round(n - 1, type) else: wait(1)";

// Adds a park with benches, and entries of delayed rules, floating slots and floating tasks to some of the persons who are there. The rules are
// random_rules.
inline void add_rules_at_random(Town &town, uint64_t seed) {
	Random random(seed, 1);
	town.zone("park", 300.0f, 300.0f, 60.0f);
	town.zone("park", 100.0f, 600.0f, 40.0f);
	for (int i = 0; i < 6; ++i) {
		town.bench(305.0f + 9.0f * float(i), 320.0f, 1 + i % 2);
	}
	town.rules(random_rules);
	const char *names[] = { "Park", "Errand", "Stroll" };
	for (uint32_t i = 0; i < town.population.persons.size(); ++i) {
		Agenda agenda;
		for (Task task : town.tasks[i]) {
			agenda.insert(task);
		}
		for (size_t count = random.index(3); count > 0; --count) {
			Task task;
			task.start_ms = at(5) + int32_t(random.index(40'000'000));
			task.end_ms = task.start_ms + 60'000 + int32_t(random.index(9'000'000));
			task.kind = random.chance(0.7) ? TaskKind::DelayedRule : TaskKind::FloatingSlot;
			task.target = task.kind == TaskKind::DelayedRule ? index_of(town.rule(names[random.index(3)])) : 0xFFFFFFFF;
			agenda.insert(task);
		}
		town.tasks[i] = agenda.tasks();
		for (size_t count = random.index(3); count > 0; --count) {
			town.floating(PersonId(i), 300'000 + int32_t(random.index(3'000'000)), names[random.index(3)], float(random.index(2)));
		}
	}
}

} // namespace pcg::test
