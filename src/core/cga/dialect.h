#pragma once

#include "core/lang/dialect.h"

namespace pcg::cga {

// Operations, functions, variables and selectors of the shape grammar. Built once, shared by all programs and threads.
const Dialect &cga_dialect();

} // namespace pcg::cga
