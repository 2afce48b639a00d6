#pragma once

#include <cstdint>

#include "core/geometry/polygon.h"

// A polygon as a hole in a wide frame, so that its edges move outwards where those of the frame stand still.
namespace pcg {

struct Inverted {
	static constexpr uint32_t frame_edges = 4; // the first ones
	static constexpr uint32_t no_source = UINT32_MAX;

	Loops2 loops;
	SmallVector<uint32_t, 8> sources; // edge of the polygon that each edge is, run backwards; no_source for the frame's

	bool is_frame(const SmallVector<uint32_t, 6> &edges) const;
	// How fast each edge moves; the frame's stand still.
	SmallVector<double, 8> speeds(double speed) const;
};

// False: a corner is sharper than about a tenth of a degree, so that it would run away more than a thousand times as far as the edges move.
bool can_grow(const Loops2 &polygon);

// The frame is so wide that no corner of an outline that can grow reaches it while the edges move by `distance`.
Inverted invert(const Loops2 &polygon, double distance);

} // namespace pcg
