#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/ids.h"

// What the core asks about walking. core/navigation answers it on baked polygons; StraightLinePaths answers it without any.
namespace pcg {

class PathProvider {
public:
	virtual ~PathProvider() = default;

	// Walking distance in metres between the nearest entrances of two buildings; 0 for one building, infinity if there is no way.
	// Same value for both directions. May be called from several threads at once after prepare().
	virtual double distance(BuildingId from, BuildingId to) const = 0;
	// The building with an entrance of the type nearest by walking distance, ties to the lower id; Invalid if none can be reached.
	virtual BuildingId nearest_building(TypeId type, BuildingId from) const = 0;
	// The polyline walked, first point = from, last = to; empty if there is no way. Points on the ground. Replaces what `points` held.
	virtual void find_path(glm::vec3 from, glm::vec3 to, std::vector<glm::vec3> &points) const = 0;
	std::vector<glm::vec3> path(glm::vec3 from, glm::vec3 to) const {
		std::vector<glm::vec3> points;
		find_path(from, to, points);
		return points;
	}
	// The point nearest to `from` where people can walk, however far away; false if there is none.
	virtual bool nearest_walkable(glm::vec3 from, glm::vec3 &point) const = 0;
	// The zone of the type whose nearest point is closest to walk to, and that point; Invalid if none.
	virtual ZoneId nearest_zone(TypeId type, glm::vec3 from, glm::vec3 &entry) const = 0;
	// Grows whenever the ground changes; 0: it is as it was when it was made.
	virtual uint64_t ground_revision() const { return 0; }
	// Whether no change of the ground since that revision is in the way of somebody who walks along the line.
	virtual bool is_walkable(std::span<const glm::vec3> /*line*/, uint64_t /*since*/) const { return true; }
};

} // namespace pcg
