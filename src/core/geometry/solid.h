#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

// Where surfaces and volumes lie to each other. Lengths closer than `solid_tolerance` count as contact: shapes that lie less than that apart
// touch, and shapes that reach into each other by less do not overlap.
namespace pcg {

constexpr double solid_tolerance = 1e-4; // metres

struct SolidTriangle {
	glm::dvec3 a{ 0.0 }, b{ 0.0 }, c{ 0.0 };
};

// Triangles of a surface, counter-clockwise seen from outside.
struct Solid {
	std::vector<SolidTriangle> triangles;
	bool is_closed = false;

	// Adds a polygon with holes: loop i owns points [loop_ends[i - 1], loop_ends[i]).
	void add_polygon(std::span<const glm::dvec3> points, std::span<const uint32_t> loop_ends);
};

struct SolidRelation {
	bool is_inside = false; // all of it lies in or on the other
	bool overlaps = false; // part of it lies in the other, or the other in it
	bool touches = false; // overlaps, or their surfaces share an area
};

// Of any surface to a closed one. Without triangles (edges, points) nothing is shared; then use relate_points.
SolidRelation relate(const Solid &surface, const Solid &closed);
// The same of points: on the surface is inside, and only inside overlaps.
SolidRelation relate_points(std::span<const glm::dvec3> points, const Solid &closed);

enum class PointPlace : uint8_t { Outside, Surface, Inside };
PointPlace place_in(const Solid &closed, glm::dvec3 point);

} // namespace pcg
