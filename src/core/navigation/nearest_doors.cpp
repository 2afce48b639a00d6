#include "core/navigation/nearest_doors.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include <glm/geometric.hpp>

#include "core/navigation/corner_graph.h"
#include "core/navigation/open_list.h"

namespace pcg {

NearestDoors::NearestDoors(const NavMesh &mesh, std::span<const Door> doors) : _mesh(&mesh), _labels(mesh.corner_graph().corners().count()) {
	std::vector<std::pair<uint32_t, uint32_t>> touching; // polygon, door
	std::vector<uint32_t> polygons;
	for (const Door &door : doors) {
		if (!door.point.is_on_mesh()) {
			continue;
		}
		polygons.assign(1, door.point.polygon);
		add_touching(mesh, door.point.position, 0.0f, polygons);
		for (const uint32_t polygon : polygons) {
			touching.emplace_back(polygon, uint32_t(_doors.size()));
		}
		_doors.push_back(door);
	}
	std::sort(touching.begin(), touching.end());
	_first_at_polygon.assign(mesh.polygon_count() + 1, 0);
	for (const auto &[polygon, door] : touching) {
		++_first_at_polygon[polygon + 1];
		_at_polygon.push_back(door);
	}
	std::partial_sum(_first_at_polygon.begin(), _first_at_polygon.end(), _first_at_polygon.begin());
	Sight sight(mesh, mesh.corner_graph().corners());
	search(sight);
}

void NearestDoors::search(Sight &sight) {
	OpenList open;
	const auto reach = [&](uint32_t corner, NearDoor label) {
		if (label < _labels[corner]) {
			_labels[corner] = label;
			open.push({ label.cost, corner });
		}
	};
	for (const Door &door : _doors) {
		for (const SeenCorner &seen : sight.look(door.point)) {
			reach(seen.corner, { door.step + seen.cost, door.id });
		}
	}
	while (!open.is_empty()) {
		const OpenList::Entry entry = open.pop();
		const NearDoor here = _labels[entry.node];
		if (entry.estimate > here.cost) {
			continue; // a nearer one was found in the meantime
		}
		const glm::vec3 place = _mesh->point(entry.node);
		_mesh->corner_graph().walks().for_walks(entry.node, [&](uint32_t there, float ground) {
			reach(there, { here.cost + ground * glm::distance(place, _mesh->point(there)), here.door });
		});
	}
}

std::span<const uint32_t> NearestDoors::doors_at(uint32_t polygon) const {
	return { _at_polygon.data() + _first_at_polygon[polygon], _first_at_polygon[polygon + 1] - _first_at_polygon[polygon] };
}

NearDoor NearestDoors::ask(Sight &sight, const NavPoint &from) const {
	NearDoor best;
	if (!from.is_on_mesh()) {
		return best;
	}
	for (const SeenCorner &seen : sight.look(from)) {
		const NearDoor &label = _labels[seen.corner];
		best = std::min(best, { seen.cost + label.cost, label.door });
	}
	std::vector<uint32_t> in_view; // perhaps; a walk without any corner leads to none but those
	sight.for_polygons([&](uint32_t polygon) { in_view.insert(in_view.end(), doors_at(polygon).begin(), doors_at(polygon).end()); });
	std::sort(in_view.begin(), in_view.end());
	in_view.erase(std::unique(in_view.begin(), in_view.end()), in_view.end());
	for (const uint32_t index : in_view) {
		const Door &door = _doors[index];
		if (door.step + _mesh->least_cost() * glm::distance(from.position, door.point.position) <= best.cost) {
			best = std::min(best, { door.step + sight.straight(from, door.point), door.id });
		}
	}
	return best.cost < INFINITY ? best : NearDoor();
}

} // namespace pcg
