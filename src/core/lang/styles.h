#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/lang/rule_set.h"

// Styles: sets of rules and attributes on top of each other (CGA reference: style).
namespace pcg {

// Default is always there; it may also be left empty.
bool has_style(const std::vector<AstStyle> &styles, std::string_view name);
// "its styles: Default, Night": for messages.
std::string style_names(const std::vector<AstStyle> &styles);
// An error if the file that the host asked for has no such style.
void require_style(const ParsedFile &file, std::string_view style, Diagnostics &diagnostics);
// The style, what it extends, and so on to Default. Tells of bases that do not exist or go round in a circle.
std::vector<std::string_view> style_chain(const ParsedFile &file, std::string_view style, Diagnostics &diagnostics);

} // namespace pcg
