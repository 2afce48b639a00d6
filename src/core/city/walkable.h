#pragma once

#include <span>
#include <vector>

#include "core/city/city.h"
#include "core/navigation/nav_mesh.h"
#include "core/navigation/reachability.h"

// From a city to ground for walking: for an engine that bakes it block by block, or as a mesh without any engine.
namespace pcg {

// Ground around one block, ready to be baked. Nothing stands on these triangles, so a baker finds no islands inside of or on top of buildings;
// what hangs over them above heads is not there at all.
struct BlockSource {
	std::vector<glm::vec3> triangles; // three corners each, counter-clockwise seen from above
	glm::vec3 min{ 0.0f }, max{ 0.0f }; // what the baked region must cover: the block's cell. Cells meet without gaps
};

// All ground within `border` metres around the block's cell is included, so that the baker's own margin does not eat into the cell. Without
// carriageways people keep to pavements and cross at crossings, which join all blocks.
BlockSource block_source_faces(const City &city, BlockId block, float border, bool has_carriageways = true);

// What a metre costs on each kind of ground, for those who choose their way. The cheapest is 1.
struct GroundCosts {
	float pavement = 1.0f;
	float crossing = 1.1f;
	float street = 4.0f;
	float lot = 1.5f;
};

// Streets, pavements and the free ground of lots as they are, without margins to walls.
NavRegion city_nav_region(const City &city, const GroundCosts &costs = {});
NavMesh city_nav_mesh(const City &city, const GroundCosts &costs = {});

// One warning that counts the entrances that cannot be reached and names the first few; `verdicts` as from reach_of_entrances().
void report_unreachable(const City &city, std::span<const Reach> verdicts, Diagnostics &diagnostics);

} // namespace pcg
