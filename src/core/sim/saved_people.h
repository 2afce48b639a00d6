#pragma once

#include <string>
#include <string_view>

#include "core/agenda/agenda.h"
#include "core/population/population.h"

// Who lives and what they have to do, as bytes: persons that came later and agendas that were changed are part of what a game saves.
namespace pcg {

struct SavedPeople {
	Population population;
	AgendaSet agendas;
};

std::string people_to_bytes(const Population &population, const AgendaSet &agendas);
// False: the bytes are no people, or contradict themselves. Buildings, rules and the like are numbers of a city and a program that are not looked
// at here.
bool people_from_bytes(std::string_view bytes, SavedPeople &people);

} // namespace pcg
