#pragma once

#include <span>

#include "core/cga/context.h"
#include "core/cga/split_layout.h"

// What the operations of the split family share.
namespace pcg::cga {

struct SplitSizes {
	std::span<const SplitGroup> groups;
	std::span<const BlockEntry *const> entries; // by SplitSize::entry
};

// Sizes of a block, evaluated once, in order. They lie in the context's scratch memory.
SplitSizes split_sizes(Context &context, const Block &block);

// Cuts the current shape along an axis of its scope and runs the bodies of all parts. With `adjusts` their scopes are refitted, else they span the part.
Flow run_split(Context &context, const SplitSizes &sizes, const SplitLayout &layout, int axis, bool adjusts);

} // namespace pcg::cga
