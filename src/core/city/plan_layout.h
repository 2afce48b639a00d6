#pragma once

#include "core/city/layout.h"
#include "core/city/street_plan.h"
#include "core/geometry/polygon.h"

namespace pcg {

// Makes everything that lies on the ground from a net of streets: carriageways with crossings at their junctions, pavements, and the lots of each block,
// still without types. Blocks too small for a lot are squares. Nothing, and an error that names the parameters, where streets would overlap.
std::optional<Layout> layout_of_plan(const StreetPlan &plan, const LayoutParameters &parameters, Diagnostics &diagnostics);

// From the plan (x east, y north) to the world.
glm::vec3 to_ground(glm::dvec2 point);
std::vector<glm::vec3> to_ground(std::span<const glm::dvec2> points);
// And back.
Loop2 to_plan(std::span<const glm::vec3> points);

// Sets min and max from the outline, and the tiles.
void frame_layout(Layout &layout);

} // namespace pcg
