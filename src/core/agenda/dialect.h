#pragma once

#include "core/lang/dialect.h"

// The built-ins of agenda rules (PCG language, sections 3, 4, 5 and 7): variables, functions and the operations that write agendas.
namespace pcg::agenda {

// Ready to compile rule sets that only write agendas. The simulation appends its operations to a copy.
Dialect make_dialect();

} // namespace pcg::agenda
