#include <cmath>
#include <string>

#include "core/cga/context.h"
#include "core/cga/functions/functions.h"
#include "core/cga/operations/operations.h"

// print, report, isNull, getTreeKey, clamp (CGA reference, sections 1.4, 7.7 and 8.1).
namespace pcg::cga {

namespace {

Value print(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	context.model.add_print(value_text(args[0]), context.shape.depth);
	return args[0];
}

Value report(Vm &vm, const Args &args) {
	report_value(vm, args);
	return args[1];
}

// CityEngine's missing values: not a number, and the text of one private character.
Value is_null(Vm &, const Args &args) {
	return Value::of((args[0].is_number() && std::isnan(args[0].number)) || (args[0].is_text() && args[0].text->view == "\xEE\x80\x80"));
}

Value tree_key(Vm &vm, const Args &) { return Value::of(vm.make_text(Context::of(vm).tree_key())); }

Value clamp(Vm &, const Args &args) { return Value::of(std::fmin(std::fmax(args.number(0), args.number(1)), args.number(2))); }

} // namespace

void add_flow_functions(Dialect &dialect) {
	using enum ParamKind;
	auto &functions = dialect.functions;
	functions.push_back({ "print", { { "value", Any } }, ValueType::Void, print, "The value, which is also written to the model's list of messages." });
	functions.push_back({ "report", { { "key", Text }, { "value", Any } }, ValueType::Void, report,
			"The value, which is also added to the model's list of reports." });
	functions.push_back({ "isNull", { { "value", Any } }, ValueType::Bool, is_null, "Whether a value is missing: a number that is none, or CityEngine's mark for texts." });
	functions.push_back({ "getTreeKey", {}, ValueType::Text, tree_key, "The way from the first shape to this one as a list of numbers: \"0;2;1;\"." });
	functions.push_back({ "clamp", { { "value", Number }, { "low", Number }, { "high", Number } }, ValueType::Number, clamp,
			"The value, or the limit that it goes beyond.", true });
}

} // namespace pcg::cga
