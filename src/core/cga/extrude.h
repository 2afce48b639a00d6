#pragma once

#include "core/cga/shape.h"

// Prisms over faces (CGA reference: op_extrude).
namespace pcg::cga {

enum class ExtrudeDirection : uint8_t {
	FaceNormal,
	VertexNormal, // faces stay together: their vertices move along the mean of the normals around them
	WorldUpFlatTop, // height over the lowest point; at least up to the highest
	WorldX,
	WorldY,
	WorldZ,
	ScopeX,
	ScopeY,
	ScopeZ,
};

// Replaces the shape's faces by prisms `height` metres high: bottom, top, one quad for each edge, in this order; faces that are raised alike
// (of one plane, or in one direction) have no walls between them. Edges become quads. `keeps_axes` is the reading of the paper's listings: the scope is not turned, and what a negative height hollows out
// shows its inside (a door's recess is seen from the street). Otherwise y turns to the direction, and the scope's y is negative where
// the height is. False: nothing was done, the direction lies in the face.
bool extrude(Shape &shape, ExtrudeDirection direction, double height, bool keeps_axes, GeometryBuilder &builder, Arena &arena);

// Triangles from the outline of the first face to a point `height` above its centre of gravity, closed by that face (op_taper).
bool taper(Shape &shape, double height, GeometryBuilder &builder, Arena &arena);

// All faces run the other way around; first edges stay first (op_reverseNormals).
void reverse_normals(Shape &shape, GeometryBuilder &builder, Arena &arena);

} // namespace pcg::cga
