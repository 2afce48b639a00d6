#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "core/cga/shape.h"

namespace pcg::cga {

// The upright prism that a zone fills, in the derivation's coordinates.
struct ZonePrism {
	std::vector<glm::dvec3> outline; // all at the bottom's height, counter-clockwise from above
	double height = 0.0;
};

// Spans the scope (paper, "Extensions to CGA"). A scope flat in one axis is raised along it by `flat_height`; where that is a single polygon
// that lies flat, its outline is kept instead of the rectangle around it.
ZonePrism zone_prism(const Shape &shape, double flat_height);

} // namespace pcg::cga
