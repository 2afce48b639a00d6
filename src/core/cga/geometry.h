#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/cga/arena.h"

// The polygons of a shape: immutable, in the arena, shared by all shapes that only move, turn or scale them.
namespace pcg::cga {

// What an operation said about a face that later selectors ask for (CGA reference, section 4.1).
enum class FaceTag : uint8_t { None, Inside, Border };

struct GeometryFace {
	uint32_t first_loop = 0;
	uint16_t loop_count = 1; // the first is the outline, the others are holes
	FaceTag tag = FaceTag::None;
	uint16_t material = 0; // 0 = the shape's own, else 1 + index in the derivation's list of inserted materials
};

// Corners are not shared between faces; equal corners of neighbouring faces are equal to the last bit, and that is how neighbours find each
// other. The first edge of each face means something: scopes and roofs begin there.
struct Geometry {
	const glm::dvec3 *points = nullptr;
	const uint32_t *loop_ends = nullptr;
	const GeometryFace *faces = nullptr;
	uint32_t point_count = 0;
	uint32_t loop_count = 0;
	uint32_t face_count = 0;
	glm::dvec3 low{ 0.0 }, high{ 0.0 }; // bounds
	bool is_closed = false; // the surface of a volume: cuts are capped
	// One rectangle or one box that fills its bounds: a cut of it is the same geometry, scaled.
	bool is_block = false;

	uint32_t first_point(uint32_t loop) const { return loop == 0 ? 0 : loop_ends[loop - 1]; }
	std::span<const glm::dvec3> loop(uint32_t index) const {
		return { points + first_point(index), loop_ends[index] - first_point(index) };
	}
	std::span<const glm::dvec3> outline(const GeometryFace &face) const { return loop(face.first_loop); }
	uint32_t face_point_count(const GeometryFace &face) const {
		return loop_ends[face.first_loop + face.loop_count - 1] - first_point(face.first_loop);
	}
};

// Where geometry grows before its size is known; used again and again.
class GeometryBuilder {
public:
	void clear();
	void add_point(glm::dvec3 point) { _points.push_back(point); }
	// Ends a loop of the points added since the last one. Equal neighbours are merged; false and nothing added if fewer than `least` remain.
	bool end_loop(size_t least = 3);
	bool add_loop(std::span<const glm::dvec3> loop, size_t least = 3) {
		_points.insert(_points.end(), loop.begin(), loop.end());
		return end_loop(least);
	}
	// Ends a face of the loops added since the last one; none of them: no face.
	void end_face(FaceTag tag = FaceTag::None, uint16_t material = 0);
	void add_face(const Geometry &source, const GeometryFace &face);
	void add_quad(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::dvec3 d, FaceTag tag = FaceTag::None);

	bool is_empty() const { return _faces.empty(); }
	size_t face_count() const { return _faces.size(); }
	// Copies what was added into the arena. nullptr if there is no face.
	const Geometry *finish(Arena &arena, bool is_closed) const;

private:
	std::vector<glm::dvec3> _points;
	std::vector<uint32_t> _loop_ends;
	std::vector<GeometryFace> _faces;
	uint32_t _face_first_loop = 0;
};

// Newell normal of the face's outline, unit.
glm::dvec3 face_normal(const Geometry &geometry, const GeometryFace &face);

} // namespace pcg::cga
