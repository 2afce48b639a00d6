#include "core/agenda/generation_context.h"
#include "core/agenda/operations/building_entry.h"
#include "core/agenda/operations/constant_checks.h"
#include "core/agenda/operations/operations.h"

namespace pcg::agenda {

namespace {

Flow go_to_building(Vm &vm, const Args &args) { return insert_building_entry(vm, args, "goToBuilding", TaskKind::GoToBuilding); }

} // namespace

void add_go_to_building(Dialect &dialect) {
	dialect.operations.push_back({ "goToBuilding",
			{ { "t0", ParamKind::Number }, { "t1", ParamKind::Number }, { "building", ParamKind::Number } }, BlockKind::None, go_to_building,
			"The focused person leaves for the building at t0 (seconds of the day), enters it on arrival and stays until t1.",
			Phase::Generation, nullptr, check_building_entry });
}

} // namespace pcg::agenda
