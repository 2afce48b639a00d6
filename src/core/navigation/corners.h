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

class Corners {
public:
	Corners() = default;
	// `margin` as in NavMeshOptions.
	Corners(const NavMesh &mesh, float margin);

	size_t count() const { return _corners.size(); }
	glm::vec3 position(uint32_t corner) const { return _corners[corner].position; }
	// Those at the ends of a link; no_corner where no walk bends.
	uint32_t left(uint32_t link) const { return _ends[2 * link]; }
	uint32_t right(uint32_t link) const { return _ends[2 * link + 1]; }
	// All that touch the corner.
	std::span<const uint32_t> polygons(uint32_t corner) const {
		return { _polygons.data() + _corners[corner].first_polygon, _corners[corner].polygon_count };
	}
	// Whether a shortest walk may come straight from `from` and go on in another direction, around the wall. Where that is uncertain, it may.
	bool is_bend(uint32_t corner, glm::vec3 from) const;

private:
	// Directions of the plan in which the walls run away from the corner, of length 1; both 0 if there is no single wall.
	struct Walls {
		float first_x = 0.0f, first_z = 0.0f, second_x = 0.0f, second_z = 0.0f;
	};
	struct Corner {
		glm::vec3 position{ 0.0f };
		Walls walls;
		uint32_t first_polygon = 0;
		uint32_t polygon_count = 0;
	};
	struct Finder;

	std::vector<Corner> _corners;
	std::vector<uint32_t> _ends; // left and right of each link
	std::vector<uint32_t> _polygons;
};

} // namespace pcg
