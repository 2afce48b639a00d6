#pragma once

#include <sstream>

#include "core/cga/derivation.h"

// What `// expect` lines say of reports, and how near their numbers have to be. The format is in tests/rules/cga/README.md.
namespace pcg {

bool is_near(double a, double b);
bool is_near(glm::dvec3 a, glm::dvec3 b);
double read_number(std::istringstream &line); // NaN: there is none

// "height sum 12 count 3": there is such a report. A name of several words stands in quotation marks.
bool has_report(const cga::DerivationResult &model, std::istringstream &line);

} // namespace pcg
