#include "core/lang/attribute_override.h"

#include <charconv>
#include <cmath>
#include <vector>

#include "core/lang/lexer.h"
#include "core/lang/vm.h"

namespace pcg {

namespace {

Value value_of(const AttributeValue &value, Text &holder) {
	if (const double *number = std::get_if<double>(&value)) {
		return Value::of(*number);
	}
	if (const bool *truth = std::get_if<bool>(&value)) {
		return Value::of(*truth);
	}
	holder.view = std::get<std::string>(value);
	return Value::of(&holder);
}

std::optional<double> number_in(std::string_view text) {
	double number = 0.0;
	const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
	return error == std::errc() && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

// "8h30m", "-5m": as the language writes it.
std::optional<double> time_in(std::string_view text) {
	Diagnostics diagnostics;
	const Source source("value", std::string(text));
	const TokenList list = tokenize(source, true, diagnostics);
	const bool is_negative = !list.tokens.empty() && list.tokens.front().kind == TokenKind::Minus;
	const size_t at = is_negative ? 1 : 0;
	if (list.tokens.size() != at + 2 || list.tokens[at].kind != TokenKind::Number || !diagnostics.is_empty()) {
		return std::nullopt;
	}
	return is_negative ? -list.tokens[at].number : list.tokens[at].number;
}

Diagnostic unknown_attribute(const Program &program, const std::string &name) {
	std::vector<std::string_view> names;
	for (const AttributeInfo &info : program.attributes) {
		if (info.kind != AttributeInfo::Kind::Constant) {
			names.push_back(info.name);
		}
	}
	const std::string_view closest = closest_name(name, names);
	Diagnostic problem;
	problem.id = "unknown-attribute";
	problem.message = "'" + name + "' is no attribute of the rules";
	problem.hint = closest.empty() ? "attributes are declared with attr" : "did you mean '" + std::string(closest) + "'?";
	return problem;
}

} // namespace

AttributeValue attribute_value(const Program &program, std::string_view name, std::string_view text) {
	const int index = program.find_attribute(name);
	const ValueType type = index >= 0 ? program.attributes[size_t(index)].type : ValueType::Void;
	if (type == ValueType::Text) {
		return std::string(text);
	}
	if (text == "true" || text == "false") {
		return text == "true";
	}
	std::optional<double> number = number_in(text);
	if (!number && program.dialect != nullptr && program.dialect->has_time_units) {
		number = time_in(text);
	}
	return number ? AttributeValue(*number) : AttributeValue(std::string(text));
}

std::optional<Diagnostic> attribute_problem(const Program &program, const AttributeOverride &attribute) {
	const int index = program.find_attribute(attribute.name);
	if (index < 0) {
		return unknown_attribute(program, attribute.name);
	}
	const AttributeInfo &info = program.attributes[size_t(index)];
	Text holder;
	const ValueType given = value_of(attribute.value, holder).type;
	Diagnostic problem;
	if (info.kind == AttributeInfo::Kind::Constant) {
		problem.id = "const-attribute";
		problem.message = "'" + attribute.name + "' is const in the rules and cannot be set from outside";
		problem.hint = "declare it with attr";
		return problem;
	}
	if (info.type != ValueType::Void && info.type != given) {
		problem.id = "attribute-type";
		problem.message = "'" + attribute.name + "' is " + std::string(type_name(info.type)) + " in the rules, not " + std::string(type_name(given));
		problem.hint = "give it a value of that type";
		return problem;
	}
	if (const double *number = std::get_if<double>(&attribute.value); number != nullptr && !std::isfinite(*number)) {
		problem.id = "attribute-not-finite";
		problem.message = "'" + attribute.name + "' is given " + value_text(Value::of(*number)) + ", which rules cannot reckon with";
		problem.hint = "give it a number that is finite";
		return problem;
	}
	return std::nullopt;
}

bool override_attribute(Vm &vm, const AttributeOverride &attribute) {
	Text holder;
	return vm.override_attribute(attribute.name, value_of(attribute.value, holder));
}

} // namespace pcg
