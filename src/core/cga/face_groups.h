#pragma once

#include <cstdint>
#include <vector>

#include "core/cga/shape.h"

// Polygons by numbered vertices, and the joining of neighbours of one plane.
namespace pcg::cga {

// Faces whose corners are numbered vertices. A corner remembers where it comes from in the geometry.
struct IndexedFaces {
	struct Corner {
		uint32_t vertex = 0;
		uint32_t source = 0; // corner of the geometry
	};
	struct Face {
		std::vector<std::vector<Corner>> loops; // the first is the outline; none: the face is gone
		uint32_t source = 0; // face of the geometry
	};
	std::vector<glm::dvec3> vertices;
	std::vector<Face> faces;
};

// Vertices nearer than `distance` become one, where the first of them is; loops lose what becomes too short.
IndexedFaces index_faces(const Geometry &geometry, double distance);

// Joins neighbours whose normals differ by less than `angle` (degrees) from the first face of a set, have one material and the same texture
// coordinates along the common edge. The first edge of the set's first face stays first where it survives.
void join_coplanar(const Geometry &geometry, IndexedFaces &indexed, double angle);

// The faces become the geometry of a shape whose scope stays; `geometry` is what they were made of, in scope coordinates.
void put_faces(Shape &shape, const Geometry &geometry, const IndexedFaces &indexed, GeometryBuilder &builder, Arena &arena);

glm::dvec3 normal_of(const IndexedFaces &indexed, const IndexedFaces::Face &face);
double area_of(const IndexedFaces &indexed, const IndexedFaces::Face &face);

} // namespace pcg::cga
