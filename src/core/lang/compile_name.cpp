#include <algorithm>

#include "core/lang/compiler.h"

// What a bare name in an expression means.
namespace pcg {

// A parameter, a `with` value, or with dynamic locals whatever may have been set by a caller.
bool Compiler::local_name(const Expr &expr) {
	for (size_t i = _scope.locals.size(); i-- > 0;) {
		if (_scope.locals[i] == expr.name) {
			if (is_dynamic()) {
				emit(OpCode::LoadSlot, expr.offset, 1, slot(expr.name));
			} else {
				emit(OpCode::LoadLocal, expr.offset, 1, uint32_t(i));
			}
			return true;
		}
	}
	const auto known = _slots.find(expr.name);
	if (!is_dynamic() || _scope.is_attribute || known == _slots.end()) {
		return false;
	}
	// Where it is not set at that moment, the name may still be an attribute or a variable.
	const uint32_t other = emit_jump(OpCode::JumpIfUnset, expr.offset, 0, known->second);
	emit(OpCode::LoadSlot, expr.offset, 1, known->second);
	const uint32_t end = emit_jump(OpCode::Jump, expr.offset, -1);
	land(other);
	const uint32_t begin = here(), depth = _builders.back().depth;
	if (global_name(expr, false) == ValueType::Void && here() == begin) {
		drop_code(other, depth);
		emit(OpCode::LoadSlot, expr.offset, 1, known->second);
		return true;
	}
	land(end);
	return true;
}

Compiler::Known Compiler::name(const Expr &expr) {
	if (expr.name == "true" || expr.name == "false") {
		emit_constant(Value::of(expr.name == "true"), expr.offset);
		return ValueType::Bool;
	}
	return local_name(expr) ? ValueType::Void : global_name(expr, true);
}

// Emits nothing if there is no such name and it is not required.
Compiler::Known Compiler::global_name(const Expr &expr, bool is_required) {
	const uint32_t found = _set.find_value(_scope.space, expr.name, 0);
	if (found != no_node) {
		const Definition &definition = _definitions[found];
		const bool is_attribute = definition.kind == Definition::Kind::Attribute;
		if (is_attribute && !_constant_values[definition.index].is_void()) {
			emit_constant(_constant_values[definition.index], expr.offset);
			return _constant_values[definition.index].type;
		}
		const uint32_t index = is_attribute && is_given_here(found) ? own_value_of(found) : definition.index;
		emit(is_attribute ? OpCode::LoadAttribute : OpCode::CallUser, expr.offset, 1, index);
		return ValueType::Void;
	}
	if (_scope.is_selector && is_selector_word(expr.name)) {
		emit_constant(Value::of(&_program->texts[symbol(expr.name)]), expr.offset);
		emit(OpCode::CallFunction, expr.offset, 0, 0, uint32_t(_dialect.find_function(_dialect.selector_function, 1)), 1);
		return ValueType::Bool;
	}
	const int variable = _dialect.find_variable(expr.name);
	if (variable >= 0) {
		emit(OpCode::LoadVariable, expr.offset, 1, uint32_t(variable));
		return ValueType::Void;
	}
	const int function = _dialect.find_function(expr.name, 0);
	if (function >= 0) {
		return call_builtin(uint32_t(function), expr.name, {}, expr.offset);
	}
	return is_required ? unknown_global(expr) : ValueType::Void;
}

bool Compiler::is_selector_word(std::string_view name) const {
	return std::find(_dialect.selector_words.begin(), _dialect.selector_words.end(), name) != _dialect.selector_words.end();
}

Compiler::Known Compiler::unknown_global(const Expr &expr) {
	if (_set.has_value(_scope.space, expr.name) || _dialect.has_function(expr.name)) {
		complain("wrong-argument-count", expr.offset, "`" + std::string(expr.name) + "` is a function and needs arguments");
	} else if (_set.has_rule(_scope.space, expr.name)) {
		complain("not-a-value", expr.offset, "`" + std::string(expr.name) + "` is a rule: it has no value");
	} else {
		unknown("name", expr.name, expr.offset, false);
	}
	return unknown_value(expr.offset);
}

} // namespace pcg
