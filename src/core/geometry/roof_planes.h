#pragma once

#include "core/geometry/roof.h"

namespace pcg {

// The face under a roof, which looks down: the outline the other way around, with the same first edge.
RoofFace roof_bottom(const RoofOutline &outline);

// One outline with its holes on the positive side of the line normal . p = offset; concave ones fall into pieces. Points on the line count as cut away.
std::vector<RoofOutline> cut_outline(const RoofOutline &outline, glm::dvec2 normal, double offset);

// Two planes to a ridge in that direction through the middle of the outline; overhangs are for convex outlines.
Roof roof_along(const RoofOutline &outline, RoofSlope slope, glm::dvec2 direction, double overhang_eaves = 0.0, double overhang_gables = 0.0);

} // namespace pcg
