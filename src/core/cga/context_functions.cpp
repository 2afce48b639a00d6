#include "core/cga/context.h"
#include "core/cga/operations/operations.h"
#include "core/lang/opcode.h"

// Context queries: what stands around the current shape (CGA reference: func_occlusion, cga_context).
namespace pcg::cga {

namespace {

uint64_t label_of(const Args &args, size_t i) {
	return i < args.count() && args[i].is_text() && !args[i].text->view.empty() ? hash_text(args[i].text->view) : 0;
}

QueryTarget target_of(const Args &args) {
	return args.count() > 0 ? QueryTarget(args[0].word) : QueryTarget::All;
}

template <OcclusionKind kind> Value occlusion(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	return Value::of(context.surroundings.occlusion(kind, target_of(args), label_of(args, 1), context.shape));
}

Value minimum_distance(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	return Value::of(context.surroundings.minimum_distance(target_of(args), label_of(args, 1), context.shape));
}

Value context_count(Vm &vm, const Args &args) {
	return Value::of(Context::of(vm).surroundings.count(target_of(args), label_of(args, 1)));
}

Value context_compare(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	return Value::of(context.surroundings.rank(target_of(args), label_of(args, 1), Comparison(args[2].word), context.shape));
}

// Marks a function as a query: FunctionSpec::user points to one of these.
constexpr bool is_occlusion[] = { false, true };

// The target if it stands as a constant before the call, and each argument behind it is one instruction; else anything.
QueryTarget constant_target(const Program &program, size_t call, size_t count) {
	if (count == 0 || call < count) {
		return QueryTarget::All;
	}
	for (size_t i = call - count; i < call; ++i) {
		const OpCode code = program.code[i].code;
		if (code != OpCode::PushConstant && (i == call - count || code != OpCode::LoadAttribute)) {
			return QueryTarget::All;
		}
	}
	const Value &value = program.constants[program.code[call - count].operand];
	return value.type == ValueType::Word && value.word <= uint32_t(QueryTarget::All) ? QueryTarget(value.word) : QueryTarget::All;
}

} // namespace

ContextUse context_use(const Program &program) {
	ContextUse use;
	for (size_t i = 0; i < program.code.size(); ++i) {
		const Instruction &instruction = program.code[i];
		if (instruction.code != OpCode::CallFunction) {
			continue;
		}
		const void *mark = program.dialect->functions[instruction.extra].user;
		if (mark != &is_occlusion[0] && mark != &is_occlusion[1]) {
			continue;
		}
		const QueryTarget target = constant_target(program, i, instruction.count);
		use.intra |= target != QueryTarget::Inter;
		use.inter_occlusion |= target != QueryTarget::Intra && mark == &is_occlusion[1];
		use.inter_labels |= target != QueryTarget::Intra && mark == &is_occlusion[0];
	}
	return use;
}

void add_context_functions(Dialect &dialect) {
	using enum ParamKind;
	auto &functions = dialect.functions;
	constexpr std::string_view targets = "intra inter all";
	const ParamSpec maybe_target = { "target", Word, targets, true }, target = { "target", Word, targets };
	const ParamSpec maybe_label = { "label", Text, {}, true }, label = { "label", Text };
	const auto add_occlusion = [&](std::string_view name, FunctionHandler handler, std::string_view help) {
		functions.push_back({ name, { maybe_target, maybe_label }, ValueType::Bool, handler, help, false, &is_occlusion[1] });
	};
	add_occlusion("inside", occlusion<OcclusionKind::Inside>,
			"Whether the shape lies in or on one closed shape: of its own initial shape (intra), of those close by (inter) or both (all, if nothing is said). With "
			"a label only shapes that label() recorded count. Shapes that it was made of, or that were made of it, do not.");
	add_occlusion("overlaps", occlusion<OcclusionKind::Overlaps>, "Whether part of the shape lies in a closed shape, or that in it; see inside.");
	add_occlusion("touches", occlusion<OcclusionKind::Touches>, "Whether the shape overlaps a closed shape or shares an area of its surface; see inside.");
	const auto add_query = [&](std::string_view name, std::vector<ParamSpec> params, FunctionHandler handler, std::string_view help) {
		functions.push_back({ name, std::move(params), ValueType::Number, handler, help, false, &is_occlusion[0] });
	};
	add_query("minimumDistance", { target, label }, minimum_distance, "Metres from the scope to the nearest scope of a shape with that label; infinite without one.");
	add_query("contextCount", { target, label }, context_count, "How many shapes with that label there are.");
	add_query("contextCompare",
			{ target, label,
					{ "comparison", Word,
							"world.northernmost world.southernmost world.easternmost world.westernmost world.highest world.lowest area.largest area.smallest" } },
			context_compare, "The shape's rank among those with that label, from 0; equal ones share the lowest rank.");
}

} // namespace pcg::cga
