#include "core/agenda/dialect.h"

#include "core/agenda/functions/functions.h"
#include "core/agenda/operations/operations.h"

namespace pcg::agenda {

Dialect make_dialect() {
	Dialect dialect;
	dialect.name = "pcg";
	dialect.title = "PCG agendas";
	dialect.locals = Dialect::Locals::Dynamic;
	dialect.rule_calls = Dialect::RuleCalls::Run;
	dialect.unknown_names = Dialect::UnknownNames::Error;
	dialect.has_time_units = true;
	add_annotations(dialect);
	add_variables(dialect);
	add_math_functions(dialect);
	add_building_functions(dialect);
	add_object_functions(dialect);
	add_member_functions(dialect);

	add_members(dialect);
	add_days(dialect);
	add_task_names(dialect);
	add_stay_inside(dialect);
	add_go_to_building(dialect);
	add_accompany(dialect);
	add_delayed_rule(dialect);
	add_floating_slot(dialect);
	add_floating_task(dialect);
	return dialect;
}

} // namespace pcg::agenda
