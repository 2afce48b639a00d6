#pragma once

#include <vector>

#include "core/base/random.h"
#include "core/population/household_pattern.h"

namespace pcg {

struct DrawnMember {
	Gender gender = Gender::Woman;
	int age = 0; // whole years
};

// Members of one household of this pattern, adults first. "Or more" adds another member with a probability of a quarter each time (own
// choice: of Madrid's households of two adults with three or more minors in 2001, 85 of 100 have three). Ages come from the pyramid; parents
// are 18 to 45 years older than the minors where the pattern leaves room for it, couples not more than ten years apart.
std::vector<DrawnMember> draw_members(const HouseholdPattern &pattern, Random &random);

} // namespace pcg
