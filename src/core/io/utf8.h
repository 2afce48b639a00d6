#pragma once

#include <string>

namespace pcg {

// Texts of rule files may hold any bytes, JSON only UTF-8: what is none is replaced.
std::string valid_utf8(const std::string &text);

} // namespace pcg
