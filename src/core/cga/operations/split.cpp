#include <algorithm>
#include <cmath>
#include <string>

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

class SizeCollector {
public:
	SizeCollector(Context &context, const Block &block) : _context(context) {
		count(block, block.is_repeated);
		_sizes = context.scratch.allocate<SplitSize>(_size_count);
		_entries = context.scratch.allocate<const BlockEntry *>(_size_count);
		_groups = context.scratch.allocate<SplitGroup>(_group_count);
		_size_count = _group_count = 0;
	}

	SplitSizes run(const Block &block) {
		begin_group(block.is_repeated);
		collect(block, block.is_repeated);
		return { { _groups, _group_count }, { _entries, _size_count } };
	}

private:
	// Plain grouping; a repeat inside of a repeat goes with it.
	static bool is_inner(const BlockEntry &entry, bool is_repeated) { return entry.kind == BlockEntry::Kind::Group || is_repeated; }
	const Block &nested(const BlockEntry &entry) const { return _context.vm.program().blocks[entry.block]; }

	void count(const Block &block, bool is_repeated) {
		++_group_count;
		for (const BlockEntry &entry : _context.vm.entries(block)) {
			if (entry.kind == BlockEntry::Kind::Body) {
				++_size_count;
			} else {
				count(nested(entry), is_repeated || !is_inner(entry, is_repeated));
				++_group_count;
			}
		}
	}

	// Adds the sizes of a block to the last group.
	void collect(const Block &block, bool is_repeated) {
		for (const BlockEntry &entry : _context.vm.entries(block)) {
			if (entry.kind == BlockEntry::Kind::Body) {
				add(entry);
			} else if (is_inner(entry, is_repeated)) {
				collect(nested(entry), is_repeated);
			} else {
				begin_group(true);
				collect(nested(entry), true);
				begin_group(false);
			}
		}
	}

	void begin_group(bool is_repeated) { _groups[_group_count++] = { { _sizes + _size_count, 0 }, is_repeated }; }

	void add(const BlockEntry &entry) {
		_sizes[_size_count] = evaluate_size(_context, entry, uint32_t(_size_count));
		_entries[_size_count++] = &entry;
		SplitGroup &group = _groups[_group_count - 1];
		group.sizes = { group.sizes.data(), group.sizes.size() + 1 };
	}

	Context &_context;
	SplitSize *_sizes = nullptr;
	const BlockEntry **_entries = nullptr;
	SplitGroup *_groups = nullptr;
	size_t _size_count = 0, _group_count = 0;
};

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
		} else if (geometry.inserted == &geometry) {
			child.geometry = context.arena.make(geometry);
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
	return SizeCollector(context, block).run(block);
}

Flow run_split(Context &context, const SplitSizes &sizes, const SplitLayout &layout, int axis, bool adjusts) {
	if (layout.is_clamped) {
		context.vm.warn("too-many-parts", "this split repeats more than " + std::to_string(context.limits().max_repeats) + " times and was cut short",
				"its sizes are in metres; use a larger one, or raise the limit");
	}
	Context::Children children(context);
	uint32_t index = 0;
	for (const SplitPart &part : layout.parts) {
		Shape child = children.parent();
		child.split_index = index++;
		child.split_total = uint32_t(layout.parts.size());
		if (make_part(context, part, axis, adjusts, child) && children.run(child, sizes.entries[part.entry]->body) != Flow::Next) {
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
	const ArenaScope scope(context.scratch);
	const SplitSizes sizes = split_sizes(context, *args.block);
	const double length = std::abs(context.shape.size[axis]);
	return run_split(context, sizes, lay_out_split(sizes.groups, length, context.limits().max_repeats, context.scratch), axis, adjusts);
}

} // namespace

void add_split_operations(Dialect &dialect) {
	using enum ParamKind;
	dialect.operations.push_back({ "split", { { "axis", Word, "x y z" }, { "mode", Word, "adjust noAdjust", true } }, BlockKind::Sizes, split,
			"Cuts the shape along an axis of its scope: 3 metres, '0.5 of the scope, ~1 share of what is left; { .. }* repeats. noAdjust keeps the "
			"scope's size on the other axes." });
}

} // namespace pcg::cga
