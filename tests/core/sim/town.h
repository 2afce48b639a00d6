#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "core/agenda/agenda_edit.h"
#include "core/io/rule_loader.h"
#include "core/navigation/straight_line_paths.h"
#include "core/sim/dialect.h"
#include "core/sim/simulation.h"

// A small town for tests of the simulation: straight lines, agendas written by hand, and a recorder of what happened.
namespace pcg::test {

constexpr int32_t at(int hours, int minutes = 0, int seconds = 0) {
	return ((hours * 60 + minutes) * 60 + seconds) * 1000;
}

constexpr SimTime moment(int day, int hours, int minutes = 0, int seconds = 0) {
	return SimTime::at(day, Duration{ at(hours, minutes, seconds) });
}

struct Town {
	CityModel city;
	StraightLinePaths paths{ city };
	const PathProvider *ground = &paths;
	Population population;
	std::vector<std::vector<Task>> tasks;
	std::vector<std::vector<FloatingTask>> floating_tasks;
	std::vector<Group> groups;
	AgendaSet agendas;
	std::shared_ptr<const Program> program;
	AgentHost host;

	BuildingId building(std::string_view type, float x, float z = 0.0f) {
		const BuildingId id = city.add_building();
		Entrance entrance;
		entrance.building = id;
		entrance.type = city.types.add(type);
		entrance.position = { x, 0.0f, z };
		city.add_entrance(entrance);
		return id;
	}

	HouseholdId household(BuildingId home) {
		Household result;
		result.home = home;
		result.first_member = PersonId(uint32_t(population.persons.size()));
		population.households.push_back(result);
		return HouseholdId(uint32_t(population.households.size() - 1));
	}

	// Of the household that was added last.
	PersonId person(float age = 30.0f, float speed = 1.0f) {
		Person result;
		result.household = HouseholdId(uint32_t(population.households.size() - 1));
		result.age = age;
		result.walking_speed = speed;
		population.persons.push_back(result);
		++population.households.back().member_count;
		tasks.emplace_back();
		floating_tasks.emplace_back();
		return PersonId(uint32_t(population.persons.size() - 1));
	}

	static Task entry(TaskKind kind, int32_t start, int32_t end, uint32_t target, DayMask days = all_days) {
		Task result;
		result.kind = kind;
		result.start_ms = start;
		result.end_ms = end;
		result.target = target;
		result.days = days;
		return result;
	}
	void task(PersonId id, TaskKind kind, int32_t start, int32_t end, uint32_t target, DayMask days = all_days) {
		tasks[index_of(id)].push_back(entry(kind, start, end, target, days));
	}
	void stay(PersonId id, int32_t start, int32_t end, BuildingId building, DayMask days = all_days) {
		task(id, TaskKind::StayInside, start, end, index_of(building), days);
	}
	void go(PersonId id, int32_t start, int32_t end, BuildingId building, DayMask days = all_days) {
		task(id, TaskKind::GoToBuilding, start, end, index_of(building), days);
	}
	// Adds the group's entry to everybody in it.
	void accompany(PersonId leader, std::vector<PersonId> joiners, int32_t start, int32_t end, BuildingId goal) {
		const uint32_t group = uint32_t(groups.size());
		groups.push_back({ leader, joiners, goal, start, end, all_days });
		task(leader, TaskKind::Accompany, start, end, group);
		for (PersonId joiner : joiners) {
			task(joiner, TaskKind::Accompany, start, end, group);
		}
	}

	ZoneId zone(std::string_view type, float x, float z, float size) {
		Zone result;
		result.type = city.types.add(type);
		result.polygon = { { x, 0.0f, z }, { x, 0.0f, z + size }, { x + size, 0.0f, z + size }, { x + size, 0.0f, z } };
		return city.add_zone(result);
	}
	ObjectId bench(float x, float z, int seats = 1) {
		CityObject result;
		result.type = city.types.add("bench");
		result.position = { x, 0.0f, z };
		for (int i = 0; i < seats; ++i) {
			result.places.push_back({ { x + float(i), 0.0f, z }, { 0.0f, 0.0f, 1.0f } });
		}
		return city.add_object(result);
	}
	// The rules that delayed tasks and floating tasks name.
	void rules(std::string text) {
		MemorySourceProvider provider;
		provider.add("day.pcg", "@StartRule Household --> " + text);
		Diagnostics diagnostics;
		program = load_program("day.pcg", pcg_dialect(), provider, diagnostics);
		INFO(to_text(diagnostics));
		REQUIRE(program != nullptr);
	}
	RuleId rule(std::string_view name) const { return program->find_rule(name); }
	void delayed(PersonId id, int32_t start, int32_t end, std::string_view name) {
		task(id, TaskKind::DelayedRule, start, end, index_of(rule(name)));
	}
	void floating(PersonId id, int32_t duration, std::string_view name, float priority = 0.0f) {
		floating_tasks[index_of(id)].push_back({ rule(name), duration, priority, all_days });
	}

	// Of all persons and tasks.
	void write_agendas() {
		agendas = {};
		for (size_t i = 0; i < tasks.size(); ++i) {
			agendas.first_task.push_back(uint32_t(agendas.tasks.size()));
			agendas.tasks.insert(agendas.tasks.end(), tasks[i].begin(), tasks[i].end());
			agendas.first_floating_task.push_back(uint32_t(agendas.floating_tasks.size()));
			const std::vector<FloatingTask> &pool = floating_tasks[i];
			agendas.floating_tasks.insert(agendas.floating_tasks.end(), pool.begin(), pool.end());
		}
		agendas.first_task.push_back(uint32_t(agendas.tasks.size()));
		agendas.first_floating_task.push_back(uint32_t(agendas.floating_tasks.size()));
		agendas.groups = groups;
	}

	// After all persons and tasks.
	Simulation &simulate(SimulationSettings settings = {}) {
		write_agendas();
		_simulation =
				std::make_unique<Simulation>(city, *ground, population, agendas, program, settings, host);
		return *_simulation;
	}

	// As a game does while it runs.
	bool insert(PersonId id, const Task &task, std::optional<int64_t> day = std::nullopt) {
		const AgendaChange change = insert_task(agendas, population, id, task, day);
		for (PersonId changed : change.changed) {
			_simulation->take_in_agenda(changed);
		}
		return change.is_inserted;
	}

private:
	std::unique_ptr<Simulation> _simulation;
};

// One line an event: "07:52:10 1 entered-building building 1".
class Recorder : public SimulationObserver {
public:
	std::vector<std::string> lines;

	void on_event(const SimEvent &event) override { lines.push_back(text_of(event)); }
	bool has(const std::string &line) const { return std::count(lines.begin(), lines.end(), line) > 0; }
	// Of one person, without the entries' beginnings.
	std::vector<std::string> of(PersonId id) const {
		std::vector<std::string> result;
		const std::string mark = " " + std::to_string(index_of(id)) + " ";
		for (const std::string &line : lines) {
			const size_t space = line.find(' ');
			if (line.compare(space, mark.size(), mark) == 0 && line.find(" task-started") == std::string::npos) {
				result.push_back(line);
			}
		}
		return result;
	}

	static std::string text_of(const SimEvent &event) {
		static const char *kinds[] = { "", " building ", " zone ", " object ", " person " };
		std::string line = clock_text(event.time.time_of_day(), true) + " " + std::to_string(index_of(event.person)) + " " +
				std::string(event_name(event.kind));
		if (!event.place.is_none()) {
			line += kinds[size_t(event.place.kind)] + std::to_string(event.place.index);
		}
		return line;
	}
};

using Lines = std::vector<std::string>;

} // namespace pcg::test
