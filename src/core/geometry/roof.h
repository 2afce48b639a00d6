#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/geometry/polygon.h"

// Roofs over a polygon with holes, as faces (CGA reference: op_roofHip, op_roofGable, op_roofShed, op_roofPyramid, op_roofRidge). The
// polygon lies in the plane z = 0 of its own frame, the roof rises along z. Lengths in metres, angles in degrees.
namespace pcg {

// Loops as in straight_skeleton(): the outline counter-clockwise, holes clockwise. Edges count through all loops.
using RoofOutline = Loops2;
using RoofLoop = SmallVector<glm::dvec3, 6>;

enum class RoofPart : uint8_t {
	Bottom, // the polygon itself, looking down
	Plane, // sloped
	Gable, // vertical, below a roof plane
};

struct RoofFace {
	RoofPart part = RoofPart::Plane;
	uint32_t edge = 0; // the edge that it stands on; of a Bottom: 0
	// Counter-clockwise seen from outside. Planes and gables begin with their edge (of an overhanging roof: with its eave).
	RoofLoop outline;
	std::vector<RoofLoop> holes; // of a Bottom only
};

using RoofFaces = SmallVector<RoofFace, 6>;

struct Roof {
	RoofFaces faces; // planes and gables in order of edges (of a shed: walls, then the plane), then the bottom
	bool is_complete = true; // false: the outline is not simple; what could be made is there
};

// How steep: an angle from the horizontal in (0, 90), or the height of the highest point.
struct RoofSlope {
	double value = 45.0;
	bool is_height = false;
};

// One plane for each edge along the straight skeleton. `overhang` is measured on the roof's plane, so that eaves drop below z = 0; `is_even`
// levels the ridge to its mean height, which bends planes.
Roof roof_hip(const RoofOutline &outline, RoofSlope slope, double overhang = 0.0, bool is_even = false);

// As a hip roof, but its triangular ends stand upright. `overhang_eaves` as above, `overhang_gables` lengthens the ridge. `edge` >= 0: the
// ridge runs in that edge's direction (convex outlines without holes; `is_even` is ignored then).
Roof roof_gable(const RoofOutline &outline, RoofSlope slope, double overhang_eaves = 0.0, double overhang_gables = 0.0, bool is_even = false, int edge = -1);

// Two planes to one ridge in that direction through the middle of the outline; upright walls follow the outline and its holes.
Roof roof_ridge(const RoofOutline &outline, RoofSlope slope, glm::dvec2 direction = { 1.0, 0.0 });

// One plane that rises from edge `edge` (below 0: counted from the last), upright sides elsewhere; a negative slope falls from there.
Roof roof_shed(const RoofOutline &outline, RoofSlope slope, int edge = 0);

// Triangles to an apex above the mean of the outline's vertices; an angle is that of the first edge's triangle. Holes are left out.
Roof roof_pyramid(const RoofOutline &outline, RoofSlope slope);

// The outline moved outwards by `distance` with mitred corners, as it was if one is too sharp for that, and for each of its edges the edge that it came from.
struct OutlineWithEdges {
	RoofOutline loops;
	std::vector<uint32_t> edges;
};
OutlineWithEdges grow_outline(const RoofOutline &outline, double distance);

} // namespace pcg
