#include "core/lang/reference.h"

#include <algorithm>

namespace pcg {

namespace {

std::string params_text(const std::vector<ParamSpec> &params) {
	std::string text;
	for (size_t i = 0; i < params.size(); ++i) {
		const ParamSpec &param = params[i];
		const bool is_optional = param.is_optional || param.is_repeated;
		text += is_optional ? (i > 0 ? " [, " : "[") : (i > 0 ? ", " : "");
		text += param.name;
		if (!param.words.empty()) {
			std::string words(param.words);
			std::replace(words.begin(), words.end(), ' ', '|');
			text += ": " + words;
		}
		text += param.is_repeated ? " ..]" : (is_optional ? "]" : "");
	}
	return text;
}

std::string_view block_text(BlockKind kind) {
	switch (kind) {
		case BlockKind::None:
			return "";
		case BlockKind::Predicates:
			return " { condition: commands \\| .. }";
		case BlockKind::Sizes:
			return " { size: commands \\| .. }";
		case BlockKind::Selectors:
			return " { selector: commands \\| .. }";
		case BlockKind::Bodies:
			return " { commands }";
	}
	return "";
}

std::string_view phase_text(Phase phase) {
	switch (phase) {
		case Phase::Generation:
			return "generation";
		case Phase::Simulation:
			return "simulation";
		case Phase::Both:
			return "both";
	}
	return "";
}

// A bar would end the cell.
std::string cell(std::string_view text) {
	std::string escaped;
	for (char c : text) {
		escaped += c == '|' ? "\\|" : (c == '\n' ? " " : std::string(1, c));
	}
	return escaped;
}

template <typename Spec> std::vector<const Spec *> sorted_by_name(const std::vector<Spec> &specs) {
	std::vector<const Spec *> sorted;
	for (const Spec &spec : specs) {
		sorted.push_back(&spec);
	}
	std::stable_sort(sorted.begin(), sorted.end(), [](const Spec *a, const Spec *b) { return a->name < b->name; });
	return sorted;
}

} // namespace

std::string signature_text(const OperationSpec &spec) {
	const std::string params = params_text(spec.params);
	return std::string(spec.name) + (params.empty() && spec.block != BlockKind::None ? "" : "(" + params + ")");
}

std::string signature_text(const FunctionSpec &spec) { return std::string(spec.name) + "(" + params_text(spec.params) + ")"; }

std::string signature_text(const AnnotationSpec &spec) { return "@" + std::string(spec.name) + std::string(spec.arguments); }

std::string to_markdown(const Dialect &dialect) {
	const bool has_phases = std::any_of(dialect.operations.begin(), dialect.operations.end(),
			[&](const OperationSpec &spec) { return spec.phase != dialect.operations[0].phase; });
	std::string text = "# " + std::string(dialect.title) + "\n\n## Operations\n\n";
	text += has_phases ? "| operation | when | meaning |\n| --- | --- | --- |\n" : "| operation | meaning |\n| --- | --- |\n";
	for (const OperationSpec *spec : sorted_by_name(dialect.operations)) {
		text += "| `" + cell(signature_text(*spec)) + std::string(block_text(spec->block)) + "` | " +
				(has_phases ? std::string(phase_text(spec->phase)) + " | " : "") + cell(spec->help) + " |\n";
	}
	text += "\n## Functions\n\n| function | gives | meaning |\n| --- | --- | --- |\n";
	for (const FunctionSpec *spec : sorted_by_name(dialect.functions)) {
		text += "| `" + cell(signature_text(*spec)) + "` | " + std::string(spec->result == ValueType::Void ? "a value" : type_name(spec->result)) + " | " +
				cell(spec->help) + " |\n";
	}
	text += "\n## Variables\n\n| variable | is | meaning |\n| --- | --- | --- |\n";
	for (const VariableSpec *spec : sorted_by_name(dialect.variables)) {
		text += "| `" + std::string(spec->name) + "` | " + std::string(type_name(spec->type)) + (spec->is_writable ? ", writable" : "") + " | " +
				cell(spec->help) + " |\n";
	}
	return text;
}

} // namespace pcg
