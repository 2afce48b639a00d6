#pragma once

#include <cstdint>
#include <span>

#include "core/geometry/polygon.h"

// The weighted straight skeleton of a polygon with holes: every edge moves inwards at its own speed, and what it sweeps is its face. Hip
// roofs are the faces raised by time, setbacks are the faces swept until a distance, insets the front that is left (Aichholzer and
// Aurenhammer 1996; weights as in Eppstein and Erickson 1999).
namespace pcg {

struct SkeletonVertex {
	glm::dvec2 position{ 0.0 };
	double time = 0.0; // when the front passed here: a height once multiplied by the slope
};

// What edge `edge` swept. Counter-clockwise; the first two vertices are the edge itself. One edge may have several faces only where its face
// touches itself in a point.
struct SkeletonFace {
	uint32_t edge = 0;
	SmallVector<SkeletonVertex, 6> outline;
};

// A loop of the front that is left when the time ran out; counter-clockwise, holes clockwise. edges[i] moved the side from points[i] to the next.
struct SkeletonFront {
	Loop2 points;
	SmallVector<uint32_t, 6> edges;
};

struct StraightSkeleton {
	SmallVector<SkeletonFace, 4> faces; // in order of edges
	SmallVector<SkeletonFront, 1> fronts; // empty if everything was swept
	bool is_complete = true; // false: the outline was not simple or events did not end; what was found is still returned
};

// `loops`: the outline counter-clockwise, then holes clockwise; edges count through all loops, edge i of a loop runs from its i-th point to
// the next. `speeds`: metres of inward movement per unit of time, >= 0, one for each edge; empty means 1 for all. The front stops at
// `max_time`; infinity sweeps all. Cost grows with the square of the edges for each event, which suits buildings.
StraightSkeleton straight_skeleton(const Loops2 &loops, std::span<const double> speeds, double max_time);

// An edge that stands still until `start` and then moves inwards at `speed` > 0; from max_time on it never does.
struct LateEdge {
	double start = 0.0;
	double speed = 1.0;
};

// The same with edges that begin one after the other, and faces that stand upright. SkeletonFace::edge counts 0 .. n-1 what each edge passed standing
// still, n .. 2n-1 what it swept then, both beginning with the edge, from 2n on upright steps between sides of one line that start apart.
StraightSkeleton late_skeleton(const Loops2 &loops, std::span<const LateEdge> edges, double max_time);

} // namespace pcg
