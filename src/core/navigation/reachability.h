#pragma once

#include <vector>

#include "core/navigation/nav_mesh.h"
#include "core/semantics/city_model.h"

// Which doors and zones people can get to.
namespace pcg {

enum class Reach : uint8_t {
	Reachable,
	Island, // ground that is not connected with the rest of the city
	OffMesh, // no walkable ground near enough
	Removed,
};

// By EntranceId. The rest of the city is the largest connected ground. `reach` as in NavMeshPaths.
std::vector<Reach> reach_of_entrances(const CityModel &city, const NavMesh &mesh, float reach = 2.0f);

// By ZoneId: whether they get to its middle, to a corner or to its outline, as far as people look for a way in (NavMeshPaths::nearest_zone).
std::vector<Reach> reach_of_zones(const CityModel &city, const NavMesh &mesh, float reach = 2.0f);

} // namespace pcg
