#include "core/population/population.h"

#include "core/population/names.h"

namespace pcg {

void append_population(Population &population, const Population &more) {
	const auto first_household = uint32_t(population.households.size()), first_person = uint32_t(population.persons.size());
	const auto first_name = uint32_t(population.names.size());
	for (Household household : more.households) {
		household.first_member = PersonId(index_of(household.first_member) + first_person);
		household.family_name += household.family_name >= family_names().size() ? first_name : 0;
		population.households.push_back(household);
	}
	for (Person person : more.persons) {
		person.household = HouseholdId(index_of(person.household) + first_household);
		person.name += person.name >= first_names(person.gender).size() ? first_name : 0;
		population.persons.push_back(person);
	}
	population.names.insert(population.names.end(), more.names.begin(), more.names.end());
}

} // namespace pcg
