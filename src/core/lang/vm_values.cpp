#include <array>
#include <charconv>
#include <cmath>

#include "core/lang/opcode.h"
#include "core/lang/vm.h"

// What the loop does not do itself: values that are not two numbers, checks, arrays.
namespace pcg {

namespace {

std::string_view operator_text(OpCode code) {
	switch (code) {
		case OpCode::Add:
			return "+";
		case OpCode::Subtract:
			return "-";
		case OpCode::Multiply:
			return "*";
		case OpCode::Divide:
			return "/";
		case OpCode::Modulo:
			return "%";
		case OpCode::Less:
			return "<";
		case OpCode::LessEqual:
			return "<=";
		case OpCode::Greater:
			return ">";
		case OpCode::GreaterEqual:
			return ">=";
		case OpCode::Equal:
			return "==";
		case OpCode::NotEqual:
			return "!=";
		default:
			return "?";
	}
}

bool same_text(const Text &a, const Text &b) {
	return a.symbol != no_symbol && b.symbol != no_symbol ? a.symbol == b.symbol : a.view == b.view;
}

bool is_same(const Value &a, const Value &b) {
	if (a.type != b.type) {
		return false;
	}
	switch (a.type) {
		case ValueType::Number:
			return a.number == b.number;
		case ValueType::Bool:
			return a.boolean == b.boolean;
		case ValueType::Text:
			return same_text(*a.text, *b.text);
		case ValueType::Array: {
			if (a.array->rows != b.array->rows || a.array->columns != b.array->columns) {
				return false;
			}
			for (uint32_t i = 0; i < a.array->rows * a.array->columns; ++i) {
				if (!is_same(a.array->values[i], b.array->values[i])) {
					return false;
				}
			}
			return true;
		}
		default:
			return a.index == b.index;
	}
}

} // namespace

std::string value_text(const Value &value) {
	switch (value.type) {
		case ValueType::Number: {
			if (!std::isfinite(value.number)) {
				return std::isnan(value.number) ? "nan" : (value.number > 0 ? "inf" : "-inf");
			}
			// At most 15 digits, so that 0.1 + 0.2 reads 0.3.
			std::array<char, 32> digits;
			const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value.number, std::chars_format::general, 15);
			return std::string(digits.data(), end.ptr);
		}
		case ValueType::Bool:
			return value.boolean ? "true" : "false";
		case ValueType::Text:
			return std::string(value.text->view);
		case ValueType::Array: {
			std::string text = "[";
			for (uint32_t i = 0; i < value.array->rows * value.array->columns; ++i) {
				text += (i == 0 ? "" : (i % value.array->columns == 0 ? ";" : ",")) + value_text(value.array->values[i]);
			}
			return text + "]";
		}
		default:
			return std::string(type_name(value.type));
	}
}

Value Vm::fail_types(OpCode code, const Value &a, const Value &b) {
	return fail("type-mismatch", "`" + std::string(operator_text(code)) + "` cannot take " + std::string(type_name(a.type)) + " and " +
										 std::string(type_name(b.type)));
}

Value Vm::arithmetic(OpCode code, const Value &a, const Value &b) {
	if (a.is_number() && b.is_number()) { // division and modulus
		if (b.number == 0.0 && _program->dialect->unknown_names == Dialect::UnknownNames::Error) {
			return fail("division-by-zero", "division by zero", "test the divisor with `case` before");
		}
		return Value::of(code == OpCode::Divide ? a.number / b.number : std::fmod(a.number, b.number));
	}
	if (code == OpCode::Add && (a.is_text() || b.is_text()) && !a.is_void() && !b.is_void()) {
		return Value::of(make_text(value_text(a) + value_text(b)));
	}
	return compare(code, a, b);
}

Value Vm::compare(OpCode code, const Value &a, const Value &b) {
	if (a.type == b.type && (code == OpCode::Equal || code == OpCode::NotEqual)) {
		return Value::of(is_same(a, b) == (code == OpCode::Equal));
	}
	if (a.is_text() && b.is_text()) {
		const int order = a.text->view.compare(b.text->view);
		switch (code) {
			case OpCode::Less:
				return Value::of(order < 0);
			case OpCode::LessEqual:
				return Value::of(order <= 0);
			case OpCode::Greater:
				return Value::of(order > 0);
			case OpCode::GreaterEqual:
				return Value::of(order >= 0);
			default:
				break;
		}
	}
	return fail_types(code, a, b);
}

Value Vm::negate(const Value &value) {
	if (!value.is_number()) {
		return fail("type-mismatch", "`-` takes a number, this is " + std::string(type_name(value.type)));
	}
	return Value::of(-value.number);
}

// Out of range is an error in PCG and nothing special (0) in CGA, as with division by zero.
Value Vm::index_array(const Value &array, std::span<const Value> indices) {
	if (array.type != ValueType::Array) {
		return fail("type-mismatch", "[ ] takes an array, this is " + std::string(type_name(array.type)));
	}
	for (const Value &index : indices) {
		if (!index.is_number()) {
			return fail("type-mismatch", "an index is a number, this is " + std::string(type_name(index.type)));
		}
	}
	const double column = indices.size() == 2 ? indices[1].number : (array.array->rows == 1 ? indices[0].number : 0.0);
	const double row = indices.size() == 2 || array.array->rows > 1 ? indices[0].number : 0.0;
	if (!(row >= 0.0) || !(column >= 0.0) || row >= array.array->rows || column >= array.array->columns) {
		return fail("index-range", "there is no element " + value_text(indices[0]) + " in this array");
	}
	return array.array->values[size_t(row) * array.array->columns + size_t(column)];
}

namespace {

// The type that a parameter asks for at run time; Void: any.
ValueType wanted_type(ParamKind kind) {
	switch (kind) {
		case ParamKind::Number:
		case ParamKind::Size:
			return ValueType::Number;
		case ParamKind::Bool:
			return ValueType::Bool;
		case ParamKind::Text:
			return ValueType::Text;
		default:
			return ValueType::Void;
	}
}

} // namespace

bool Vm::check_arguments(const std::vector<ParamSpec> &params, std::string_view name, const Args &args, uint32_t mask) {
	for (size_t i = 0; i < args.count(); ++i) {
		if (((mask >> std::min<size_t>(i, 31)) & 1) == 0) {
			continue;
		}
		const ParamSpec &param = params[std::min(i, params.size() - 1)];
		const ValueType wanted = wanted_type(param.kind);
		const Value &value = args[i];
		const bool is_word_or_number = param.kind == ParamKind::WordOrNumber;
		const bool is_fine = is_word_or_number ? value.is_number() || value.type == ValueType::Word
											   : wanted == ValueType::Void || value.type == wanted;
		if (!is_fine) {
			fail("type-mismatch", "argument " + std::to_string(i + 1) + " of `" + std::string(name) + "` (" + std::string(param.name) +
										  ") must be " + std::string(type_name(is_word_or_number ? ValueType::Number : wanted)) +
										  ", this is " + std::string(type_name(value.type)));
			return false;
		}
	}
	return true;
}

} // namespace pcg
