#pragma once

#include "core/cga/geometry.h"
#include "core/geometry/overlay.h"

// A face in its own plane, for operations that cut outlines, and the way back.
namespace pcg::cga {

class FlatFace {
public:
	// In the face's own metres, or as it is seen along the axis of the coordinates that its normal is nearest to.
	enum class View : uint8_t { Own, AlongAxis };
	FlatFace(const Geometry &geometry, uint32_t face, View view = View::Own);

	// The outline counter-clockwise, from its first corner; x along its first edge, or along one of the axes.
	const Loops2 &loops() const { return _loops; }
	uint32_t edge_count() const { return _edge_count; }
	const GeometryFace &face() const { return _geometry->faces[_face]; }

	const Geometry &geometry() const { return *_geometry; }
	// Any point of the plane, seen in the face's own metres.
	glm::dvec2 flat(glm::dvec3 point) const;

	// Adds a polygon in the face's plane as a face of the same material. Corners of the face come back to the last bit and with what they carry;
	// what new ones carry lies between, if the builder began with this face's geometry.
	void add(GeometryBuilder &builder, const Loops2 &polygon, FaceTag tag = FaceTag::None) const;
	void add(GeometryBuilder &builder, const Loop2 &outline, FaceTag tag = FaceTag::None) const;

private:
	void add_point(GeometryBuilder &builder, glm::dvec2 point) const;
	void add_loop(GeometryBuilder &builder, const Loop2 &loop) const;

	const Geometry *_geometry;
	uint32_t _face;
	uint32_t _edge_count = 0;
	glm::dvec3 _origin{ 0.0 };
	glm::dvec3 _x{ 0.0 }, _y{ 0.0 }; // of the plane, for one unit of the flat coordinates
	Loops2 _loops;
};

} // namespace pcg::cga
