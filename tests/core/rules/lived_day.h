#pragma once

#include <string>

#include "tests/core/agenda/agenda_fixture.h"

namespace pcg {

// "00:00:00-08:00:00 inside 0; 08:00:00-08:01:40 walking to zone 0; 08:01:40-09:00:00 at object 1": what the person does from 0h to 24h of that day of the week,
// when the simulation begins there. A stretch in one state at one place is one, whatever entries it serves.
std::string lived_day(const AgendaFixture &fixture, PersonId id, int day);

} // namespace pcg
