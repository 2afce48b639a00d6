#pragma once

#include <algorithm>
#include <cmath>

#include "core/base/random.h"
#include "core/geometry/polygon.h"

// Outlines of lots as tests draw them, counter-clockwise: whole metres and right angles, so that many things happen to a front at once.
namespace pcg {

// A wall of 40 m with a top of whole metres that goes up and down.
inline Loop2 random_stairs(Random &random) {
	Loop2 outline = { { 0.0, 0.0 }, { 40.0, 0.0 } };
	const size_t steps = 2 + random.index(6);
	double right = 40.0, last = 0.0;
	for (size_t i = 0; i < steps; ++i) {
		const double left = i + 1 < steps ? right - 1.0 - double(random.index(5)) : 0.0;
		double top = 5.0 + double(random.index(16));
		top += top == last ? 1.0 : 0.0;
		outline.push_back({ right, top });
		outline.push_back({ left, top });
		right = left;
		last = top;
	}
	return outline;
}

// A back with two to five teeth of whole metres.
inline Loop2 random_comb(Random &random) {
	const size_t teeth = 2 + random.index(4);
	const double back = 1.0 + double(random.index(3));
	Loop2 outline = { { 0.0, 0.0 } };
	double y = 0.0;
	for (size_t i = 0; i < teeth; ++i) {
		const double width = 1.0 + double(random.index(3)), end = back + 2.0 + double(random.index(8));
		if (i > 0) {
			outline.push_back({ back, y });
		}
		outline.push_back({ end, y });
		outline.push_back({ end, y + width });
		outline.push_back({ i + 1 < teeth ? back : 0.0, y + width });
		y += width + 1.0 + double(random.index(3));
	}
	return outline;
}

inline Loop2 turned(const Loop2 &outline, double angle) {
	Loop2 result;
	for (const glm::dvec2 &p : outline) {
		result.push_back({ p.x * std::cos(angle) - p.y * std::sin(angle), p.x * std::sin(angle) + p.y * std::cos(angle) });
	}
	return result;
}

// One of them, half of them turned, beginning anywhere.
inline Loop2 random_right_angles(Random &random) {
	Loop2 outline = random.chance(0.5) ? random_stairs(random) : random_comb(random);
	outline = random.chance(0.5) ? turned(outline, random.uniform(0.0, 6.28)) : outline;
	std::ranges::rotate(outline, outline.begin() + std::ptrdiff_t(random.index(outline.size())));
	return outline;
}

} // namespace pcg
