#pragma once

#include "core/lang/dialect.h"

// The built-ins of PCG rule files, both phases: what writes agendas (agenda/dialect.h) and what delayed rules do while the simulation runs
// (PCG language, section 6).
namespace pcg {

// Immutable; made at the first call.
const Dialect &pcg_dialect();

} // namespace pcg
