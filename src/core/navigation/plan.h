#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include <glm/vec3.hpp>

#include "core/base/random.h"

// Geometry of the plan: x and z only, seen from above.
namespace pcg {

// Positive if `c` lies left of the direction from `a` to `b`.
inline float side(glm::vec3 a, glm::vec3 b, glm::vec3 c) { return (c.x - a.x) * (b.z - a.z) - (c.z - a.z) * (b.x - a.x); }

inline float plan_distance(glm::vec3 a, glm::vec3 b) { return std::hypot(a.x - b.x, a.z - b.z); }

inline float distance_to_segment(glm::vec3 point, glm::vec3 a, glm::vec3 b) {
	const float dx = b.x - a.x, dz = b.z - a.z, px = point.x - a.x, pz = point.z - a.z;
	const float t = std::clamp((px * dx + pz * dz) / std::fmax(dx * dx + dz * dz, 1e-12f), 0.0f, 1.0f);
	const float ex = px - t * dx, ez = pz - t * dz;
	return std::sqrt(ex * ex + ez * ez);
}

// For places that are equal to the bit.
inline uint64_t hash_of(glm::vec3 p) {
	return mix64(uint64_t(std::bit_cast<uint32_t>(p.x)) << 32 | std::bit_cast<uint32_t>(p.z)) ^ std::bit_cast<uint32_t>(p.y);
}

// A rectangle of the plan, empty at first.
struct PlanBox {
	float min_x = INFINITY, min_z = INFINITY, max_x = -INFINITY, max_z = -INFINITY;

	void add(glm::vec3 point) {
		min_x = std::min(min_x, point.x);
		min_z = std::min(min_z, point.z);
		max_x = std::max(max_x, point.x);
		max_z = std::max(max_z, point.z);
	}
	// Whether they are at most `margin` metres apart along both axes.
	bool is_near(const PlanBox &other, float margin) const {
		return min_x <= other.max_x + margin && max_x >= other.min_x - margin && min_z <= other.max_z + margin && max_z >= other.min_z - margin;
	}
};

} // namespace pcg
