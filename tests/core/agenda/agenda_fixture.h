#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/agenda/agenda_generator.h"
#include "core/agenda/dialect.h"
#include "core/io/rule_loader.h"
#include "core/navigation/straight_line_paths.h"
#include "core/population/population.h"
#include "core/semantics/city_model.h"
#include "core/sim/dialect.h"

// A small city on a line and one or more households, for tests of rules.
namespace pcg {

class AgendaFixture {
public:
	CityModel city;
	Population population;
	AgendaOptions options;
	Diagnostics diagnostics;
	std::shared_ptr<const Program> program;
	AgendaSet agendas;

	// A building with an entrance of this type `x` metres east of the origin.
	BuildingId add_building(std::string_view type, float x, uint32_t capacity = 0) {
		Entrance entrance;
		entrance.building = city.add_building();
		entrance.type = city.types.add(type);
		entrance.position = { x, 0.0f, 0.0f };
		entrance.capacity = capacity;
		city.add_entrance(entrance);
		return entrance.building;
	}
	HouseholdId add_household(BuildingId home) {
		Household household;
		household.home = home;
		household.first_member = PersonId(uint32_t(population.persons.size()));
		population.households.push_back(household);
		return HouseholdId(uint32_t(population.households.size() - 1));
	}
	// Of the newest household.
	PersonId add_person(float age, Gender gender = Gender::Woman, float speed = 1.0f) {
		Person person;
		person.household = HouseholdId(uint32_t(population.households.size() - 1));
		person.age = age;
		person.gender = gender;
		person.walking_speed = speed;
		population.persons.push_back(person);
		++population.households.back().member_count;
		return PersonId(uint32_t(population.persons.size() - 1));
	}

	// False if the rules did not compile.
	bool generate(const std::string &rules, const std::string &path = "test.pcg") {
		MemorySourceProvider provider;
		provider.add(path, rules);
		return use(load_program(path, pcg_dialect(), provider, diagnostics));
	}
	bool generate_file(const std::string &path) { return use(load_program(path, pcg_dialect(), diagnostics)); }

	bool use(std::shared_ptr<const Program> loaded) {
		program = std::move(loaded);
		if (!program) {
			return false;
		}
		const StraightLinePaths paths(city);
		agendas = generate_agendas(*program, city, paths, population, options, diagnostics);
		return true;
	}

	// "00:00-08:00 stay 0; .." of one person on one day, by start; tasks that began the day before are not listed.
	std::string day_of(PersonId id, int day = 0) const;
	// "07:30 0 leads 2 3; ..": walks together that begin on that day, or what is left of them, with those who come along then.
	std::string walks_of(PersonId id, int day) const;
	// Ids of the diagnostics, with spaces between them.
	std::string problems() const;
};

} // namespace pcg
