#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "core/geometry/overlay.h"

// The volume that may be built on (CGA reference: op_envelope): walls on the outline, planes that lean inwards above them, a flat top.
namespace pcg {

// Of one edge: its wall is so high, then its plane rises at so many degrees from the horizontal; 90 goes straight on.
struct EnvelopeSide {
	double base_height = 0.0;
	double angle = 90.0;
};

struct EnvelopeFace {
	enum class Kind : uint8_t { Bottom, Wall, Slope, Top } kind = Kind::Bottom;
	uint32_t edge = 0; // of walls and slopes; of steps between sides of one line twice the number of edges or more
	std::vector<std::vector<glm::dvec3>> loops; // counter-clockwise seen from outside, holes the other way
};

struct Envelope {
	std::vector<EnvelopeFace> faces; // bottom, walls by edge, slopes by edge, tops
	bool is_closed = true; // false: the outline crosses itself
};

// The polygon lies at z = 0, `sides` has one for each of its edges. Source: weighted straight skeleton whose edges begin
// to move at their base heights.
Envelope make_envelope(const Loops2 &polygon, const std::vector<EnvelopeSide> &sides, double max_height);

} // namespace pcg
