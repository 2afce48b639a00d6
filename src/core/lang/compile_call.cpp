#include <algorithm>
#include <cmath>

#include "core/lang/compiler.h"
#include "core/lang/opcode.h"
#include "core/lang/vm.h"

// Calls of functions, and the arguments of everything built in.
namespace pcg {

// --- Overloads

bool Compiler::words_fit(const std::vector<ParamSpec> &params, NodeRange list) const {
	const auto arguments = _scope.ast->list(list);
	for (size_t i = 0; i < arguments.size(); ++i) {
		const ParamSpec &param = params[std::min(i, params.size() - 1)];
		const Expr &expr = _scope.ast->exprs[arguments[i]];
		const bool is_word = expr.kind == ExprKind::Name && (" " + std::string(param.words) + " ").find(" " + std::string(expr.name) + " ") !=
				std::string::npos;
		if (param.kind == ParamKind::Word && !is_word) {
			return false;
		}
	}
	return true;
}

// Among the specs that take so many arguments, the first whose words fit; else the first. -1: none takes so many.
template <typename Spec> int Compiler::choose(const std::vector<Spec> &specs, std::string_view name, NodeRange list) const {
	int first = -1;
	for (size_t i = 0; i < specs.size(); ++i) {
		if (specs[i].name != name) {
			continue;
		}
		size_t required = 0;
		bool is_open = false;
		for (const ParamSpec &param : specs[i].params) {
			required += param.is_optional || param.is_repeated ? 0 : 1;
			is_open |= param.is_repeated;
		}
		if (list.count < required || (list.count > specs[i].params.size() && !is_open)) {
			continue;
		}
		if (words_fit(specs[i].params, list)) {
			return int(i);
		}
		first = first < 0 ? int(i) : first;
	}
	return first;
}

int Compiler::choose_function(std::string_view name, NodeRange list) const { return choose(_dialect.functions, name, list); }
int Compiler::choose_operation(std::string_view name, NodeRange list) const { return choose(_dialect.operations, name, list); }

bool Compiler::is_broken(NodeRange list) const {
	const auto values = _scope.ast->list(list);
	return std::any_of(values.begin(), values.end(), [&](uint32_t id) { return _scope.ast->exprs[id].kind == ExprKind::Error; });
}

// --- Arguments

uint32_t Compiler::arguments(const std::vector<ParamSpec> &params, std::string_view name, NodeRange list) {
	uint32_t mask = 0;
	const auto values = _scope.ast->list(list);
	std::vector<Value> constants(values.size()); // calls within the arguments have their own
	_constant_arguments.clear();
	if (is_broken(list)) { // which form was meant is not known; the mistake in the list has been told
		for (uint32_t id : values) {
			emit_constant(Value(), _scope.ast->exprs[id].offset);
		}
		return mask;
	}
	for (size_t i = 0; i < values.size(); ++i) {
		const ParamSpec &param = params[std::min(i, params.size() - 1)];
		const uint32_t begin = here();
		const bool needs_check = argument(param, name, i, values[i]);
		ends_in_constant(begin, constants[i]);
		if (needs_check) {
			mask |= 1u << std::min<size_t>(i, last_check_bit) | (param.kind == ParamKind::Number ? 0 : check_mask_others);
		}
	}
	_constant_arguments = std::move(constants);
	return mask;
}

bool Compiler::argument(const ParamSpec &param, std::string_view name, size_t position, uint32_t id) {
	const Expr &expr = _scope.ast->exprs[id];
	switch (param.kind) {
		case ParamKind::Any:
			size_expression(id);
			return false;
		case ParamKind::Number:
		case ParamKind::Size:
		case ParamKind::Bool:
		case ParamKind::Text:
		case ParamKind::Array:
			return value_argument(param, name, position, id);
		case ParamKind::Word:
			if (!word_argument(param, expr) && !selector_argument(expr, OpCode::FindWord, param.words) && !text_as_word(param, id)) {
				complain("unknown-word", expr.offset, "argument " + std::to_string(position + 1) + " of `" + std::string(name) + "` is one of: " +
								std::string(param.words));
				emit_constant(Value::of_index(ValueType::Word, 0), expr.offset);
			}
			return false;
		case ParamKind::WordOrNumber:
			return !word_argument(param, expr) && !selector_argument(expr, OpCode::FindWord, param.words) && !text_as_word(param, id) &&
					size_expression(id) != ValueType::Number;
		case ParamKind::Predicate:
			emit_constant(Value::of_index(ValueType::Chunk, uint32_t(value_chunk(id, false))), expr.offset);
			return false;
		case ParamKind::Rule:
			rule_argument(expr);
			return false;
		case ParamKind::Target:
			target_argument(expr);
			return false;
	}
	return false;
}

// A number, text or truth: what is certainly something else is told now, what is unknown is looked at while running.
bool Compiler::value_argument(const ParamSpec &param, std::string_view name, size_t position, uint32_t id) {
	const Known known = param.kind == ParamKind::Size ? size_expression(id) : expression(id);
	const ValueType wanted = param.kind == ParamKind::Bool ? ValueType::Bool
			: param.kind == ParamKind::Array			   ? ValueType::Array
			: param.kind == ParamKind::Text				   ? ValueType::Text
														   : ValueType::Number;
	if (known != ValueType::Void && known != wanted) {
		complain("type-mismatch", _scope.ast->exprs[id].offset, "argument " + std::to_string(position + 1) + " of `" + std::string(name) + "` (" +
						std::string(param.name) + ") must be " + std::string(type_name(wanted)) + ", this is " + std::string(type_name(known)));
	}
	return known != wanted;
}

bool Compiler::word_argument(const ParamSpec &param, const Expr &expr) {
	if (expr.kind != ExprKind::Name) {
		return false;
	}
	uint32_t position = 0;
	for (size_t start = 0; start < param.words.size(); ++position) {
		const size_t end = std::min(param.words.find(' ', start), param.words.size());
		if (param.words.substr(start, end - start) == expr.name) {
			emit_constant(Value::of_index(ValueType::Word, position), expr.offset);
			return true;
		}
		start = end + 1;
	}
	return false;
}

void Compiler::rule_argument(const Expr &expr) {
	uint32_t rule = 0;
	const uint32_t found = expr.kind == ExprKind::Name ? _set.find_rule(_scope.space, expr.name, 0) : no_node;
	if (expr.kind != ExprKind::Name) {
		complain("not-a-rule", expr.offset, "the name of a rule belongs here");
	} else if (found == no_node && _set.has_rule(_scope.space, expr.name)) {
		complain("wrong-argument-count", expr.offset, "`" + std::string(expr.name) + "` has parameters; a rule that runs later has none");
	} else if (found == no_node) {
		unknown("rule", expr.name, expr.offset, true);
	} else {
		rule = _definitions[found].index;
		_edges.push_back({ _current_rule, rule, true });
	}
	emit_constant(Value::of_index(ValueType::Rule, rule), expr.offset);
}

// A value that is the word as a text does as well as sel(..) of it: Esri's rule for static models has i(file, upMode, ..), old files have "auto".
bool Compiler::text_as_word(const ParamSpec &param, uint32_t id) {
	const Expr &expr = _scope.ast->exprs[id];
	const bool may_be_number = param.kind == ParamKind::WordOrNumber;
	const bool is_value = expr.kind == ExprKind::Name ? is_value_name(expr.name) : expr.kind == ExprKind::Call || expr.kind == ExprKind::Case;
	if (expr.kind != ExprKind::Text && (may_be_number || !is_value)) {
		return false;
	}
	expression(id);
	emit(OpCode::FindWord, expr.offset, 0, symbol(param.words));
	return true;
}

// sel("name"): a name or word that is made while running.
bool Compiler::selector_argument(const Expr &expr, OpCode code, std::string_view words) {
	if (expr.kind != ExprKind::Call || expr.name != "sel" || expr.children.count != 1) {
		return false;
	}
	expression(_scope.ast->list(expr.children)[0]);
	emit(code, expr.offset, 0, symbol(words));
	return true;
}

void Compiler::target_argument(const Expr &expr) {
	if (selector_argument(expr, OpCode::FindTarget, _set.spaces[_scope.space].prefix)) {
		return;
	}
	if (expr.kind == ExprKind::Name) {
		const uint32_t found = _set.find_value(_scope.space, expr.name, 0);
		const bool is_attribute = found != no_node && _definitions[found].kind == Definition::Kind::Attribute;
		const bool is_read_only = is_attribute && is_constant(_definitions[found]);
		if (is_attribute && !is_read_only) {
			emit_constant(Value::of_index(ValueType::Attribute, _definitions[found].index), expr.offset);
			return;
		}
		const int variable = _dialect.find_variable(expr.name);
		if (variable >= 0 && _dialect.variables[size_t(variable)].is_writable) {
			emit_constant(Value::of_index(ValueType::Variable, uint32_t(variable)), expr.offset);
			return;
		}
		if (!is_read_only && variable < 0 && _set.is_excused(_scope.space, expr.name)) {
			emit_constant(Value(), expr.offset); // of an import that is missing: told there
			return;
		}
		complain("unknown-name", expr.offset,
				variable >= 0 || is_read_only ? "`" + std::string(expr.name) + "` can only be read"
							  : "there is no attribute `" + std::string(expr.name) + "` to set",
				is_read_only ? "declare it with attr" : did_you_mean(expr.name, false));
	} else {
		complain("not-a-name", expr.offset, "the name of an attribute belongs here");
	}
	emit_constant(Value(), expr.offset);
}

// --- Functions

Compiler::Known Compiler::call(const Expr &expr) {
	const uint32_t found = _set.find_value(_scope.space, expr.name, expr.children.count);
	if (found != no_node && _definitions[found].kind == Definition::Kind::Function) {
		return user_call(expr, found);
	}
	if (expr.children.count == 0 && (found != no_node || _dialect.find_variable(expr.name) >= 0)) {
		return global_name(expr, true); // height() of an attribute, scope.sx()
	}
	const int function = choose_function(expr.name, expr.children);
	if (function >= 0) {
		return call_builtin(uint32_t(function), expr.name, expr.children, expr.offset);
	}
	if (_set.has_value(_scope.space, expr.name) || _dialect.has_function(expr.name)) {
		wrong_count(expr.name, expr.children, expr.offset);
	} else if (_dialect.has_operation(expr.name)) {
		complain("not-a-value", expr.offset, "`" + std::string(expr.name) + "` is an operation: it has no value");
	} else {
		unknown("function", expr.name, expr.offset, false);
	}
	return unknown_value(expr.offset);
}

Compiler::Known Compiler::user_call(const Expr &expr, uint32_t definition) {
	for (uint32_t argument_id : _scope.ast->list(expr.children)) {
		expression(argument_id);
	}
	emit(OpCode::CallUser, expr.offset, 1 - int(expr.children.count), _definitions[definition].index, 0, expr.children.count);
	return ValueType::Void;
}

Compiler::Known Compiler::call_builtin(uint32_t function, std::string_view name, NodeRange list, uint32_t offset) {
	const FunctionSpec &spec = _dialect.functions[function];
	const uint32_t begin = here(), depth = _builders.back().depth;
	const uint32_t mask = arguments(spec.params, name, list);
	if (!spec.is_pure || !fold_call(spec, begin, depth, list.count, offset)) {
		emit(OpCode::CallFunction, offset, 1 - int(list.count), mask, function, list.count);
	}
	// In CGA a function may give a harmless value of another kind instead of an error.
	return spec.is_pure || is_strict() ? spec.result : ValueType::Void;
}

namespace {

double number_of(const Value &value) { return value.is_number() ? value.number : NAN; }

// A pure function looks at its arguments only; this is the interpreter that it is given anyway.
class NoHost : public VmHost {
public:
	void report(Diagnostic) override {}
};

} // namespace

bool Compiler::fold_call(const FunctionSpec &spec, uint32_t begin, uint32_t depth, size_t count, uint32_t offset) {
	const std::vector<Instruction> &code = _builders.back().code;
	if (code.size() != begin + count) {
		return false;
	}
	std::vector<Value> values;
	for (size_t i = begin; i < code.size(); ++i) {
		if (code[i].code != OpCode::PushConstant || !std::isfinite(number_of(_program->constants[code[i].operand]))) {
			return false;
		}
		values.push_back(_program->constants[code[i].operand]);
	}
	const Program empty;
	NoHost host;
	Vm vm(empty, host, { 1, 1, 1, 16 });
	const Value result = spec.handler(vm, { values, nullptr, nullptr, spec.user });
	const bool is_told = !is_strict() && result.is_number() && !std::isfinite(result.number); // in CGA: the run warns of it
	if (vm.has_failed() || is_told || (!result.is_number() && !result.is_bool())) {
		return false;
	}
	drop_code(begin, depth);
	emit_constant(result, offset);
	return true;
}

} // namespace pcg
