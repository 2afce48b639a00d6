#pragma once

#include <cmath>

#include <glm/common.hpp>

#include "core/geometry/polygon.h"

namespace pcg {

// A rectangle of the plan along its axes, empty at first.
struct Box2 {
	glm::dvec2 min{ INFINITY }, max{ -INFINITY };

	void add(glm::dvec2 point) {
		min = glm::min(min, point);
		max = glm::max(max, point);
	}
	Loop2 outline() const { return { min, { max.x, min.y }, max, { min.x, max.y } }; }
};

inline Box2 box_of(const Loop2 &loop) {
	Box2 box;
	for (const glm::dvec2 &point : loop) {
		box.add(point);
	}
	return box;
}

inline bool is_within(const Box2 &inner, const Box2 &outer) {
	return inner.min.x >= outer.min.x && inner.min.y >= outer.min.y && inner.max.x <= outer.max.x && inner.max.y <= outer.max.y;
}

} // namespace pcg
