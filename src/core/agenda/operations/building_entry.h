#pragma once

#include "core/agenda/generation_context.h"

namespace pcg::agenda {

// What stayInside and goToBuilding share: (t0, t1, building). A building that is none is a warning, and nothing is inserted.
Flow insert_building_entry(Vm &vm, const Args &args, std::string_view operation, TaskKind kind);

} // namespace pcg::agenda
