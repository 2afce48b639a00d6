#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "core/base/diagnostic.h"
#include "core/lang/program.h"

// Values that a host gives to an `attr` or a plain name of a rule set: from the editor, the command line, a game.
namespace pcg {

class Vm;

using AttributeValue = std::variant<double, bool, std::string>;

struct AttributeOverride {
	std::string name;
	AttributeValue value;
};

// What a text, such as a command line's, means to the attribute: 5 may be a number or a text, 8h30m is 30600 where the language has units of time.
AttributeValue attribute_value(const Program &program, std::string_view name, std::string_view text);

// An error if the rules cannot take it: they have no such attribute (with the closest that they have), it is const, of another
// type, or a number that is not finite.
std::optional<Diagnostic> attribute_problem(const Program &program, const AttributeOverride &attribute);

// Holds for all runs. False, and nothing changes, if there is a problem.
bool override_attribute(Vm &vm, const AttributeOverride &attribute);

} // namespace pcg
