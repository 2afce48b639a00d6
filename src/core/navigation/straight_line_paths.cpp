#include "core/navigation/straight_line_paths.h"

#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "core/semantics/city_query.h"

namespace pcg {

double StraightLinePaths::distance(BuildingId from, BuildingId to) const {
	double best = std::numeric_limits<double>::infinity();
	if (index_of(from) >= _city.buildings().size() || index_of(to) >= _city.buildings().size()) {
		return best;
	}
	if (from == to) {
		return 0.0;
	}
	for (EntranceId a : _city.building(from).entrances) {
		for (EntranceId b : _city.building(to).entrances) {
			best = std::fmin(best, double(glm::distance(_city.entrance(a).position, _city.entrance(b).position)));
		}
	}
	return best;
}

BuildingId StraightLinePaths::nearest_building(TypeId type, BuildingId from) const {
	BuildingId nearest = BuildingId::Invalid;
	double best = std::numeric_limits<double>::infinity();
	for (BuildingId candidate : _city.buildings_of_type(type)) {
		const double metres = distance(from, candidate);
		if (metres < best) {
			best = metres;
			nearest = candidate;
		}
	}
	return nearest;
}

void StraightLinePaths::find_path(glm::vec3 from, glm::vec3 to, std::vector<glm::vec3> &points) const { points.assign({ from, to }); }

bool StraightLinePaths::nearest_walkable(glm::vec3 from, glm::vec3 &point) const {
	point = from;
	return true;
}

ZoneId StraightLinePaths::nearest_zone(TypeId type, glm::vec3 from, glm::vec3 &entry) const {
	ZoneId nearest = ZoneId::Invalid;
	float best = std::numeric_limits<float>::infinity();
	for (ZoneId candidate : _city.zones_of_type(type)) {
		const glm::vec3 point = nearest_point(_city.zone(candidate), from);
		if (glm::distance(point, from) < best) {
			best = glm::distance(point, from);
			nearest = candidate;
			entry = point;
		}
	}
	return nearest;
}

} // namespace pcg
