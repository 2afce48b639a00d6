#include "core/cga/context.h"
#include "core/cga/operations/operations.h"

// NIL, report, print, label (CGA reference, sections 1.4, 6 and 7.7).
namespace pcg::cga {

namespace {

Flow nil(Vm &vm, const Args &) {
	Context::of(vm).mark_replaced();
	return Flow::Next;
}

Flow report(Vm &vm, const Args &args) {
	report_value(vm, args);
	return Flow::Next;
}

Flow print(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	context.model.add_print(value_text(args[0]), context.shape.depth);
	return Flow::Next;
}

Flow label(Vm &vm, const Args &args) {
	if (!args[0].is_text() || args[0].text->view.empty()) {
		vm.warn("empty-label", "a label without a name finds nothing", "queries ask for labels by name: label(\"block\")");
		return Flow::Next;
	}
	Context::of(vm).record_occluder(hash_text(args[0].text->view));
	return Flow::Next;
}

Flow inlined(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	const auto entries = context.vm.entries(*args.block);
	return entries.empty() ? Flow::Next : context.run_inline(entries[0].body, Context::Merge(args[0].word));
}

} // namespace

void report_value(Vm &vm, const Args &args) {
	const Value &value = args[1];
	if (!value.is_number() && !value.is_bool() && !value.is_text()) {
		vm.warn("report-type", "only numbers, truth values and texts can be reported; this is left out", "report the elements of an array one by one");
		return;
	}
	Context &context = Context::of(vm);
	context.model.add_report(args[0].is_text() ? *args[0].text : Text(), value, context.shape.depth);
}

void add_flow_operations(Dialect &dialect) {
	using enum ParamKind;
	auto &operations = dialect.operations;
	operations.push_back({ "NIL", {}, BlockKind::None, nil, "Drops the shape." });
	operations.push_back({ "report", { { "key", Text }, { "value", Any } }, BlockKind::None, report,
			"Adds a number, a truth value or a text to the model's list of reports: count, sum, average, smallest and largest for each key and type. Truth "
			"values count as 0 and 1; the sum and the average of texts are the one that came most often." });
	operations.push_back({ "inline", { { "strategy", Word, "append unify recompose" } }, BlockKind::Bodies, inlined,
			"Runs a rule or operations at once; the shapes that come out are put together and become the current shape: as they are, as one body, or with "
			"common vertices where they touch." });
	operations.push_back({ "print", { { "value", Any } }, BlockKind::None, print, "Writes a value to the model's list of messages." });
	operations.push_back({ "label", { { "name", Text } }, BlockKind::None, label,
			"Makes the shape, as it is now, known to queries that ask for this label: inside, overlaps, touches, minimumDistance, contextCount, contextCompare." });
}

} // namespace pcg::cga
