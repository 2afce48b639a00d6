#include <cmath>
#include <numbers>

#include "core/lang/dialect.h"
#include "core/lang/vm.h"

// Angles are degrees, as everywhere in the rule languages.
namespace pcg {

namespace {

constexpr double degrees = 180.0 / std::numbers::pi;

// Half away from zero, on every platform and rounding mode.
double round_half_up(double x) { return std::round(x); }
double sign(double x) { return x > 0.0 ? 1.0 : (x < 0.0 ? -1.0 : 0.0); }
double sine(double x) { return std::sin(x / degrees); }
double cosine(double x) { return std::cos(x / degrees); }
double tangent(double x) { return std::tan(x / degrees); }
double arc_sine(double x) { return std::asin(x) * degrees; }
double arc_cosine(double x) { return std::acos(x) * degrees; }
double arc_tangent(double x) { return std::atan(x) * degrees; }

template <double (*function)(double)> Value unary(Vm &, const Args &args) { return Value::of(function(args.number(0))); }

Value power(Vm &, const Args &args) { return Value::of(std::pow(args.number(0), args.number(1))); }
Value arc_tangent_2(Vm &, const Args &args) { return Value::of(std::atan2(args.number(0), args.number(1)) * degrees); }
Value is_nan(Vm &, const Args &args) { return Value::of(std::isnan(args.number(0))); }
Value is_inf(Vm &, const Args &args) { return Value::of(std::isinf(args.number(0))); }

Value smallest(Vm &, const Args &args) {
	double result = args.number(0);
	for (size_t i = 1; i < args.count(); ++i) {
		result = std::fmin(result, args.number(i));
	}
	return Value::of(result);
}

Value largest(Vm &, const Args &args) {
	double result = args.number(0);
	for (size_t i = 1; i < args.count(); ++i) {
		result = std::fmax(result, args.number(i));
	}
	return Value::of(result);
}

Value random_between(Vm &vm, const Args &args) { return Value::of(vm.random().uniform(args.number(0), args.number(1))); }
Value random_below(Vm &vm, const Args &args) { return Value::of(vm.random().uniform(0.0, args.number(0))); }
Value random_unit(Vm &vm, const Args &) { return Value::of(vm.random().uniform()); }
Value chance(Vm &vm, const Args &args) { return Value::of(vm.random().chance(args.number(0))); }

void add(Dialect &dialect, std::string_view name, std::vector<ParamSpec> params, FunctionHandler handler, std::string_view help) {
	dialect.functions.push_back({ name, std::move(params), ValueType::Number, handler, help, true, nullptr });
}

} // namespace

void add_math_functions(Dialect &dialect) {
	const ParamSpec x = { "x", ParamKind::Number };
	const ParamSpec y = { "y", ParamKind::Number };
	ParamSpec more = { "more", ParamKind::Number };
	more.is_repeated = true;
	add(dialect, "abs", { x }, unary<std::fabs>, "x without its sign.");
	add(dialect, "floor", { x }, unary<std::floor>, "The next whole number below.");
	add(dialect, "ceil", { x }, unary<std::ceil>, "The next whole number above.");
	add(dialect, "round", { x }, unary<round_half_up>, "The nearest whole number, halves away from zero.");
	add(dialect, "rint", { x }, unary<round_half_up>, "The same as round.");
	add(dialect, "sign", { x }, unary<sign>, "-1, 0 or 1.");
	add(dialect, "sqrt", { x }, unary<std::sqrt>, "Square root.");
	add(dialect, "exp", { x }, unary<std::exp>, "e to the power of x.");
	add(dialect, "ln", { x }, unary<std::log>, "Natural logarithm.");
	add(dialect, "log10", { x }, unary<std::log10>, "Logarithm to the base 10.");
	add(dialect, "sin", { x }, unary<sine>, "Sine of an angle in degrees.");
	add(dialect, "cos", { x }, unary<cosine>, "Cosine of an angle in degrees.");
	add(dialect, "tan", { x }, unary<tangent>, "Tangent of an angle in degrees.");
	add(dialect, "asin", { x }, unary<arc_sine>, "The angle in degrees with that sine.");
	add(dialect, "acos", { x }, unary<arc_cosine>, "The angle in degrees with that cosine.");
	add(dialect, "atan", { x }, unary<arc_tangent>, "The angle in degrees with that tangent.");
	add(dialect, "atan2", { y, x }, arc_tangent_2, "The angle in degrees of the point (x, y).");
	add(dialect, "pow", { x, y }, power, "x to the power of y.");
	add(dialect, "min", { x, y, more }, smallest, "The smallest of the numbers.");
	add(dialect, "max", { x, y, more }, largest, "The largest of the numbers.");
	add(dialect, "isnan", { x }, is_nan, "Whether x is not a number, such as sqrt(-1).");
	dialect.functions.back().result = ValueType::Bool;
	add(dialect, "isinf", { x }, is_inf, "Whether x is infinite.");
	dialect.functions.back().result = ValueType::Bool;
	const size_t first_random = dialect.functions.size();
	add(dialect, "rand", {}, random_unit, "A random number in [0, 1).");
	add(dialect, "rand", { { "max", ParamKind::Number } }, random_below, "A random number in [0, max).");
	add(dialect, "rand", { { "low", ParamKind::Number }, { "high", ParamKind::Number } }, random_between,
			"A random number in [low, high).");
	add(dialect, "p", { { "probability", ParamKind::Number } }, chance, "True with that probability, 0 to 1.");
	dialect.functions.back().result = ValueType::Bool;
	for (size_t i = first_random; i < dialect.functions.size(); ++i) {
		dialect.functions[i].is_pure = false;
	}
}

} // namespace pcg
