#pragma once

#include "core/lang/program.h"

namespace pcg {

// A message at the instruction before this address, with its line of source: Vm::address() of the running one.
Diagnostic diagnostic_at(const Program &program, uint32_t address, Severity severity, std::string_view id, std::string message, std::string hint);

} // namespace pcg
