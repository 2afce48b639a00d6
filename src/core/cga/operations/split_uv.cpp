#include <string>

#include "core/cga/operations/operations.h"
#include "core/cga/operations/split_parts.h"
#include "core/cga/uv.h"

// split(u|v, uvSpace|unitSpace, uvSet) { size : body | .. }* (CGA reference, section 4.2).
namespace pcg::cga {

namespace {

struct UvCut {
	size_t set = 0;
	int axis = 0;
	double low = 0.0, high = 0.0; // of the coordinates
	double per_unit = 1.0; // what one unit of the sizes is in the texture
};

// False: nothing of the shape lies in the part.
bool make_part(Context &context, const UvCut &cut, const SplitPart &part, Shape &child) {
	const double from = cut.low + part.from * cut.per_unit, to = cut.low + part.to * cut.per_unit;
	const double margin = 1e-9 * (cut.high - cut.low);
	const Geometry *result = child.geometry;
	if (from > cut.low + margin) {
		result = context.clipper.clip_uv(*result, cut.set, cut.axis, from, true, context.arena);
	}
	if (result != nullptr && to < cut.high - margin) {
		result = context.clipper.clip_uv(*result, cut.set, cut.axis, to, false, context.arena);
	}
	child.geometry = result;
	refit(child);
	return result != nullptr;
}

Flow run_parts(Context &context, const UvCut &cut, const SplitSizes &sizes) {
	const SplitLayout layout = lay_out_split(sizes.groups, (cut.high - cut.low) / cut.per_unit, context.limits().max_repeats, context.scratch);
	if (layout.is_clamped) {
		context.vm.warn("too-many-parts", "this split repeats more than " + std::to_string(context.limits().max_repeats) + " times and was cut short",
				"with unitSpace its sizes are in metres, with uvSpace in the texture's units; use a larger one, or raise the limit");
	}
	uint32_t index = 0;
	for (const SplitPart &part : layout.parts) {
		Shape child = context.shape;
		child.split_index = index++;
		child.split_total = uint32_t(layout.parts.size());
		if (make_part(context, cut, part, child) && context.run_child(child, sizes.entries[part.entry]->body) != Flow::Next) {
			return Flow::Stop;
		}
	}
	return Flow::Next;
}

// A set that is missing is set 0, as it is for pictures: CityEngine's streets have coordinates from their ends in sets 1 and 2, those of files do not.
size_t set_to_cut(Vm &vm, const Geometry &geometry, size_t set, UvRange &range) {
	range = uv_range(geometry, set);
	if (!range.is_empty) {
		return set;
	}
	UvRange first = set > 0 ? uv_range(geometry, 0) : range;
	vm.warn("no-uvs", "there are no texture coordinates in set " + std::to_string(set) + " to cut along; " +
					(first.is_empty ? "this split makes nothing" : "those of set 0 are taken"),
			"projectUV() makes some; streets and assets bring their own");
	range = first;
	return 0;
}

Flow split_uv(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	context.mark_replaced();
	const int wanted = uv_set_of(context, args[2]);
	const Geometry *geometry = context.shape.geometry;
	if (wanted < 0 || geometry == nullptr || args.block == nullptr) {
		return Flow::Next;
	}
	UvRange range;
	const size_t set = set_to_cut(vm, *geometry, size_t(wanted), range);
	if (range.is_empty) {
		return Flow::Next;
	}
	UvCut cut = { set, int(args[0].word), 0.0, 0.0, 1.0 };
	cut.low = range.low[cut.axis];
	cut.high = range.high[cut.axis];
	if (args[1].word == 1) {
		const double metres = uv_stretch(context.shape, cut.set)[cut.axis];
		cut.per_unit = metres > 0.0 ? 1.0 / metres : 1.0;
	}
	const ArenaScope scope(context.scratch);
	return run_parts(context, cut, split_sizes(context, *args.block));
}

} // namespace

void add_uv_split_operations(Dialect &dialect) {
	using enum ParamKind;
	dialect.operations.push_back({ "split", { { "axis", Word, "u v" }, { "space", Word, "uvSpace unitSpace" }, { "uvSet", Number } }, BlockKind::Sizes, split_uv,
			"Cuts the faces along lines of equal u or v of a set of texture coordinates; sizes are in the texture's units or in metres on the surface. For "
			"streets, which bring u along and v across." });
}

} // namespace pcg::cga
