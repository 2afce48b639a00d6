#pragma once

#include <vector>

#include "core/navigation/nav_mesh.h"
#include "core/semantics/city_model.h"

// Which doors people can get to.
namespace pcg {

enum class Reach : uint8_t {
	Reachable,
	OffMesh, // no walkable ground near enough
	Island, // ground that is not connected with the rest of the city
	Removed,
};

// By EntranceId. The rest of the city is the largest connected ground. `reach` as in NavMeshPaths.
std::vector<Reach> reach_of_entrances(const CityModel &city, const NavMesh &mesh, float reach = 2.0f);

} // namespace pcg
