#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/navigation/nav_mesh.h"
#include "core/navigation/sight.h"

// The nearest of some doors, for all of the ground at once: one search from all of them labels every corner with the one that is cheapest to walk to.
namespace pcg {

constexpr uint32_t no_door = 0xFFFFFFFF;

struct Door {
	NavPoint point; // where one steps onto the ground
	float step = 0.0f; // metres from there to the door
	uint32_t id = no_door;
};

struct NearDoor {
	float cost = INFINITY; // of the walk; where all ground costs 1 a metre, its length
	uint32_t door = no_door;

	friend auto operator<=>(const NearDoor &, const NearDoor &) = default; // of doors equally near the lower id comes first
};

// The mesh must outlive it.
class NearestDoors {
public:
	NearestDoors(const NavMesh &mesh, std::span<const Door> doors);

	// Exact on the graph of corners, so at most as far as the way that PathFinder finds to any of the doors. `sight` of the same mesh. May be asked from
	// several threads at once, with a sight each.
	NearDoor ask(Sight &sight, const NavPoint &from) const;

private:
	void search(Sight &sight);
	std::span<const uint32_t> doors_at(uint32_t polygon) const;

	const NavMesh *_mesh;
	std::vector<Door> _doors; // that are on the mesh
	std::vector<NearDoor> _labels; // by corner
	std::vector<uint32_t> _at_polygon, _first_at_polygon; // indices of doors that touch each polygon; one more than polygons
};

} // namespace pcg
