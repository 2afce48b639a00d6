#pragma once

#include <cstdint>
#include <span>

#include "core/geometry/overlay.h"

// Polygons whose edges move in their plane (CGA reference: op_setback, op_offset). Edges count through all loops, edge i of a loop runs from its
// i-th point to the next. Source: the weighted straight skeleton.
namespace pcg {

// What one edge passed over; its first edge is the edge itself. It has a hole where the edge went around one that stands still. An edge has two
// strips only where its strip touches itself in a point.
struct SetbackStrip {
	uint32_t edge = 0;
	Loops2 polygon;
};

// `strips` in order of edges. `rest`: what is left, or the polygon grown; each outline and hole begins with the side that came from its
// lowest edge, the polygon of the lowest edge comes first. Strips and rest share corners to the last bit.
struct Setback {
	SmallVector<SetbackStrip, 4> strips;
	Polygons2 rest;
	bool is_complete = true; // false: the outline crosses itself or is too sharp to grow; nothing was moved and `rest` is the polygon as it was
	bool is_plain = false; // each strip is an edge, then the side of the rest that it became, back; for joined_strips()
};

// Moves each edge inwards by its distance >= 0, metres; an edge with 0 stays. Corners move on the bisector of the two moved lines.
Setback set_back(const Loops2 &polygon, std::span<const double> distances);

// Moves all edges outwards by `distance` > 0 with mitred corners, none of which may be sharper than about 0.1 degrees. The strips look the other way, so
// that the grown polygon and they together are the polygon. Wings that meet close to holes.
Setback grow(const Loops2 &polygon, double distance);

// All strips together, as polygons of their own: wings along the edges that moved.
Polygons2 joined_strips(const Setback &setback);

// Area of an outline less its holes.
double area_of(const Loops2 &polygon);

} // namespace pcg
