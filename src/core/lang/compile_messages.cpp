#include <algorithm>

#include "core/lang/compiler.h"

// The words of messages: where they belong, what was meant instead.
namespace pcg {

SourcePlace Compiler::place(uint32_t offset) const {
	const Source::Position at = _scope.source->position(offset);
	return { _scope.file, at.line, at.column };
}

void Compiler::report(Severity severity, std::string_view id, uint32_t offset, std::string message, std::string hint) {
	_diagnostics.add(_scope.source->diagnostic(severity, id, offset, std::move(message), std::move(hint)));
}

// --- The nearest name

// What may stand as a command. In strict dialects values, too: whoever is told of one writes it into an expression.
std::vector<std::string_view> Compiler::command_names() const {
	std::vector<std::string_view> names;
	for (const Definition &definition : _definitions) {
		if (definition.kind == Definition::Kind::Rule) {
			names.push_back(definition.name);
		}
	}
	for (const OperationSpec &spec : _dialect.operations) {
		names.push_back(spec.name);
	}
	return names;
}

std::vector<std::string_view> Compiler::value_names() const {
	std::vector<std::string_view> names = _scope.locals;
	for (const Definition &definition : _definitions) {
		if (definition.kind != Definition::Kind::Rule) {
			names.push_back(definition.name);
		}
	}
	for (const FunctionSpec &spec : _dialect.functions) {
		names.push_back(spec.name);
	}
	for (const VariableSpec &spec : _dialect.variables) {
		names.push_back(spec.name);
	}
	names.insert(names.end(), _program->slot_names.begin(), _program->slot_names.end());
	return names;
}

// Empty where nothing is close, and where the message will only be counted: to look for it takes as long as there are names.
std::string Compiler::did_you_mean(std::string_view name, bool wants_command) const {
	if (is_full()) {
		return {};
	}
	std::vector<std::string_view> names = wants_command ? command_names() : value_names();
	const size_t command_count = wants_command ? names.size() : 0;
	if (wants_command && is_strict()) { // a function was written where a command belongs: told beside its name
		const std::vector<std::string_view> values = value_names();
		names.insert(names.end(), values.begin(), values.end());
	}
	const std::string_view closest = closest_name(name, names);
	if (closest.empty() || closest == name) { // the same name in another file that takes part
		return {};
	}
	const std::string question = "did you mean `" + std::string(closest) + "`?";
	const auto commands_end = names.begin() + ptrdiff_t(command_count);
	const bool is_value = wants_command && std::find(names.begin(), commands_end, closest) == commands_end;
	return is_value ? question + " It gives a value: use it inside of an expression" : question;
}

void Compiler::unknown(std::string_view what, std::string_view unknown_name, uint32_t offset, bool wants_command) {
	if (!_set.is_excused(_scope.space, unknown_name)) {
		complain("unknown-name", offset, "unknown " + std::string(what) + " `" + std::string(unknown_name) + "`",
				did_you_mean(unknown_name, wants_command));
	}
}

// --- What arguments are missing

namespace {

std::string signature(std::string_view name, const std::vector<ParamSpec> &params) {
	std::string text = std::string(name) + "(";
	for (size_t i = 0; i < params.size(); ++i) {
		const bool is_optional = params[i].is_optional || params[i].is_repeated;
		text += (is_optional ? " [" : "") + std::string(i > 0 ? ", " : "") + std::string(params[i].name) +
				(params[i].is_repeated ? ".." : "") + (is_optional ? "]" : "");
	}
	return text + ")";
}

} // namespace

// "Day(start), or Day(start, end)"
std::string Compiler::forms_of(std::string_view name) const {
	std::string forms;
	if (is_full()) {
		return forms;
	}
	const auto add = [&](const std::string &form) { forms += (forms.empty() ? "" : ", or ") + form; };
	for (const FunctionSpec &spec : _dialect.functions) {
		if (spec.name == name) {
			add(signature(name, spec.params));
		}
	}
	for (const OperationSpec &spec : _dialect.operations) {
		if (spec.name == name) {
			add(signature(name, spec.params));
		}
	}
	for (const Definition &definition : _definitions) {
		if (definition.name == name) {
			std::string params;
			for (const AstParam &param : definition.item->params) {
				params += (params.empty() ? "" : ", ") + std::string(param.name);
			}
			add(std::string(name) + "(" + params + ")");
		}
	}
	return forms;
}

void Compiler::wrong_count(std::string_view name, NodeRange list, uint32_t offset) {
	if (is_broken(list)) {
		return;
	}
	const std::string forms = forms_of(name);
	complain("wrong-argument-count", offset,
			"`" + std::string(name) + "` does not take " + std::to_string(list.count) + (list.count == 1 ? " argument" : " arguments"),
			forms.empty() ? std::string() : "it is " + forms);
}

} // namespace pcg
