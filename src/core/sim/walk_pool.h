#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/sim_time.h"

namespace pcg {

// One walk, alone or of a group together. Where the walkers are is worked out when somebody asks.
struct Walk {
	std::vector<glm::vec3> points; // at least two
	double length = 0.0; // metres
	SimTime departure;
	SimTime arrival;
	float speed = 1.0f; // m/s
	uint32_t walkers = 0;

	double metres_at(SimTime time) const;
	glm::vec3 position_at(SimTime time) const;
};

// The point `metres` along the path, clamped to its ends; `direction`, if wanted, gets the unit direction there.
glm::vec3 point_along(std::span<const glm::vec3> points, double metres, glm::vec3 *direction = nullptr);
double path_length(std::span<const glm::vec3> points);
// What is left to walk, from where the walkers are at that time. Replaces what `points` held.
void rest_of(const Walk &walk, SimTime time, std::vector<glm::vec3> &points);

// Walks exist only while somebody walks them; slots and their memory are used again.
class WalkPool {
public:
	static constexpr uint32_t none = 0xFFFFFFFF;

	uint32_t add(std::span<const glm::vec3> points, SimTime departure, float speed, uint32_t walkers);
	// One walker less; the last one frees the walk.
	void leave(uint32_t walk);
	void clear();
	// Those of a saved state, without walkers as yet.
	void restore(std::vector<Walk> walks);
	void join(uint32_t walk) { ++_walks[walk].walkers; }
	const Walk &operator[](uint32_t walk) const { return _walks[walk]; }
	size_t in_use() const { return _walks.size() - _free.size(); }

private:
	std::vector<Walk> _walks;
	std::vector<uint32_t> _free;
};

} // namespace pcg
