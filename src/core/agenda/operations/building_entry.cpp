#include "core/agenda/operations/building_entry.h"

#include "core/agenda/operations/constant_checks.h"

namespace pcg::agenda {

namespace {

std::string_view building_numbers(const World &world) {
	if (world.numbers.buildings == nullptr) {
		return "buildings have the numbers that the city gives them";
	}
	return world.rule_numbers.buildings != nullptr ? "buildings have the ids of the city's file"
												   : "an id of the city's file is below 0 or above 2^53, so rules count buildings from 0 in the order of the file";
}

} // namespace

Flow insert_building_entry(Vm &vm, const Args &args, std::string_view operation, TaskKind kind) {
	GenerationContext *context = writing_context(vm);
	if (context == nullptr) {
		return Flow::Next;
	}
	const BuildingId building = context->building_of(args.number(2));
	if (is_valid(building)) {
		return context->insert(vm, operation, kind, args.number(0), args.number(1), index_of(building));
	}
	if (!require_focus(vm, operation)) {
		return Flow::Stop;
	}
	warn(vm, no_building(operation, args.number(2), building_numbers(context->world())));
	return Flow::Next;
}

} // namespace pcg::agenda
