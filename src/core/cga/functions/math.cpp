#include <cmath>
#include <deque>
#include <type_traits>
#include <vector>

#include "core/cga/functions/functions.h"
#include "core/lang/vm.h"

// What CGA's mathematics have beside those of all dialects: arrays, and what becomes of numbers that are none (CGA reference, section 8.1).
namespace pcg::cga {

namespace {

// Of a number, or of each element of an array.
template <auto function> Value each(Vm &vm, const Args &args) {
	using Result = decltype(function(0.0));
	if (args[0].is_number()) {
		return Value::of(function(args[0].number));
	}
	if (!args[0].is_array()) {
		return vm.mismatch("type-mismatch", "this takes a number or an array of numbers", Value::of(Result()));
	}
	std::vector<Value> values;
	for (uint32_t i = 0; i < args[0].array->size(); ++i) {
		const Value &value = args[0].array->values[i];
		values.push_back(Value::of(function(value.is_number() ? value.number : 0.0)));
	}
	return Value::of(vm.make_array(values, args[0].array->rows, std::is_same_v<Result, bool> ? ValueType::Bool : ValueType::Number));
}

double without_sign(double x) { return std::fabs(x); }
double round_down(double x) { return std::floor(x); }
double round_up(double x) { return std::ceil(x); }
double round_to_nearest(double x) { return std::round(x); }
// As rint of C and Java; Esri's street rules add 0.01 to have halves go up.
double round_to_even(double x) { return std::isfinite(x) ? x - std::remainder(x, 1.0) : x; }
bool is_nan(double x) { return std::isnan(x); }
bool is_infinite(double x) { return std::isinf(x); }

template <auto function> void take_arrays(Dialect &dialect, std::string_view name) {
	FunctionSpec &spec = dialect.functions[size_t(dialect.find_function(name, 1))];
	spec.params[0].kind = ParamKind::Any;
	spec.handler = each<function>;
	spec.result = ValueType::Void;
}

// `user` is the function itself. What it gives may be none, for isnan() to ask; only what it takes may not.
Value with_finite_numbers(Vm &vm, const Args &args) {
	for (const Value &value : args.values) {
		if (value.is_number() && !std::isfinite(value.number)) {
			vm.warn("not-finite", "this number is infinite or not a number; 0 is taken instead", "look for a division by zero or a root of a negative number");
			const_cast<Value &>(value) = Value::of(0.0); // on the interpreter's own stack
		}
	}
	return (*static_cast<const FunctionHandler *>(args.user))(vm, args);
}

// Roots of negative numbers and angles of what is no sine or cosine are told where they come to be (CGA changelog 2018.0).
Value with_finite_result(Vm &vm, const Args &args) {
	const Value result = with_finite_numbers(vm, args);
	if (result.is_number() && !std::isfinite(result.number)) {
		vm.warn("no-result", "this function has no value there: the result is not a number", "sqrt takes 0 and above, asin and acos take -1 to 1");
	}
	return result;
}

void take_finite_numbers(Dialect &dialect, std::string_view name) {
	static std::deque<FunctionHandler> handlers; // the dialect is made once
	for (FunctionSpec &spec : dialect.functions) {
		if (spec.name == name && !spec.params.empty()) {
			spec.user = &handlers.emplace_back(spec.handler);
			spec.handler = with_finite_numbers;
		}
	}
}

} // namespace

void extend_math_functions(Dialect &dialect) {
	take_arrays<without_sign>(dialect, "abs");
	take_arrays<round_down>(dialect, "floor");
	take_arrays<round_up>(dialect, "ceil");
	take_arrays<round_to_even>(dialect, "rint");
	dialect.functions[size_t(dialect.find_function("rint", 1))].help = "The nearest whole number, of halves the even one.";
	take_arrays<round_to_nearest>(dialect, "round");
	take_arrays<is_nan>(dialect, "isnan");
	take_arrays<is_infinite>(dialect, "isinf");
	for (const std::string_view name : { "abs", "floor", "ceil", "rint", "sqrt", "exp", "ln", "log10", "pow", "sin", "cos", "tan", "asin", "acos", "atan",
				 "atan2", "rand", "p", "find", "substring" }) {
		take_finite_numbers(dialect, name);
	}
	for (const std::string_view name : { "sqrt", "asin", "acos" }) {
		dialect.functions[size_t(dialect.find_function(name, 1))].handler = with_finite_result;
	}
}

} // namespace pcg::cga
