#pragma once

#include <cstdint>
#include <span>

#include "core/cga/arena.h"
#include "core/lang/value.h"

// Where the parts of a split lie (CGA reference: op_split; section 4.2).
namespace pcg::cga {

struct SplitSize {
	double value = 0.0; // metres; share of the length if Relative; weight if Flexible
	SizeKind kind = SizeKind::Absolute;
	uint32_t entry = 0; // what the caller knows it by
};

// Sizes that stand side by side: once, or repeated.
struct SplitGroup {
	std::span<const SplitSize> sizes;
	bool is_repeated = false;
};

struct SplitPart {
	uint32_t entry = 0;
	double from = 0.0, to = 0.0; // metres from the start, from < to
};

struct SplitLayout {
	std::span<SplitPart> parts; // in order, longer than 1e-6 m each
	bool is_clamped = false; // there would have been more than `max_parts`
};

// `length` >= 0. Sizes that are not finite or negative count as 0. Flexible parts share what is left; repeats take the count that stretches
// the flexible parts least: the smallest |stretch - 1|. The parts lie in the arena.
SplitLayout lay_out_split(std::span<const SplitGroup> groups, double length, uint32_t max_parts, Arena &arena);

} // namespace pcg::cga
