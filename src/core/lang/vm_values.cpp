#include <algorithm>
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
		case OpCode::And:
			return "&&";
		case OpCode::Or:
			return "||";
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

namespace {

// (3)[1,2,3], or with several rows "(2x2)" and a line for each row, columns flush right.
std::string array_text(const ArrayData &array) {
	std::vector<std::string> texts;
	std::vector<size_t> widths(array.columns, 0);
	for (uint32_t i = 0; i < array.size(); ++i) {
		texts.push_back(value_text(array.values[i]));
		widths[i % array.columns] = std::max(widths[i % array.columns], texts.back().size());
	}
	if (array.rows <= 1) {
		std::string line = "(" + std::to_string(array.columns) + ")[";
		for (size_t i = 0; i < texts.size(); ++i) {
			line += (i > 0 ? "," : "") + texts[i];
		}
		return line + "]";
	}
	std::string block = "(" + std::to_string(array.rows) + "x" + std::to_string(array.columns) + ")";
	for (size_t i = 0; i < texts.size(); ++i) {
		const size_t column = i % array.columns;
		block += (column == 0 ? "\n" : "") + std::string(3 + widths[column] - texts[i].size(), ' ') + texts[i];
	}
	return block;
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
		case ValueType::Array:
			return array_text(*value.array);
		default:
			return std::string(type_name(value.type));
	}
}

Value Vm::fail_types(OpCode code, const Value &a, const Value &b) {
	const bool is_truth = code == OpCode::NotEqual;
	const bool is_number = code == OpCode::Add || code == OpCode::Subtract || code == OpCode::Multiply || code == OpCode::Divide || code == OpCode::Modulo;
	return mismatch("type-mismatch", "`" + std::string(operator_text(code)) + "` cannot take " + std::string(type_name(a.type)) + " and " +
										 std::string(type_name(b.type)), is_number ? Value::of(0.0) : Value::of(is_truth));
}

Value Vm::divide(OpCode code, double a, double b) {
	if (b == 0.0 && is_strict()) {
		return fail("division-by-zero", "division by zero", "test the divisor with `case` before");
	}
	return Value::of(code == OpCode::Divide ? a / b : std::fmod(a, b));
}

// What the loop does not compute itself.
Value Vm::arithmetic(const Instruction &instruction, const Value &a, const Value &b) {
	const OpCode code = instruction.code;
	if (instruction.extra != 0 && (a.is_array() || b.is_array())) {
		return elementwise(code, a, b);
	}
	return one_element(code, a, b);
}

Value Vm::one_element(OpCode code, const Value &a, const Value &b) {
	if (a.is_number() && b.is_number()) {
		switch (code) {
			case OpCode::Add:
				return Value::of(a.number + b.number);
			case OpCode::Subtract:
				return Value::of(a.number - b.number);
			case OpCode::Multiply:
				return Value::of(a.number * b.number);
			case OpCode::Divide:
			case OpCode::Modulo:
				return divide(code, a.number, b.number);
			default:
				return compare(code, a, b);
		}
	}
	if (code == OpCode::Add && (a.is_text() || b.is_text()) && !a.is_void() && !b.is_void()) {
		return Value::of(make_text(value_text(a) + value_text(b)));
	}
	if (code == OpCode::And || code == OpCode::Or) {
		const bool left = is_true(a), right = is_true(b);
		return Value::of(code == OpCode::And ? left && right : left || right);
	}
	return compare(code, a, b);
}

namespace {

// Of an order: negative, zero or positive, as from a three-way comparison.
bool holds(OpCode code, int order) {
	switch (code) {
		case OpCode::Less:
			return order < 0;
		case OpCode::LessEqual:
			return order <= 0;
		case OpCode::Greater:
			return order > 0;
		default:
			return order >= 0;
	}
}

bool is_order(OpCode code) {
	return code == OpCode::Less || code == OpCode::LessEqual || code == OpCode::Greater || code == OpCode::GreaterEqual;
}

} // namespace

