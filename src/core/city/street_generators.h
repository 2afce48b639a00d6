#pragma once

#include "core/city/layout.h"
#include "core/city/street_plan.h"

// The nets of streets that layouts are made from, one function a kind. Parameters are within their limits.
namespace pcg {

StreetPlan grid_streets(const LayoutParameters &parameters);
StreetPlan radial_streets(const LayoutParameters &parameters);
StreetPlan grown_streets(const LayoutParameters &parameters);

// A block between the middles of its streets, as parameters want it.
glm::dvec2 block_size(const LayoutParameters &parameters);
float main_width(const LayoutParameters &parameters); // no less than that of other streets
// A radial city's blocks in each ring, from the middle outwards.
std::vector<uint32_t> blocks_by_ring(const LayoutParameters &parameters);

} // namespace pcg
