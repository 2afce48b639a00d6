#pragma once

#include "core/lang/dialect.h"

// One function for each operation: its row of the dialect, handler included (PCG language, section 5).
namespace pcg::agenda {

void add_members(Dialect &dialect);
void add_days(Dialect &dialect);
void add_task_names(Dialect &dialect); // task requires after
void add_stay_inside(Dialect &dialect);
void add_go_to_building(Dialect &dialect);
void add_accompany(Dialect &dialect);
void add_delayed_rule(Dialect &dialect);
void add_floating_slot(Dialect &dialect);
void add_floating_task(Dialect &dialect);

} // namespace pcg::agenda
