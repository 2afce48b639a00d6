#pragma once

#include "core/geometry/roof.h"

namespace pcg {

// Two planes to a ridge in `direction` through the middle of the outline's extent across it, with upright walls below; what roof_ridge and
// roof_gable with an edge share.
Roof roof_along(const RoofOutline &outline, RoofSlope slope, glm::dvec2 direction);

} // namespace pcg
