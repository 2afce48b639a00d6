#pragma once

#include <span>
#include <vector>

#include "core/city/city.h"
#include "core/navigation/nav_mesh.h"
#include "core/navigation/reachability.h"

// From a city to ground for walking: for an engine that bakes it tile by tile, or as a mesh without any engine.
namespace pcg {

// Ground of a tile of the layout, ready to be baked: three corners for each triangle, counter-clockwise seen from above. Nothing stands on them, so
// a baker finds no islands inside of or on top of buildings; what hangs over them above heads is not there at all. All ground within `border`
// metres around the tile is included, so that the baker's own margin does not eat into it. Without carriageways people keep to pavements and
// cross at crossings, which join all blocks; a city without any crossings keeps its carriageways.
std::vector<glm::vec3> tile_faces(const City &city, const Tile &tile, float border, bool has_carriageways = true);

// What a metre costs on each kind of ground, for those who choose their way. The cheapest is 1.
struct GroundCosts {
	float pavement = 1.0f;
	float crossing = 1.1f;
	float street = 4.0f; // carriageways and junctions
	float lot = 1.5f;
};

// Streets, pavements and the free ground of lots as they are, without margins to walls.
NavRegion city_nav_region(const City &city, const GroundCosts &costs = {});
NavMesh city_nav_mesh(const City &city, const GroundCosts &costs = {});

// One warning that counts the entrances that cannot be reached and names the first few; `verdicts` as from reach_of_entrances().
void report_unreachable(const City &city, std::span<const Reach> verdicts, Diagnostics &diagnostics);
// The same of zones; `verdicts` as from reach_of_zones().
void report_unreachable_zones(const City &city, std::span<const Reach> verdicts, Diagnostics &diagnostics);

} // namespace pcg
