#include "core/agenda/operations/building_entry.h"

#include <string>

namespace pcg::agenda {

Flow insert_building_entry(Vm &vm, const Args &args, std::string_view operation, TaskKind kind) {
	GenerationContext *context = writing_context(vm);
	if (context == nullptr) {
		return Flow::Next;
	}
	const BuildingId building = to_id<BuildingId>(args.number(2), context->city().buildings().size());
	if (is_valid(building)) {
		return context->insert(vm, operation, kind, args.number(0), args.number(1), index_of(building));
	}
	if (!require_focus(vm, operation)) {
		return Flow::Stop;
	}
	vm.warn("no-building", "'" + std::string(operation) + "' is given no building, so nothing is inserted",
			"a building that is not found is -1: test it with isValid(..) first");
	return Flow::Next;
}

} // namespace pcg::agenda
