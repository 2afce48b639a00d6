#pragma once

#include <cstdint>

#include "core/cga/shape.h"

// Other axes for the scope while the geometry stays where it is in the world (CGA reference, section 3).
namespace pcg::cga {

// The scope gets these axes (of the derivation's coordinates), fitted to the geometry; the pivot goes to its origin, so that its t and r are 0.
void align_scope(Shape &shape, const glm::dmat3 &axes, GeometryBuilder &builder, Arena &arena);

enum class PivotOrder : uint8_t { Xyz, Yzx, Zxy };

// The pivot goes to a corner of the scope and looks into its box; the box stays (op_setPivot). Corners: 0 the origin, 1 +x, 2 +x+z, 3 +z, 4 to 7
// the same at the other end of y. Yzx: x along what would be z, y along x, z along y; Zxy: x along y, y along z, z along x.
void set_pivot(Shape &shape, PivotOrder order, uint32_t corner, GeometryBuilder &builder, Arena &arena);

// y to a direction (unit, in scope coordinates), x as it was as far as it can.
void turn_scope_to(Shape &shape, glm::dvec3 up, GeometryBuilder &builder, Arena &arena);

// The scope's origin goes to the other end of the axis, its size changes sign (op_mirrorScope).
void mirror_scope(Shape &shape, int axis);

// Mirrors the geometry inside of the scope; its faces still look outwards and begin with the same edge (op_mirror).
void mirror_geometry(Shape &shape, const bool (&axes)[3], GeometryBuilder &builder, Arena &arena);

// Which face and which edge give the axes (op_alignScopeToGeometry).
struct FaceChoice {
	enum class Kind : uint8_t { Index, Lowest, Largest, Any } kind = Kind::Index;
	double index = 0.0; // counts from the end if negative
};
struct EdgeChoice {
	enum class Kind : uint8_t { Index, Lowest, Longest, Auto } kind = Kind::Index; // Auto: the lowest, of equally low ones the longest
	double index = 0.0;
};

// x along the edge, y or z the face's normal. Geometry without faces: along its first edge, with the axis as it was.
void align_scope_to_geometry(Shape &shape, bool is_z_up, FaceChoice face, EdgeChoice edge, GeometryBuilder &builder, Arena &arena);

// Turns the scope about its third axis until `longer` and `shorter` span the smallest rectangle around the geometry (op_alignScopeToGeometryBBox).
void align_scope_to_rectangle(Shape &shape, int longer, int shorter, GeometryBuilder &builder, Arena &arena);

} // namespace pcg::cga
