#include "core/agenda/generation_context.h"
#include "core/agenda/operations/constant_checks.h"
#include "core/agenda/operations/operations.h"

namespace pcg::agenda {

namespace {

Flow delayed_rule(Vm &vm, const Args &args) {
	GenerationContext *context = writing_context(vm);
	if (context == nullptr) {
		return Flow::Next;
	}
	return context->insert(vm, "delayedRule", TaskKind::DelayedRule, args.number(0), args.number(1), args[2].index);
}

} // namespace

void add_delayed_rule(Dialect &dialect) {
	dialect.operations.push_back({ "delayedRule", { { "t0", ParamKind::Number }, { "t1", ParamKind::Number }, { "rule", ParamKind::Rule } },
			BlockKind::None, delayed_rule,
			"At t0 (seconds of the day) the focused person begins the rule, which may wait and walk; over when it ends or at t1.",
			Phase::Generation, nullptr, check_times });
}

} // namespace pcg::agenda
