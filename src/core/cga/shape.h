#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

#include "core/cga/geometry.h"
#include "core/cga/look.h"
#include "core/cga/projection.h"
#include "core/cga/scope.h"
#include "core/lang/value.h"

namespace pcg::cga {

// What all shapes of one derivation know of where they come from. The derivation computes in axes parallel to the world's with the origin at
// the initial shape's first vertex, so that cities far from the origin lose no precision.
struct Lot {
	glm::dvec3 origin{ 0.0 }; // of the computation, in world coordinates
	glm::dmat3 object_axes{ 1.0 }; // x along the first edge, y the face's normal
	glm::dmat3 street_axes{ 1.0 }; // z towards the widest street; the object's without streets
	glm::dvec3 center{ 0.0 };
};

// The planes that comp(f) puts through the edges of a face, not worked out before something asks for them (CGA reference, section 7.6).
struct TrimSource {
	const Geometry *geometry = nullptr; // of the shape that was split, in its scope's coordinates
	Frame frame; // of that scope
	uint64_t id = 0; // different for each split
	bool keeps_axes = false; // comp(f, noAlign)
	const TrimSource *outer = nullptr; // planes that the split shape brought along, those of its face `outer_face`
	uint32_t outer_face = 0;
};

// A shape in the tree of a derivation as another pass recorded it: `node` is the last one on its path that the recorded tree has too.
struct TreePlace {
	uint32_t node = 0;
	bool is_beyond = false; // the path goes on where the recorded tree does not
};

// The way to a shape in the tree of shapes, from its end (CGA reference: func_getTreeKey).
struct KeyNode {
	const KeyNode *parent = nullptr;
	uint32_t index = 0; // among the children of its parent
};

// Where and what a shape is (CGA reference, section 2). Copied at every rule call: plain data; what is big lies in the arena and is shared.
struct Shape {
	const Geometry *geometry = nullptr; // nullptr: a scope without geometry
	// Geometry to scope: offset + scale * point.
	glm::dvec3 geometry_offset{ 0.0 };
	glm::dvec3 geometry_scale{ 1.0 };
	const Frame *pivot = nullptr;
	glm::dvec3 position{ 0.0 }; // scope.t, in the pivot
	glm::dmat3 rotation{ 1.0 }; // scope.r
	glm::dvec3 size{ 0.0 }; // scope.s
	const Look *look = nullptr;
	const Projections *projections = nullptr; // nullptr: none is set up
	Value *attributes = nullptr; // changed only by copying
	uint64_t seed = 0;
	int32_t object = -1; // index of the object it belongs to
	uint32_t depth = 0;
	uint32_t split_index = 0, split_total = 0;
	uint32_t comp_index = 0, comp_total = 0;
	uint32_t comp_selector = no_symbol; // in Program::texts; no_symbol: what is written at comp_entry
	uint32_t comp_entry = no_symbol; // in Program::entries
	const TrimSource *trim = nullptr;
	uint32_t trim_face = 0;
	bool trims_vertically = true, trims_horizontally = false; // trim.vertical, trim.horizontal
	const KeyNode *key = nullptr; // nullptr: the first shape
	TreePlace tree; // only where rules ask about other shapes

	Frame frame() const { return *pivot * Frame{ rotation, position }; }
	glm::dvec3 to_scope(glm::dvec3 point) const { return geometry_offset + geometry_scale * point; }
};

// New geometry in coordinates of the current scope; the scope becomes its bounding box (position moves, axes stay).
void set_geometry(Shape &shape, const Geometry *geometry);
// The scope as bounding box of the geometry, negative sizes stay negative; without geometry nothing happens.
void refit(Shape &shape);
// The geometry in scope coordinates, its mapping applied: for operations that look at every point. nullptr without geometry.
const Geometry *baked(const Shape &shape, Arena &arena);
// Brings normals of the geometry into the scope: where it is mirrored they are turned around, where it is flattened there are none.
glm::dmat3 normal_matrix(const Shape &shape);
// Turns the scope's axes without moving anything in the world: `axes` are the new axes in scope coordinates. The scope is refitted.
void turn_scope(Shape &shape, const glm::dmat3 &axes, GeometryBuilder &builder, Arena &arena);

} // namespace pcg::cga
