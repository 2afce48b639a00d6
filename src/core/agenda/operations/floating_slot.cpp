#include "core/agenda/generation_context.h"
#include "core/agenda/operations/constant_checks.h"
#include "core/agenda/operations/operations.h"

namespace pcg::agenda {

namespace {

Flow floating_slot(Vm &vm, const Args &args) {
	GenerationContext *context = writing_context(vm);
	if (context == nullptr) {
		return Flow::Next;
	}
	return context->insert(vm, "floatingSlot", TaskKind::FloatingSlot, args.number(0), args.number(1), 0xFFFFFFFF);
}

} // namespace

void add_floating_slot(Dialect &dialect) {
	dialect.operations.push_back({ "floatingSlot", { { "t0", ParamKind::Number }, { "t1", ParamKind::Number } }, BlockKind::None, floating_slot,
			"Free time of the focused person from t0 to t1 (seconds of the day), filled from its floating tasks.",
			Phase::Generation, nullptr, check_times });
}

} // namespace pcg::agenda
