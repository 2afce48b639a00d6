#pragma once

#include "core/cga/shape.h"

// Tidies geometry without moving its scope (CGA reference, section 6).
namespace pcg::cga {

// What op_cleanupGeometry works on; vertices that lie together are merged in any case.
struct Cleanup {
	bool vertices = false; // takes away vertices in straight lines
	bool edges = false; // joins neighbouring faces of one plane
	bool faces = false; // takes away faces that are there twice or have next to no area
	double tolerance = 0.0; // 0 exact; 1: one metre, 10 degrees, one square metre; linear between
};
void clean_up(Shape &shape, const Cleanup &cleanup, GeometryBuilder &builder, Arena &arena);

// Shading across edges where faces meet at less than this angle, in degrees; 0: none (op_softenNormals, op_setNormals).
void soften_normals(Shape &shape, double angle, Arena &arena);

// Turns faces so that neighbours look to the same side, outwards where they enclose something, else up in the world (op_setNormals: conform).
void conform_normals(Shape &shape, GeometryBuilder &builder, Arena &arena);

// Takes that share of the vertices away, 0 to 1, with as little change as it can; faces that lose no vertex stay as they are (op_reduceGeometry).
void reduce(Shape &shape, double share, GeometryBuilder &builder, Arena &arena);

} // namespace pcg::cga
