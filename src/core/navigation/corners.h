#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

// Where shortest walks bend: at the ends of gaps between polygons, around walls that jut out, and where one kind of ground ends and another begins.
namespace pcg {

class NavMesh;

constexpr uint32_t no_corner = 0xFFFFFFFF;
// Metres. What is so near to a polygon touches it.
constexpr float touch = 0.01f;

// Adds to `polygons`, which touch the point, all others that do, as far as gaps lead there. True if it is uncertain whether that is all: gaps within
// `margin` metres that do not touch the point.
bool add_touching(const NavMesh &mesh, glm::vec3 point, float margin, std::vector<uint32_t> &polygons);

// All polygons that touch each corner: for those who look out of corners while the graph is made.
class CornerPolygons {
public:
	std::span<const uint32_t> of(uint32_t corner) const { return { _polygons.data() + _first[corner], _first[corner + 1] - _first[corner] }; }
	void add(std::span<const uint32_t> polygons) { // of the next corner
		_polygons.insert(_polygons.end(), polygons.begin(), polygons.end());
		_first.push_back(uint32_t(_polygons.size()));
	}

private:
	std::vector<uint32_t> _polygons;
	std::vector<uint32_t> _first = { 0 }; // one more than corners
};

class Corners {
public:
	Corners() = default;
	// `margin` as in NavMeshOptions. Adds all corners to `polygons`, and to `order` all points of the mesh as they are to be numbered from then on: those at
	// corners first, so that a corner's number is that of its point.
	Corners(const NavMesh &mesh, float margin, CornerPolygons &polygons, std::vector<uint32_t> &order);

	size_t count() const { return _walls.size(); }
	// The one at a point of the mesh; no_corner where no walk bends.
	uint32_t at(uint32_t point) const {
		return point < _count ? point : (point - _count < _beside.size() ? _beside[point - _count] : no_corner);
	}
	// Whether a shortest walk that comes straight along `way` may go on in another direction, around the wall. Where that is uncertain, it may.
	bool is_bend(uint32_t corner, glm::vec3 way) const;

private:
	// Directions of the plan in which the walls run away from the corner, `wall_length` long; both 0 if there is no single wall.
	struct Walls {
		int16_t first_x = 0, first_z = 0, second_x = 0, second_z = 0;
	};
	struct Finder;

	uint32_t _count = 0;
	std::vector<Walls> _walls; // by corner
	std::vector<uint32_t> _beside; // corners at the points after those, which lie within a centimetre of them
};

} // namespace pcg