Value Vm::compare(OpCode code, const Value &a, const Value &b) {
	if (a.type == b.type && (code == OpCode::Equal || code == OpCode::NotEqual)) {
		return Value::of(is_same(a, b) == (code == OpCode::Equal));
	}
	if (!is_order(code) || a.type != b.type) {
		return fail_types(code, a, b);
	}
	if (a.is_number()) {
		const bool is_ordered = !std::isnan(a.number) && !std::isnan(b.number);
		return Value::of(is_ordered && holds(code, a.number < b.number ? -1 : int(a.number > b.number)));
	}
	if (a.is_text()) {
		return Value::of(holds(code, a.text->view.compare(b.text->view)));
	}
	return a.is_array() ? compare_arrays(code, *a.array, *b.array) : fail_types(code, a, b);
}

// Row by row; where everything is equal, the array with fewer columns, then that with fewer rows is less. CGA reference: arrayTypes.
Value Vm::compare_arrays(OpCode code, const ArrayData &a, const ArrayData &b) {
	int order = 0;
	const uint32_t rows = std::min(a.rows, b.rows), columns = std::min(a.columns, b.columns);
	for (uint32_t row = 0; row < rows && order == 0; ++row) {
		for (uint32_t column = 0; column < columns && order == 0; ++column) {
			const Value &left = a.values[row * a.columns + column], &right = b.values[row * b.columns + column];
			order = compare(OpCode::Less, left, right).boolean ? -1 : int(compare(OpCode::Greater, left, right).boolean);
		}
		order = order != 0 ? order : int(a.columns > b.columns) - int(a.columns < b.columns);
	}
	return Value::of(holds(code, order != 0 ? order : int(a.rows > b.rows) - int(a.rows < b.rows)));
}

Value Vm::negate(const Value &value) {
	if (value.is_array()) {
		return negate_array(OpCode::Negate, *value.array);
	}
	if (!value.is_number()) {
		return mismatch("type-mismatch", "`-` takes a number, this is " + std::string(type_name(value.type)), Value::of(0.0));
	}
	return Value::of(-value.number);
}

namespace {

bool fits(ParamKind kind, ValueType type) {
	const ValueType wanted = wanted_type(kind);
	return type == wanted || (kind == ParamKind::WordOrNumber ? type == ValueType::Number || type == ValueType::Word : wanted == ValueType::Void);
}

} // namespace

bool Vm::check_arguments(const std::vector<ParamSpec> &params, std::string_view name, const Args &args, uint32_t mask) {
	for (size_t i = 0; i < args.count(); ++i) {
		const bool is_checked = (mask >> std::min<size_t>(i, last_check_bit)) & 1;
		Value &value = const_cast<Value &>(args[i]); // on the interpreter's own stack
		const ParamSpec &param = params[std::min(i, params.size() - 1)];
		if (is_checked && !fits(param.kind, value.type) && !replace_argument(param, name, i, value)) {
			return false;
		}
	}
	return true;
}

// False: the run has failed.
bool Vm::replace_argument(const ParamSpec &param, std::string_view name, size_t position, Value &value) {
	const ValueType type = param.kind == ParamKind::WordOrNumber ? ValueType::Number : wanted_type(param.kind);
	const Value fallback = type == ValueType::Array ? Value::of(make_array({})) : default_of(type);
	value = mismatch("type-mismatch", "argument " + std::to_string(position + 1) + " of `" + std::string(name) + "` (" + std::string(param.name) +
					") must be " + std::string(type_name(type)) + ", this is " + std::string(type_name(value.type)), fallback);
	return !_failed;
}

const Text *Vm::make_text(std::string_view text) {
	made().text_storage.emplace_back(text);
	_made->texts.push_back({ _made->text_storage.back(), no_symbol });
	return &_made->texts.back();
}

const ArrayData *Vm::make_array(std::span<const Value> values, uint32_t rows, ValueType element) {
	made().array_storage.emplace_back(values.begin(), values.end());
	const uint32_t columns = rows > 0 ? uint32_t(values.size()) / rows : 0;
	_made->arrays.push_back({ _made->array_storage.back().data(), rows, columns, values.empty() ? element : values[0].type });
	return &_made->arrays.back();
}

} // namespace pcg
