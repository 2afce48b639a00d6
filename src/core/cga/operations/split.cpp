#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <glm/common.hpp>

#include "core/cga/context.h"
#include "core/cga/operations/operations.h"
#include "core/cga/operations/split_parts.h"
#include "core/cga/primitive_uvs.h"

// split(axis) { size : body | .. }* (CGA reference, section 4.2).
namespace pcg::cga {

namespace {

SplitSize evaluate_size(Context &context, const BlockEntry &entry, uint32_t index) {
	if (entry.head == Chunk::None) { // of files before 2015.0
		return { 1.0, SizeKind::Flexible, index };
	}
	const Value value = context.vm.evaluate(entry.head);
	return { context.finite(value), value.size_kind, index };
}

void collect(Context &context, const Block &block, bool is_repeated, SplitSizes &sizes);

void collect_nested(Context &context, const BlockEntry &entry, bool is_repeated, SplitSizes &sizes) {
	const Block &block = context.vm.program().blocks[entry.block];
	if (entry.kind == BlockEntry::Kind::Group || is_repeated) { // plain grouping; a repeat inside of a repeat goes with it
		collect(context, block, is_repeated, sizes);
		return;
	}
	sizes.groups.push_back({ {}, true });
	collect(context, block, true, sizes);
	sizes.groups.push_back({ {}, false });
}

// Adds the sizes of a block to the last group.
void collect(Context &context, const Block &block, bool is_repeated, SplitSizes &sizes) {
	for (const BlockEntry &entry : context.vm.entries(block)) {
		if (entry.kind != BlockEntry::Kind::Body) {
			collect_nested(context, entry, is_repeated, sizes);
			continue;
		}
		sizes.groups.back().sizes.push_back(evaluate_size(context, entry, uint32_t(sizes.entries.size())));
		sizes.entries.push_back(&entry);
	}
}

// What the corners of a block carry, from share `a` to share `b` of its extent in the scope.
void cut_corners(Context &context, Shape &child, int axis, double a, double b) {
	const bool is_mirrored = child.geometry_scale[axis] < 0.0;
	Geometry *copy = context.arena.make(*child.geometry);
	copy->corners = cut_block_corners(*child.geometry, axis, is_mirrored ? 1.0 - b : a, is_mirrored ? 1.0 - a : b, context.arena);
	child.geometry = copy;
}

// From `low` to `high` in scope coordinates. False: nothing of the geometry lies there.
bool cut(Context &context, Shape &child, int axis, double low, double high) {
	const Geometry &geometry = *child.geometry;
	const double a = child.to_scope(geometry.low)[axis], b = child.to_scope(geometry.high)[axis];
	const double from = std::min(a, b), to = std::max(a, b);
	const double margin = 1e-9 * (1.0 + to - from);
	if (low <= from + margin && high >= to - margin) {
		return true;
	}
	if (low >= to - margin || high <= from + margin) {
		return false;
	}
	if (geometry.is_block) {
		const double factor = (std::min(high, to) - std::max(low, from)) / (to - from);
		if (geometry.corners != nullptr) {
			cut_corners(context, child, axis, (std::max(low, from) - from) / (to - from), (std::min(high, to) - from) / (to - from));
		}
		child.geometry_offset[axis] = std::max(low, from) + (child.geometry_offset[axis] - from) * factor;
		child.geometry_scale[axis] *= factor;
		return true;
	}
	glm::dvec3 normal(0.0);
	normal[axis] = child.geometry_scale[axis] > 0.0 ? 1.0 : -1.0;
	const auto offset = [&](double at) { return normal[axis] * (at - child.geometry_offset[axis]) / child.geometry_scale[axis]; };
	const Geometry *result = child.geometry;
	if (low > from + margin) {
		result = context.clipper.clip(*result, { normal, offset(low) }, context.arena);
	}
	if (result != nullptr && high < to - margin) {
		result = context.clipper.clip(*result, { -normal, -offset(high) }, context.arena);
	}
	child.geometry = result;
	return result != nullptr;
}

// False: nothing of the shape lies in the part.
bool make_part(Context &context, const SplitPart &part, int axis, bool adjusts, Shape &child) {
	const bool is_negative = child.size[axis] < 0.0;
	const double low = is_negative ? -part.to : part.from, high = is_negative ? -part.from : part.to;
	if (!cut(context, child, axis, low, high)) {
		return false;
	}
	if (adjusts) {
		refit(child);
		return true;
	}
	const double origin = is_negative ? high : low;
	glm::dvec3 shift(0.0);
	shift[axis] = origin;
	child.geometry_offset[axis] -= origin;
	child.position += child.rotation * shift;
	child.size[axis] = is_negative ? low - high : high - low;
	return true;
}

} // namespace

SplitSizes split_sizes(Context &context, const Block &block) {
	SplitSizes sizes;
	sizes.groups.push_back({ {}, block.is_repeated });
	collect(context, block, block.is_repeated, sizes);
	return sizes;
}

Flow run_split(Context &context, const SplitSizes &sizes, const SplitLayout &layout, int axis, bool adjusts) {
	if (layout.is_clamped) {
		context.vm.warn("too-many-parts", "this split repeats more than " + std::to_string(context.limits().max_repeats) + " times and was cut short",
				"its sizes are in metres; use a larger one, or raise the limit");
	}
	uint32_t index = 0;
	for (const SplitPart &part : layout.parts) {
		Shape child = context.shape;
		child.split_index = index++;
		child.split_total = uint32_t(layout.parts.size());
		if (make_part(context, part, axis, adjusts, child) && context.run_child(child, sizes.entries[part.entry]->body) != Flow::Next) {
			return Flow::Stop;
		}
	}
	return Flow::Next;
}

namespace {

Flow split(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	context.mark_replaced();
	const int axis = int(args[0].word);
	const bool adjusts = args.count() < 2 || args[1].word == 0;
	if (context.shape.geometry == nullptr || args.block == nullptr) {
		return Flow::Next;
	}
	const SplitSizes sizes = split_sizes(context, *args.block);
	const double length = std::abs(context.shape.size[axis]);
	return run_split(context, sizes, lay_out_split(sizes.groups, length, context.limits().max_repeats), axis, adjusts);
}

} // namespace

void add_split_operations(Dialect &dialect) {
	using enum ParamKind;
	dialect.operations.push_back({ "split", { { "axis", Word, "x y z" }, { "mode", Word, "adjust noAdjust", true } }, BlockKind::Sizes, split,
			"Cuts the shape along an axis of its scope: 3 metres, '0.5 of the scope, ~1 share of what is left; { .. }* repeats. noAdjust keeps the "
			"scope's size on the other axes." });
}

} // namespace pcg::cga
