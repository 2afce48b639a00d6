#include "core/agenda/functions/functions.h"

namespace pcg::agenda {

namespace {

Value home(Vm &vm) { return Value::of(context_of(vm).number_of(context_of(vm).household().home)); }
Value household_id(Vm &vm) { return Value::of(context_of(vm).number_of(context_of(vm).household_id())); }
Value person_id(Vm &vm) { return Value::of(context_of(vm).number_of(context_of(vm).focus())); }

Value age(Vm &vm) {
	if (!require_focus(vm, "age")) {
		return {};
	}
	const Context &context = context_of(vm);
	return Value::of(double(context.population().person(context.focus()).age));
}

Value gender(Vm &vm) {
	if (!require_focus(vm, "gender")) {
		return {};
	}
	const Context &context = context_of(vm);
	return Value::of(context.population().person(context.focus()).gender == Gender::Woman);
}

Value day(Vm &vm) { return context_of(vm).day(vm); }
Value time(Vm &vm) { return context_of(vm).time(vm); }

} // namespace

void add_variables(Dialect &dialect) {
	dialect.variables.push_back({ "home", ValueType::Number, home, "The building where the household lives." });
	dialect.variables.push_back({ "gender", ValueType::Bool, gender, "true: the focused person is a woman; false: a man." });
	dialect.variables.push_back({ "age", ValueType::Number, age, "Years of the focused person." });
	dialect.variables.push_back({ "person.id", ValueType::Number, person_id, "The focused person, -1 when nobody is focused." });
	dialect.variables.push_back({ "household.id", ValueType::Number, household_id, "The household whose rules run." });
	dialect.variables.push_back({ "day", ValueType::Number, day,
			"The day of the week, 0 Monday .. 6 Sunday. While agendas are written, rules that read it run once for each day." });
	dialect.variables.push_back({ "time", ValueType::Number, time, "Seconds since 0h of the day, in delayed rules only. A rule may set(time, ..) to a value of its own, as the paper's does.", true });
}

} // namespace pcg::agenda
