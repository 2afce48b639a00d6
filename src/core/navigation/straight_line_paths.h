#pragma once

#include "core/ports/path_provider.h"
#include "core/semantics/city_model.h"

// Distances as the crow flies, for cities without navigation. Reads the model at each call, so edits show at once; keeps nothing.
// `city` must outlive it.
namespace pcg {

class StraightLinePaths : public PathProvider {
public:
	explicit StraightLinePaths(const CityModel &city) : _city(city) {}

	double distance(BuildingId from, BuildingId to) const override;
	BuildingId nearest_building(TypeId type, BuildingId from) const override;
	void find_path(glm::vec3 from, glm::vec3 to, std::vector<glm::vec3> &points) const override;
	bool nearest_walkable(glm::vec3 from, glm::vec3 &point) const override;
	ZoneId nearest_zone(TypeId type, glm::vec3 from, glm::vec3 &entry) const override;

private:
	const CityModel &_city;
};

} // namespace pcg
