#pragma once

#include <string>

#include "core/lang/dialect.h"

namespace pcg {

// Tables of a dialect's operations, functions and variables in Markdown, from their declarations: the reference pages are made of these, so that
// they cannot say anything else than the code.
std::string to_markdown(const Dialect &dialect);

// "split(axis: x|y|z [, adjust]) { size: .. }"
std::string signature_text(const OperationSpec &spec);
std::string signature_text(const FunctionSpec &spec);
std::string signature_text(const AnnotationSpec &spec); // "@Order(number)"

} // namespace pcg
