#include "core/agenda/generation_context.h"
#include "core/agenda/operations/operations.h"

namespace pcg::agenda {

namespace {

Flow run_bodies(Vm &vm, const Args &args) {
	for (const BlockEntry &entry : vm.entries(*args.block)) {
		if (vm.run_body(entry.body) == Flow::Stop) {
			return Flow::Stop;
		}
	}
	return Flow::Next;
}

Flow task(Vm &vm, const Args &args) {
	GenerationContext *context = writing_context(vm);
	if (context == nullptr) {
		return Flow::Next;
	}
	const uint16_t outer = context->entry_name();
	context->set_entry_name(context->number_of(vm, args[0].text->view));
	const Flow flow = vm.has_failed() ? Flow::Stop : run_bodies(vm, args);
	context->set_entry_name(outer);
	return flow;
}

Flow require_task(Vm &vm, const Args &args, bool is_after) {
	GenerationContext *context = writing_context(vm);
	if (context == nullptr) {
		return Flow::Next;
	}
	const uint8_t outer = context->requirement();
	Requirement requirement;
	requirement.name = context->number_of(vm, args[0].text->view);
	requirement.is_after = is_after;
	requirement.outer = outer;
	context->set_requirement(context->number_of(vm, requirement));
	const Flow flow = vm.has_failed() ? Flow::Stop : run_bodies(vm, args);
	context->set_requirement(outer);
	return flow;
}

Flow requires_task(Vm &vm, const Args &args) { return require_task(vm, args, false); }
Flow after_task(Vm &vm, const Args &args) { return require_task(vm, args, true); }

} // namespace

void add_task_names(Dialect &dialect) {
	const ParamSpec name{ "name", ParamKind::Text };
	dialect.operations.push_back({ "task", { name }, BlockKind::Bodies, task,
			"task(\"bring\") { actions }: entries written inside get this name, by which others can require them." });
	dialect.operations.push_back({ "requires", { name }, BlockKind::Bodies, requires_task,
			"requires(\"bring\") { actions }: entries written inside need an entry of this name that starts on the same day. If newer entries "
			"took that away, or its end, they are dropped with it, and that is told. Whoever has entries of the name needs its own, everybody "
			"else anybody's in the household." });
	dialect.operations.push_back({ "after", { name }, BlockKind::Bodies, after_task,
			"after(\"bring\") { actions }: as requires, but the entry of this name has to be over when those inside begin, at most 24 hours ago." });
}

} // namespace pcg::agenda
