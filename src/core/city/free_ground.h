#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "core/cga/derivation.h"
#include "core/city/layout.h"

// Where one can walk on a lot that has been built on.
namespace pcg {

struct FreeGroundOptions {
	float cell = 0.25f; // metres; how exactly outlines of buildings are followed
	// Whatever has a part between these heights over the lot stands in the way: steps below do not, balconies above do not.
	float step_height = 0.35f;
	float head_height = 2.0f;
};

// Objects do not stand in the way. Convex pieces, counter-clockwise from above, in world coordinates. Ground that is not connected with a street edge of the lot (inside of
// buildings, closed courtyards) is left out, so that nobody is ever sent there. The ground of the lot's holes counts, also where other
// lots stand in them. Rectangles along the lot's front, cut by its outline.
std::vector<std::vector<glm::vec3>> free_ground(const Lot &lot, const cga::DerivationResult &model, const FreeGroundOptions &options = {});

} // namespace pcg
