#pragma once

#include <string>
#include <vector>

#include "cli/args.h"
#include "core/lang/attribute_override.h"

namespace pcg::cli {

// What --attr NAME=VALUE says; what the value means depends on the rules.
struct AttributeText {
	std::string name, value;
};

// Notes a problem for each --attr that is none.
std::vector<AttributeText> read_attributes(Args &args);
std::vector<AttributeOverride> attributes_of(const Program &program, const std::vector<AttributeText> &texts);

} // namespace pcg::cli
