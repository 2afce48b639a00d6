#pragma once

#include <string>

#include "core/base/diagnostic.h"

namespace pcg {

// Tells the user, once: errors as one engine error that counts them, warnings as one engine warning; each with the texts of all, places in
// the file kept. Nothing is said of empty diagnostics.
void report(const Diagnostics &diagnostics);

} // namespace pcg
