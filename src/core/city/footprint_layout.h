#pragma once

#include "core/city/layout.h"
#include "core/geometry/overlay.h"

// Layouts of outlines that somebody drew or measured: a real city's buildings, or lots drawn by hand.
namespace pcg {

constexpr float tallest_footprint = 2000.0f; // metres; what is said to be taller, or lower than the ground, is told and not believed

struct Footprint {
	Loop2 outline; // in plan: x east, y north, metres; counter-clockwise, without the first point again at its end
	std::vector<Loop2> holes = {}; // courtyards, each like an outline
	std::string type; // what it is said to be; empty: land use decides
	float height = 0.0f; // [Limit: 0 to tallest_footprint] metres; 0 = not known
	std::string name; // for messages: "feature 12"
};

// A lot for each footprint; all around them is open ground on which one can walk, as far as `pavement_width` and a street's width beyond the
// outermost. Of `parameters` only that, `street_width`, land use, districts and seed count. A type that is not in the land use is left to it.
// The front is a footprint's longest side on open ground; courtyards between several footprints, without a way out, count only for those that have no other.
// Ground in holes belongs to the lot around, except where another footprint stands.
// Footprints that cross themselves, are smaller than 1 square metre (holes, too), lie farther than 50 km from the origin or are walled in on all sides
// are errors that name them, and so are holes that do not lie within their outline, apart from each other; footprints that overlap are warnings.
std::optional<Layout> layout_of_footprints(const std::vector<Footprint> &footprints, const LayoutParameters &parameters, Diagnostics &diagnostics);

} // namespace pcg
