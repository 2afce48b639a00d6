#include "core/navigation/reachability.h"

namespace pcg {

std::vector<Reach> reach_of_entrances(const CityModel &city, const NavMesh &mesh, float reach) {
	uint32_t largest = 0;
	for (uint32_t component = 1; component < mesh.component_count(); ++component) {
		largest = mesh.component_area(component) > mesh.component_area(largest) ? component : largest;
	}
	std::vector<Reach> verdicts;
	for (const Entrance &entrance : city.entrances()) {
		const NavPoint point = entrance.is_removed ? NavPoint() : mesh.nearest(entrance.position, reach);
		if (entrance.is_removed) {
			verdicts.push_back(Reach::Removed);
		} else if (!point.is_on_mesh()) {
			verdicts.push_back(Reach::OffMesh);
		} else {
			verdicts.push_back(mesh.component(point.polygon) == largest ? Reach::Reachable : Reach::Island);
		}
	}
	return verdicts;
}

} // namespace pcg
