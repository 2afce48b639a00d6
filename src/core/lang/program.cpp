#include "core/lang/program.h"

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
		if (rules[i].name == name && rules[i].params.size() == param_count && !rules[i].is_leaf_symbol) {
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
	std::string marked;
	const RuleInfo *second = nullptr;
	for (const RuleInfo &rule : program.rules) {
		if (rule.is_start) {
			marked += (marked.empty() ? "" : ", ") + rule.name;
			second = &rule;
		}
	}
	const std::string file = program.files.empty() ? std::string() : program.files[0];
	if (second == nullptr) {
		diagnostics.add({ Severity::Error, "no-start-rule", file, 0, 0, "no rule is marked @StartRule",
				"write @StartRule in front of the rule to begin with", {} });
	} else {
		diagnostics.add({ Severity::Error, "several-start-rules", program.files[second->place.file], second->place.line,
				second->place.column, "several rules are marked @StartRule: " + marked, "leave the mark at one of them", {} });
	}
	return RuleId::Invalid;
}

} // namespace pcg
