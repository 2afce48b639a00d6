#include <utility>

#include "core/agenda/generation_context.h"
#include "core/agenda/operations/constant_checks.h"
#include "core/agenda/operations/operations.h"

namespace pcg::agenda {

namespace {

Flow floating_task(Vm &vm, const Args &args) {
	GenerationContext *context = writing_context(vm);
	if (context == nullptr) {
		return Flow::Next;
	}
	if (!require_focus(vm, "floatingTask")) {
		return Flow::Stop;
	}
	const double duration = args.number(0);
	const double priority = args.number_or(2, 0.0);
	if (std::optional<CallProblem> problem = duration_problem(duration, priority)) {
		warn(vm, std::move(*problem));
		return Flow::Next;
	}
	FloatingTask task;
	task.rule = RuleId(args[1].index);
	task.duration_ms = int32_t(Duration::seconds(duration).ms);
	task.priority = float(priority);
	task.days = context->days();
	context->add_floating_task(vm, task);
	return vm.has_failed() ? Flow::Stop : Flow::Next;
}

} // namespace

void add_floating_task(Dialect &dialect) {
	dialect.operations.push_back({ "floatingTask",
			{ { "duration", ParamKind::Number }, { "rule", ParamKind::Rule }, { "priority", ParamKind::Number, {}, true } }, BlockKind::None,
			floating_task,
			"Adds a task to the pool of the focused person: the rule, run for at most the duration (seconds) when a floating slot has room for "
			"it. The largest priority goes first; it is 0 unless told.",
			Phase::Generation, nullptr, check_duration });
}

} // namespace pcg::agenda
