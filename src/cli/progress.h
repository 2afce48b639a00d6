#pragma once

#include <string>

#include "core/base/parallel.h"

// Long work at the command line: how far it is, and Ctrl-C.
namespace pcg::cli {

// Work that tells on standard error how far it is once it has taken two seconds, as in "agendas: 40 %", and that Ctrl-C cancels: nothing is
// written then. The first call takes over Ctrl-C for the rest of the program.
WorkOptions long_work(std::string what, unsigned threads = 1);

// Whether Ctrl-C was pressed.
bool was_cancelled();

// What to call once after work that told how far it is: ends its line.
void end_progress();

} // namespace pcg::cli
