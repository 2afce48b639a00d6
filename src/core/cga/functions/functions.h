#pragma once

#include <string_view>

#include "core/lang/dialect.h"

// One function for each family of functions: adds its rows to the dialect's table (CGA reference, sections 8.1 and 8.2).
namespace pcg::cga {

void add_text_functions(Dialect &dialect); // str float len substring ..
void add_list_functions(Dialect &dialect); // listItem listSize .. of "a;b;c;"
void add_color_functions(Dialect &dialect); // colorHexToR colorRamp ..
void add_array_functions(Dialect &dialect); // size findFirst setElems ..
void add_flow_functions(Dialect &dialect); // print report isNull getTreeKey
void extend_math_functions(Dialect &dialect); // after those of all dialects and the rows above

// The text of an argument; empty if it is none.
std::string_view text_at(const Args &args, size_t i);
// What a text begins with; not a number if that is none.
double number_of(std::string_view text);

} // namespace pcg::cga
