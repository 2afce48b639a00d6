#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/cga/shape.h"
#include "core/geometry/bounds_tree.h"
#include "core/geometry/convex_body.h"
#include "core/geometry/solid.h"

// What context queries answer from: shapes of a finished derivation (CGA reference: cga_context).
namespace pcg::cga {

// One shape that queries may find, in world coordinates.
struct Occluder {
	glm::dvec3 low{ 0.0 }, high{ 0.0 }; // bounds of its geometry
	Frame frame; // of its scope
	glm::dvec3 size{ 0.0 };
	double area = 0.0;
	uint64_t label = 0; // hash; 0 = none
	uint32_t node = 0; // in the tree
	Solid solid; // without triangles unless it is closed
	ConvexBody body; // of the solid, once the occluders are finished
};

// The tree of a derivation: which shape was made of which, by the numbers of the children. Nodes are added as they are made, parents first.
class ShapeTree {
public:
	// The next child of a node.
	uint32_t add(uint32_t parent);
	void finish();

	TreePlace child(TreePlace parent, uint32_t child_index) const;
	// Whether one is the other, or was made of it.
	bool is_related(TreePlace asking, uint32_t node) const;

private:
	bool contains(uint32_t ancestor, uint32_t node) const { return _enter[ancestor] <= _enter[node] && _enter[node] < _leave[ancestor]; }

	std::vector<uint32_t> _parents{ 0 }; // node 0 is the initial shape
	std::vector<uint32_t> _first_child; // offsets into _children
	std::vector<uint32_t> _children;
	std::vector<uint32_t> _enter, _leave; // numbers in depth-first order
};

// The faces of a shape in world coordinates; the box around them if there are more than Occluders::max_faces. It has geometry.
Solid world_solid(const Shape &shape, glm::dvec3 origin);
Bounds3 world_bounds(const Shape &shape, glm::dvec3 origin);

// Filled by one derivation, then finished and never changed.
class Occluders {
public:
	// More faces than that: the box around them stands in for the shape.
	static constexpr uint32_t max_faces = 4096;

	// `origin`: of the derivation's coordinates in the world. Shapes without geometry count with their scope alone.
	void add(const Shape &shape, glm::dvec3 origin, uint64_t label);
	void finish();
	void set_bounds(glm::dvec3 low, glm::dvec3 high);

	ShapeTree tree;
	std::span<const Occluder> list() const { return _list; }
	// Of the initial shape.
	glm::dvec3 low() const { return _low; }
	glm::dvec3 high() const { return _high; }
	// Calls `visit(occluder)` for closed shapes that may meet a box, until it returns true; whether it did.
	template <typename Visit> bool any_solid(glm::dvec3 low, glm::dvec3 high, Visit visit) const {
		return _tree.any(low, high, [&](uint32_t index) { return visit(_list[_solids[index]]); });
	}

private:
	std::vector<Occluder> _list;
	std::vector<uint32_t> _solids; // of _list
	BoundsTree _tree; // of _solids
	glm::dvec3 _low{ 0.0 }, _high{ 0.0 };
};

} // namespace pcg::cga
