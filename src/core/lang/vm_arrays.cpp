#include <algorithm>
#include <cmath>

#include "core/lang/array_index.h"
#include "core/lang/opcode.h"
#include "core/lang/vm.h"

// Arrays: making, indexing, operators element by element (CGA reference: func_array, func_colon, func_index, arrayTypes).
namespace pcg {

bool Vm::fits_array(uint64_t size) {
	if (size <= max_array_size) {
		return true;
	}
	mismatch("array-too-large", "an array has at most " + std::to_string(max_array_size) + " elements; this one is left empty", Value());
	return false;
}

// Numbers, texts and arrays side by side; all arrays have equally many rows, and empty ones do not count.
Value Vm::make_row(std::span<const Value> parts) {
	uint32_t rows = 0;
	uint64_t columns = 0;
	ValueType element = ValueType::Void;
	for (const Value &part : parts) {
		const bool is_empty = part.is_array() && part.array->size() == 0;
		const uint32_t part_rows = part.is_array() ? part.array->rows : 1;
		const ValueType type = part.is_array() ? part.array->element : part.type;
		if (!is_empty && rows != 0 && part_rows != rows) {
			return mismatch("array-shape", "arrays side by side have equally many rows", Value::of(make_array({})));
		}
		if (!is_empty && element != ValueType::Void && element != type) {
			return mismatch("type-mismatch", "the elements of an array are of one type", Value::of(make_array({})));
		}
		rows = is_empty ? rows : part_rows;
		columns += is_empty ? 0 : part.is_array() ? part.array->columns : 1;
		element = is_empty && element != ValueType::Void ? element : type;
	}
	if (!fits_array(columns * rows)) {
		return Value::of(make_array({}));
	}
	std::vector<Value> values;
	values.reserve(columns * rows);
	for (uint32_t row = 0; row < rows; ++row) {
		for (const Value &part : parts) {
			if (!part.is_array()) {
				values.push_back(part);
			} else if (part.array->size() > 0) {
				const Value *first = part.array->values + row * part.array->columns;
				values.insert(values.end(), first, first + part.array->columns);
			}
		}
	}
	return Value::of(make_array(values, std::max(rows, 1u), element == ValueType::Void ? ValueType::Number : element));
}

Value Vm::stack_rows(std::span<const Value> parts) {
	std::vector<Value> values;
	uint32_t columns = 0, rows = 0;
	ValueType element = ValueType::Number;
	for (const Value &part : parts) {
		const ArrayData &array = *part.array;
		const bool is_empty = array.size() == 0;
		if (!is_empty && rows > 0 && (array.columns != columns || array.element != element)) {
			return mismatch("array-shape", "the rows of an array have equal lengths and elements of one type", Value::of(make_array({})));
		}
		if (is_empty) {
			continue;
		}
		if (!fits_array(values.size() + array.size())) {
			return Value::of(make_array({}));
		}
		columns = array.columns;
		rows += array.rows;
		element = array.element;
		values.insert(values.end(), array.values, array.values + array.size());
	}
	return Value::of(make_array(values, std::max(rows, 1u), rows == 0 && !parts.empty() ? parts[0].array->element : element));
}

// base : limit, or base : increment : limit; the last element does not go beyond the limit.
Value Vm::make_range(std::span<const Value> parts) {
	for (const Value &part : parts) {
		if (!part.is_number() || !std::isfinite(part.number)) {
			return mismatch("type-mismatch", "a range is made of numbers, this is " + value_text(part), Value::of(make_array({})));
		}
	}
	const double base = parts[0].number, limit = parts.back().number;
	const double increment = parts.size() == 3 ? parts[1].number : 1.0;
	// A trace more, so that 0 : 0.1 : 0.3 ends with 0.3.
	const double steps = increment != 0.0 ? std::floor((limit - base) / increment + 1e-9) : -1.0;
	std::vector<Value> values;
	if (steps >= 0.0 && fits_array(uint64_t(std::min(steps, 1e9)) + 1)) {
		for (uint32_t i = 0; i <= uint32_t(steps); ++i) {
			values.push_back(Value::of(base + i * increment));
		}
	}
	return Value::of(make_array(values));
}

Value Vm::index_array(const Value &array, std::span<const Value> indices) {
	if (!array.is_array()) {
		return mismatch("type-mismatch", "[ ] takes an array, this is " + std::string(type_name(array.type)), array);
	}
	const ArrayData &data = *array.array;
	ArrayIndex parts[2];
	for (size_t i = 0; i < indices.size(); ++i) {
		if (!read_array_index(indices[i], parts[i])) {
			return mismatch("type-mismatch", "an index is a number or an array, this is " + std::string(type_name(indices[i].type)),
					default_of(data.element));
		}
	}
	const bool has_rows = indices.size() == 2;
	const bool is_single = parts[0].is_single && (!has_rows || parts[1].is_single);
	if (!has_rows) {
		parts[1] = std::move(parts[0]);
		parts[0].at = { 0 };
	}
	if (!fits_array(uint64_t(parts[0].at.size()) * parts[1].at.size())) {
		return Value::of(make_array({}));
	}
	std::vector<Value> values;
	for (int64_t row : parts[0].at) {
		for (int64_t column : parts[1].at) {
			const int64_t width = has_rows ? data.columns : data.size();
			const bool is_there = row >= 0 && row < int64_t(data.rows) && column >= 0 && column < width;
			if (!is_there && is_strict()) {
				return fail("index-range", "there is no element " + value_text(indices[0]) + " in this array");
			}
			values.push_back(is_there ? data.values[row * int64_t(data.columns) + column] : default_of(data.element));
		}
	}
	if (is_single) {
		return values[0];
	}
	return Value::of(make_array(values, has_rows ? std::max<uint32_t>(uint32_t(parts[0].at.size()), 1) : std::max(parts[1].rows, 1u), data.element));
}

namespace {

ValueType result_element(OpCode code, ValueType a, ValueType b) {
	switch (code) {
		case OpCode::Add:
			return a == ValueType::Text || b == ValueType::Text ? ValueType::Text : ValueType::Number;
		case OpCode::Subtract:
		case OpCode::Multiply:
		case OpCode::Divide:
		case OpCode::Modulo:
			return ValueType::Number;
		default:
			return ValueType::Bool;
	}
}

} // namespace

// One of the two is an array; the other may be a plain value, which goes with every element.
Value Vm::elementwise(OpCode code, const Value &a, const Value &b) {
	const ArrayData &shape = a.is_array() ? *a.array : *b.array;
	const ArrayData &other = b.is_array() ? *b.array : shape;
	if (shape.rows != other.rows || shape.columns != other.columns) {
		const auto text = [](const ArrayData &array) { return std::to_string(array.rows) + "x" + std::to_string(array.columns); };
		return mismatch("array-shape", "operators with a dot take arrays of the same shape, these are " + text(shape) + " and " + text(other),
				Value::of(make_array({})));
	}
	std::vector<Value> values;
	values.reserve(shape.size());
	for (uint32_t i = 0; i < shape.size() && !_failed; ++i) {
		values.push_back(one_element(code, a.is_array() ? a.array->values[i] : a, b.is_array() ? b.array->values[i] : b));
	}
	const ValueType element = result_element(code, a.is_array() ? a.array->element : a.type, b.is_array() ? b.array->element : b.type);
	return Value::of(make_array(values, shape.rows, element));
}

Value Vm::negate_array(OpCode code, const ArrayData &array) {
	std::vector<Value> values;
	values.reserve(array.size());
	for (uint32_t i = 0; i < array.size() && !_failed; ++i) {
		values.push_back(code == OpCode::Not ? Value::of(!is_true(array.values[i])) : negate(array.values[i]));
	}
	return Value::of(make_array(values, array.rows, array.element));
}

} // namespace pcg
