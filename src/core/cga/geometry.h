#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/cga/arena.h"
#include "core/geometry/material.h"

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

// What corners carry beside their place; only geometry with textures or smooth shading has it.
struct CornerData {
	// One for each corner; nullptr: there is no such set. Corners that have no coordinates (of caps, of new walls) hold no_uv().
	const glm::dvec2 *uvs[uv_set_count] = {};
	const glm::dvec3 *normals = nullptr; // unit, or zero where the face is flat; nullptr: all are flat
	uint32_t set_end = 0; // sets from here on are missing: most geometry has only the first

	void put(size_t set, const glm::dvec2 *values) {
		uvs[set] = values;
		set_end = set < set_end ? set_end : uint32_t(set) + 1;
	}
};
glm::dvec2 no_uv();
inline bool has_uv(glm::dvec2 uv) { return uv.x == uv.x; }

// Corners are not shared between faces; equal corners of neighbouring faces are equal to the last bit, and that is how neighbours find each
// other. The first edge of each face means something: scopes and roofs begin there.
struct Geometry {
	const glm::dvec3 *points = nullptr;
	const uint32_t *loop_ends = nullptr;
	const GeometryFace *faces = nullptr;
	const CornerData *corners = nullptr; // nullptr: no texture coordinates, flat shading
	uint32_t point_count = 0;
	uint32_t loop_count = 0;
	uint32_t face_count = 0;
	glm::dvec3 low{ 0.0 }, high{ 0.0 }; // bounds
	bool is_closed = false; // the surface of a volume: cuts are capped
	// One rectangle or one box that fills its bounds, without corner data: a cut of it is the same geometry, scaled.
	bool is_block = false;
	bool is_instance = false; // a model from a file: it and copies of it
	const Geometry *inserted = nullptr; // itself, if it is a model or a built-in body as it was inserted; a copy of it was changed

	uint32_t first_point(uint32_t loop) const { return loop == 0 ? 0 : loop_ends[loop - 1]; }
	std::span<const glm::dvec3> loop(uint32_t index) const {
		return { points + first_point(index), loop_ends[index] - first_point(index) };
	}
	// nullptr: the set is missing.
	const glm::dvec2 *uvs(size_t set) const { return corners != nullptr ? corners->uvs[set] : nullptr; }
	std::span<const glm::dvec3> outline(const GeometryFace &face) const { return loop(face.first_loop); }
	uint32_t face_point_count(const GeometryFace &face) const {
		return loop_ends[face.first_loop + face.loop_count - 1] - first_point(face.first_loop);
	}
};

// Where a new corner comes from in the geometry that an operation works on: what that one carries is taken along. b == none: corner a itself;
// b == in_face: within face a, by mean value coordinates; else `share` of the way from corner a to corner b.
struct CornerOrigin {
	static constexpr uint32_t none = UINT32_MAX, in_face = UINT32_MAX - 1;
	uint32_t a = none, b = none;
	double share = 0.0;
};

// Where geometry grows before its size is known; used again and again.
class GeometryBuilder {
public:
	// Nothing is there, and new corners carry nothing.
	void clear();
	// The same, but corners added with an origin in `source` carry what it carries. Costs nothing if it carries nothing. The source lives until
	// finish(). `turn` brings normals into the new coordinates.
	void begin(const Geometry &source);
	void begin(const Geometry &source, const glm::dmat3 &turn);
	bool keeps_origins() const { return _source != nullptr; }

	void add_point(glm::dvec3 point) { _points.push_back(point); }
	void add_point(glm::dvec3 point, CornerOrigin origin) {
		_points.push_back(point);
		if (_source != nullptr) {
			note_origin(origin);
		}
	}
	void add_corner(glm::dvec3 point, uint32_t corner) { add_point(point, { corner }); }
	void add_between(glm::dvec3 point, uint32_t a, uint32_t b, double share) { add_point(point, { a, b, share }); }
	void add_inside(glm::dvec3 point, uint32_t face) { add_point(point, { face, CornerOrigin::in_face }); }
	// Ends a loop of the points added since the last one. Equal neighbours are merged; false and nothing added if fewer than `least` remain.
	bool end_loop(size_t least = 3);
	bool add_loop(std::span<const glm::dvec3> loop, size_t least = 3) {
		_points.insert(_points.end(), loop.begin(), loop.end());
		return end_loop(least);
	}
	// `origins` as long as the loop, or empty.
	bool add_loop(std::span<const glm::dvec3> loop, std::span<const CornerOrigin> origins);
	// A loop of the source as it is.
	bool add_loop(const Geometry &source, uint32_t loop);
	// Ends a face of the loops added since the last one; none of them: no face.
	void end_face(FaceTag tag = FaceTag::None, uint16_t material = 0);
	// With what its corners carry, if `source` is the one that the builder began with.
	void add_face(const Geometry &source, const GeometryFace &face);
	void add_quad(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::dvec3 d, FaceTag tag = FaceTag::None);

	bool is_empty() const { return _faces.empty(); }
	size_t face_count() const { return _faces.size(); }
	// Copies what was added into the arena. nullptr if there is no face.
	const Geometry *finish(Arena &arena, bool is_closed) const;

private:
	void note_origin(CornerOrigin origin); // of the point added last
	void add_points(const Geometry &source, uint32_t first, uint32_t count);
	// Of the loop that begins at this point: neighbours that are equal, the last and the first too.
	bool has_doubles(size_t first) const;
	bool merge_doubles(size_t first, size_t least);
	void merge_origins(size_t first);

	std::vector<glm::dvec3> _points;
	std::vector<CornerOrigin> _origins; // as long as _points up to the last that has one
	std::vector<uint32_t> _loop_ends;
	std::vector<GeometryFace> _faces;
	uint32_t _face_first_loop = 0;
	const Geometry *_source = nullptr;
	glm::dmat3 _turn{ 1.0 };
};

// One face without holes and without corner data. The points lie in the arena, and neighbours differ.
Geometry *make_polygon(std::span<const glm::dvec3> points, FaceTag tag, uint16_t material, Arena &arena);

// Newell normal of the face's outline, unit.
glm::dvec3 face_normal(const Geometry &geometry, const GeometryFace &face);

// The same geometry with other texture coordinates in one set: one for each corner, in the arena; nullptr takes the set away.
const Geometry *with_uvs(const Geometry &geometry, size_t set, const glm::dvec2 *uvs, Arena &arena);

} // namespace pcg::cga
