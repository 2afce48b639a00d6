#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/navigation/nav_mesh.h"

// Which polygons touch, and where.
namespace pcg {

// A side of a polygon, the polygon to its left seen from above.
struct NavEdge {
	glm::vec3 from{ 0.0f };
	glm::vec3 to{ 0.0f };
	uint32_t polygon = no_polygon;
	// Names of the two corners; equal names of one region are one vertex. Corners of different regions never share a name.
	uint32_t from_name = 0;
	uint32_t to_name = 0;
};

// A way from one polygon into another, as NavLink.
struct NavGap {
	uint32_t source = no_polygon;
	uint32_t target = no_polygon;
	glm::vec3 left{ 0.0f };
	glm::vec3 right{ 0.0f };
};

// Both directions of every way. Edges between the same two vertices are joined first; those left over where they run side by side.
std::vector<NavGap> find_links(std::span<const NavEdge> edges, const NavMeshOptions &options);

} // namespace pcg
