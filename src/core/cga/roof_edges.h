#pragma once

#include "core/cga/geometry.h"

namespace pcg::cga {

// One slope over a level floor between upright walls, y up. CityEngine makes no hips, valleys and ridges there, and no level trim planes (CGA
// changelog 2016.0), so that the slope stands alone.
bool is_shed_roof(const Geometry &geometry);

} // namespace pcg::cga
