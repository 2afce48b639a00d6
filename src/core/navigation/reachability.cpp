#include "core/navigation/reachability.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/semantics/city_query.h"

namespace pcg {

namespace {

class Judge {
public:
	Judge(const NavMesh &mesh, float reach) : _mesh(mesh), _reach(reach) {
		for (uint32_t component = 1; component < mesh.component_count(); ++component) {
			_largest = mesh.component_area(component) > mesh.component_area(_largest) ? component : _largest;
		}
	}

	Reach verdict(glm::vec3 point) const {
		const NavPoint found = std::isfinite(point.x + point.y + point.z) ? _mesh.nearest(point, _reach) : NavPoint();
		if (!found.is_on_mesh()) {
			return Reach::OffMesh;
		}
		return _mesh.component(found.polygon) == _largest ? Reach::Reachable : Reach::Island;
	}

	Reach verdict(const Zone &zone) const {
		if (zone.polygon.size() < 3) {
			return Reach::OffMesh;
		}
		Reach best = verdict(centroid(zone));
		for (size_t i = 0; i < zone.polygon.size() && best != Reach::Reachable; ++i) {
			best = better(best, verdict_along(zone.polygon[i], zone.polygon[(i + 1) % zone.polygon.size()]));
		}
		return best;
	}

private:
	static Reach better(Reach a, Reach b) { return std::min(a, b); } // in the order in which they are declared

	// From `a` to before `b`, in steps that leave no gap.
	Reach verdict_along(glm::vec3 a, glm::vec3 b) const {
		constexpr float most_steps = 64.0f;
		const float steps = std::clamp(std::ceil(glm::distance(a, b) / (2.0f * _reach)), 1.0f, most_steps);
		Reach best = Reach::OffMesh;
		for (float step = 0.0f; step < steps && best != Reach::Reachable; ++step) {
			best = better(best, verdict(a + (b - a) * (step / steps)));
		}
		return best;
	}

	const NavMesh &_mesh;
	float _reach; // metres
	uint32_t _largest = 0; // component
};

template <typename Record, typename Verdict> std::vector<Reach> verdicts_of(const std::vector<Record> &records, Verdict verdict) {
	std::vector<Reach> verdicts;
	for (const Record &record : records) {
		verdicts.push_back(record.is_removed ? Reach::Removed : verdict(record));
	}
	return verdicts;
}

} // namespace

std::vector<Reach> reach_of_entrances(const CityModel &city, const NavMesh &mesh, float reach) {
	const Judge judge(mesh, reach);
	return verdicts_of(city.entrances(), [&](const Entrance &entrance) { return judge.verdict(entrance.position); });
}

std::vector<Reach> reach_of_zones(const CityModel &city, const NavMesh &mesh, float reach) {
	const Judge judge(mesh, reach);
	return verdicts_of(city.zones(), [&](const Zone &zone) { return judge.verdict(zone); });
}

} // namespace pcg
