#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "core/base/utf8.h"
#include "core/cga/functions/functions.h"
#include "core/lang/array_index.h"
#include "core/lang/vm.h"

// Arrays (CGA reference, section 8.2).
namespace pcg::cga {

namespace {

template <ValueType element> Value empty_array(Vm &vm, const Args &) { return Value::of(vm.make_array({}, 1, element)); }

Value size_of(Vm &, const Args &args) { return Value::of(double(args[0].array->size())); }
Value row_count(Vm &, const Args &args) { return Value::of(args[0].array->size() > 0 ? double(args[0].array->rows) : 0.0); }
Value column_count(Vm &, const Args &args) { return Value::of(double(args[0].array->columns)); }

bool is_equal(const Value &a, const Value &b, double epsilon) {
	if (a.type != b.type) {
		return false;
	}
	return a.is_number() ? std::fabs(a.number - b.number) <= epsilon : a.is_text() ? a.text->view == b.text->view : a.boolean == b.boolean;
}

// Of texts: the place of a part, as find().
Value find_first(Vm &vm, const Args &args) {
	if (args[0].is_text()) {
		const size_t at = text_at(args, 0).find(text_at(args, 1));
		const std::string_view before = text_at(args, 0).substr(0, std::min(at, text_at(args, 0).size()));
		return Value::of(at == std::string_view::npos ? -1.0 : double(count_characters(before)));
	}
	if (!args[0].is_array()) {
		vm.warn("type-mismatch", "findFirst looks into an array or a text");
		return Value::of(-1.0);
	}
	const ArrayData &array = *args[0].array;
	const double epsilon = args.count() > 2 && args[2].is_number() ? std::fabs(args[2].number) : 0.0;
	for (uint32_t i = 0; i < array.size(); ++i) {
		if (is_equal(array.values[i], args[1], epsilon)) {
			return Value::of(double(i));
		}
	}
	return Value::of(-1.0);
}

bool is_less(const Value &a, const Value &b) {
	if (a.is_number() && b.is_number()) {
		return std::isnan(b.number) ? !std::isnan(a.number) : a.number < b.number;
	}
	return a.is_text() && b.is_text() ? a.text->view < b.text->view : a.is_bool() && b.is_bool() && a.boolean < b.boolean;
}

// Each row by itself; places count through the whole array.
Value sort_indices(Vm &vm, const Args &args) {
	const ArrayData &array = *args[0].array;
	std::vector<uint32_t> order(array.size());
	std::iota(order.begin(), order.end(), 0u);
	for (uint32_t row = 0; row < array.rows && array.columns > 0; ++row) {
		const auto first = order.begin() + row * array.columns;
		std::stable_sort(first, first + array.columns, [&](uint32_t a, uint32_t b) { return is_less(array.values[a], array.values[b]); });
	}
	std::vector<Value> values;
	for (const uint32_t place : order) {
		values.push_back(Value::of(double(place)));
	}
	return Value::of(vm.make_array(values, array.rows));
}

Value sort_row_indices(Vm &vm, const Args &args) {
	const ArrayData &array = *args[0].array;
	std::vector<uint32_t> order(array.size() > 0 ? array.rows : 0);
	std::iota(order.begin(), order.end(), 0u);
	std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
		const Value *left = array.values + a * array.columns, *right = array.values + b * array.columns;
		return std::lexicographical_compare(left, left + array.columns, right, right + array.columns, is_less);
	});
	std::vector<Value> values;
	for (const uint32_t row : order) {
		values.push_back(Value::of(double(row)));
	}
	return Value::of(vm.make_array(values));
}

Value sum(Vm &vm, const Args &args) {
	const ArrayData &array = *args[0].array;
	double total = 0.0;
	std::string joined;
	for (uint32_t i = 0; i < array.size(); ++i) {
		const Value &value = array.values[i];
		total += value.is_number() ? value.number : value.is_bool() && value.boolean ? 1.0 : 0.0;
		joined += value.is_text() ? value.text->view : std::string_view();
	}
	return array.element == ValueType::Text ? Value::of(vm.make_text(joined)) : Value::of(total);
}

Value transpose(Vm &vm, const Args &args) {
	const ArrayData &array = *args[0].array;
	std::vector<Value> values;
	for (uint32_t column = 0; column < array.columns; ++column) {
		for (uint32_t row = 0; row < array.rows; ++row) {
			values.push_back(array.values[row * array.columns + column]);
		}
	}
	return Value::of(vm.make_array(values, std::max(array.columns, 1u), array.element));
}

// Where setElems writes: it may grow the array.
struct Grid {
	std::vector<Value> values;
	uint32_t rows = 1, columns = 0;

