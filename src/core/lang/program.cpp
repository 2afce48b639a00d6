#include "core/lang/program.h"

#include <algorithm>

namespace pcg {

namespace {

// Hosts of CityEngine's runtime write the style before a name: Default$Lot.
std::string_view without_default_style(std::string_view name) {
	constexpr std::string_view prefix = "Default$";
	return name.starts_with(prefix) ? name.substr(prefix.size()) : name;
}

} // namespace

RuleId Program::find_rule(std::string_view name, size_t param_count) const {
	name = without_default_style(name);
	for (size_t i = 0; i < rules.size(); ++i) {
		if (rules[i].name == name && rules[i].params.size() == param_count && !rules[i].is_leaf_symbol && !rules[i].is_replaced) {
			return RuleId(i);
		}
	}
	return RuleId::Invalid;
}

uint32_t Program::find_text(std::string_view text) const {
	for (size_t i = 0; i < texts.size(); ++i) {
		if (texts[i].view == text) {
			return uint32_t(i);
		}
	}
	return no_symbol;
}

int Program::find_attribute(std::string_view name) const {
	name = without_default_style(name);
	for (size_t i = 0; i < attributes.size(); ++i) {
		if (attributes[i].name == name) {
			return int(i);
		}
	}
	return -1;
}

RuleId require_start_rule(const Program &program, Diagnostics &diagnostics) {
	if (is_valid(program.start_rule)) {
		return program.start_rule;
	}
	Diagnostic missing{ Severity::Error, "no-start-rule", program.files.empty() ? std::string() : program.files[0], 0, 0, "no rule is marked @StartRule",
		"write @StartRule in front of the rule to begin with", {} };
	const auto first = std::ranges::find_if(program.rules, [](const RuleInfo &rule) { return rule.place.file == 0; });
	if (first != program.rules.end()) {
		missing.line = first->place.line;
		missing.column = first->place.column;
		missing.source = program.sources[0]->excerpt(missing.line, missing.column);
	}
	diagnostics.add(std::move(missing));
	return RuleId::Invalid;
}

} // namespace pcg
