#include "core/agenda/generation_context.h"
#include "core/agenda/operations/building_entry.h"
#include "core/agenda/operations/constant_checks.h"
#include "core/agenda/operations/operations.h"

namespace pcg::agenda {

namespace {

Flow stay_inside(Vm &vm, const Args &args) { return insert_building_entry(vm, args, "stayInside", TaskKind::StayInside); }

} // namespace

void add_stay_inside(Dialect &dialect) {
	dialect.operations.push_back({ "stayInside",
			{ { "t0", ParamKind::Number }, { "t1", ParamKind::Number }, { "building", ParamKind::Number } }, BlockKind::None, stay_inside,
			"The focused person is inside the building from t0 to t1 (seconds of the day); if it is elsewhere at t0 it walks there first.",
			Phase::Generation, nullptr, check_building_entry });
}

} // namespace pcg::agenda