	void grow(int64_t new_rows, int64_t new_columns, const Value &fill) {
		const uint32_t r = uint32_t(std::max<int64_t>(rows, new_rows)), c = uint32_t(std::max<int64_t>(columns, new_columns));
		if (r == rows && c == columns) {
			return;
		}
		std::vector<Value> larger(size_t(r) * c, fill);
		for (uint32_t row = 0; row < rows; ++row) {
			std::copy_n(values.begin() + row * columns, columns, larger.begin() + row * c);
		}
		values = std::move(larger);
		rows = r;
		columns = c;
	}
};

int64_t largest(const std::vector<int64_t> &places) {
	return places.empty() ? -1 : *std::max_element(places.begin(), places.end());
}

bool is_too_large(Vm &vm, int64_t rows, int64_t columns) {
	constexpr int64_t most = max_array_size;
	if (rows <= most && columns <= most && rows * columns <= most) {
		return false;
	}
	vm.warn("array-too-large", "an array has at most " + std::to_string(max_array_size) + " elements; this one stays as it is");
	return true;
}

// setElems(array, places, values) and setElems(array, rows, columns, values).
Value set_elements(Vm &vm, const Args &args) {
	const ArrayData &array = *args[0].array;
	const bool has_rows = args.count() == 4;
	ArrayIndex rows, columns;
	if (!read_array_index(args[1], has_rows ? rows : columns) || (has_rows && !read_array_index(args[2], columns))) {
		vm.warn("type-mismatch", "places in an array are numbers, or arrays of numbers or of truth values");
		return args[0];
	}
	const Value &given = args[args.count() - 1];
	Grid grid = { { array.values, array.values + array.size() }, array.rows, array.columns };
	// Without rows the places count through the whole array; beyond its end one of a single row grows.
	const int64_t needed_rows = has_rows ? largest(rows.at) + 1 : 0, last = largest(columns.at) + 1;
	const int64_t needed_columns = has_rows ? last : last <= int64_t(array.size()) ? 0 : (last + array.rows - 1) / array.rows;
	if (is_too_large(vm, std::max<int64_t>(needed_rows, grid.rows), std::max<int64_t>(needed_columns, grid.columns))) {
		return args[0];
	}
	grid.grow(needed_rows, needed_columns, vm.default_of(array.element));
	rows.at = has_rows ? rows.at : std::vector<int64_t>{ 0 };
	size_t next = 0;
	for (const int64_t row : rows.at) {
		for (const int64_t column : columns.at) {
			const Value value = given.is_array() ? (next < given.array->size() ? given.array->values[next] : vm.default_of(array.element)) : given;
			++next;
			if (row >= 0 && column >= 0) {
				grid.values[size_t(row * grid.columns + column)] = value;
			}
		}
	}
	return Value::of(vm.make_array(grid.values, grid.rows, array.element));
}

// index(array, place) of old files: array[place].
Value index(Vm &vm, const Args &args) {
	const ArrayData &array = *args[0].array;
	const double place = args[1].number;
	return place >= 0.0 && place < double(array.size()) ? array.values[uint32_t(place)] : vm.default_of(array.element);
}

} // namespace

void add_array_functions(Dialect &dialect) {
	using enum ParamKind;
	auto &functions = dialect.functions;
	const ParamSpec array = { "array", Array };
	constexpr ValueType many = ValueType::Array, number = ValueType::Number;
	functions.push_back({ "floatArray", {}, many, empty_array<ValueType::Number>, "An empty array of numbers." });
	functions.push_back({ "boolArray", {}, many, empty_array<ValueType::Bool>, "An empty array of truth values." });
	functions.push_back({ "stringArray", {}, many, empty_array<ValueType::Text>, "An empty array of texts." });
	functions.push_back({ "size", { array }, number, size_of, "How many elements an array has." });
	functions.push_back({ "nRows", { array }, number, row_count, "How many rows an array has." });
	functions.push_back({ "nColumns", { array }, number, column_count, "How many columns an array has." });
	functions.push_back({ "findFirst", { { "array", Any }, { "value", Any }, { "epsilon", Number, {}, true } }, number, find_first,
			"Place of the first element that equals the value, within epsilon for numbers, or -1. Of a text: the place of a part." });
	functions.push_back({ "sortIndices", { array }, many, sort_indices, "The places of the elements in ascending order, each row by itself." });
	functions.push_back({ "sortRowIndices", { array }, many, sort_row_indices, "The numbers of the rows in ascending order." });
	functions.push_back({ "sum", { array }, ValueType::Void, sum, "The sum of numbers, how many are true, or the texts joined." });
	functions.push_back({ "transpose", { array }, many, transpose, "Rows become columns." });
	functions.push_back({ "setElems", { array, { "places", Any }, { "values", Any } }, many, set_elements,
			"The array with other elements at some places; beyond its end it grows." });
	functions.push_back({ "setElems", { array, { "rows", Any }, { "columns", Any }, { "values", Any } }, many, set_elements,
			"The same by rows and columns." });
	functions.push_back({ "index", { array, { "place", Number } }, ValueType::Void, index, "Old form of array[place]." });
}

} // namespace pcg::cga
