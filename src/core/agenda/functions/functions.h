#pragma once

#include "core/agenda/context.h"
#include "core/lang/dialect.h"

// Rows of the dialect, by what they ask (PCG language, sections 3 and 4).
namespace pcg::agenda {

void add_variables(Dialect &dialect); // home gender age person.id household.id day time
void add_building_functions(Dialect &dialect); // getDistance getDistanceInTime findBuilding findNearestBuilding isValid
void add_object_functions(Dialect &dialect); // findObject
void add_member_functions(Dialect &dialect); // count chooseMember


} // namespace pcg::agenda
