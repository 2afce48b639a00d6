#include "core/navigation/nav_mesh_paths.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "core/base/parallel.h"
#include "core/navigation/corner_graph.h"
#include "core/semantics/city_query.h"

namespace pcg {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr float sample_step = 0.2f; // metres
constexpr float slack = 0.3f; // metres between a way and the ground, which is simplified anew where it is baked anew
constexpr float height_slack = 0.75f; // metres
constexpr size_t batch = 256; // buildings that a thread asks for at a time

// Orders the ends of a walk, so that both directions are searched the same way.
bool is_before(glm::vec3 a, glm::vec3 b) { return a.x != b.x ? a.x < b.x : (a.z != b.z ? a.z < b.z : a.y < b.y); }

} // namespace

// A finder for the time of one question. Threads that ask at once get one each; they are kept for the next questions.
class NavMeshPaths::Borrowed {
public:
	explicit Borrowed(const NavMeshPaths &owner) : _owner(owner) {
		const std::lock_guard<std::mutex> lock(owner._pool_mutex);
		if (!owner._pool.empty()) {
			_finder = std::move(owner._pool.back());
			owner._pool.pop_back();
		} else {
			_finder = std::make_unique<PathFinder>(owner._mesh);
		}
	}
	~Borrowed() {
		const std::lock_guard<std::mutex> lock(_owner._pool_mutex);
		_owner._pool.push_back(std::move(_finder));
	}
	Borrowed(const Borrowed &) = delete;
	Borrowed &operator=(const Borrowed &) = delete;
	PathFinder &operator*() { return *_finder; }

private:
	const NavMeshPaths &_owner;
	std::unique_ptr<PathFinder> _finder;
};

NavMeshPaths::NavMeshPaths(const CityModel &city, const NavMesh &mesh, float reach) : _city(city), _mesh(mesh), _reach(reach) {
	prepare();
}

void NavMeshPaths::prepare() {
	_pool.clear(); // finders know the ground that was
	_stops.clear();
	_stops.reserve(_city.entrances().size());
	for (const Entrance &entrance : _city.entrances()) {
		_stops.push_back(entrance.is_removed ? Stop() : stop_at(entrance.position));
	}
	_distances = std::make_unique<DistanceCache>(_city.buildings().size());
	_nearest.clear();
	for (size_t type = 0; type < _city.types.size(); ++type) {
		_nearest.push_back(std::make_unique<Table>());
	}
}

NavMeshPaths::Stop NavMeshPaths::stop_at(glm::vec3 position) const { return { position, _mesh.nearest(position, _reach) }; }

double NavMeshPaths::measure(PathFinder &finder, const Stop &from, const Stop &to, double limit) const {
	if (double(glm::distance(from.position, to.position)) >= limit) {
		return infinity;
	}
	const bool is_swapped = is_before(to.position, from.position);
	if (!finder.find((is_swapped ? to : from).point, (is_swapped ? from : to).point)) {
		return infinity;
	}
	return finder.length() + double(glm::distance(from.position, from.point.position)) + double(glm::distance(to.position, to.point.position));
}

double NavMeshPaths::measure_buildings(BuildingId from, BuildingId to) const {
	Borrowed finder(*this);
	double best = infinity;
	for (EntranceId a : _city.building(from).entrances) {
		for (EntranceId b : _city.building(to).entrances) {
			if (index_of(a) < _stops.size() && index_of(b) < _stops.size()) {
				best = std::fmin(best, measure(*finder, _stops[index_of(a)], _stops[index_of(b)], best));
			}
		}
	}
	return DistanceCache::round(best);
}

double NavMeshPaths::distance(BuildingId from, BuildingId to) const {
	if (index_of(from) >= _city.buildings().size() || index_of(to) >= _city.buildings().size()) {
		return infinity;
	}
	if (from == to) {
		return 0.0;
	}
	if (const std::optional<double> known = _distances->find(from, to)) {
		return *known;
	}
	const double metres = measure_buildings(from, to);
	_distances->store(from, to, metres);
	return metres;
}

BuildingId NavMeshPaths::nearest_building(TypeId type, BuildingId from) const {
	if (index_of(type) >= _nearest.size()) {
		return BuildingId::Invalid;
	}
	Table &table = *_nearest[index_of(type)];
	std::call_once(table.is_made, [&] { table.nearest = find_nearest(type); });
	return index_of(from) < table.nearest.size() ? table.nearest[index_of(from)] : BuildingId::Invalid;
}

// Doors are told apart by the building that they lead into.
std::vector<BuildingId> NavMeshPaths::find_nearest(TypeId type) const {
	std::vector<Door> doors;
	for (size_t i = 0; i < _stops.size(); ++i) {
		const Entrance &entrance = _city.entrances()[i];
		if (entrance.type == type && !entrance.is_removed) {
			doors.push_back({ _stops[i].point, glm::distance(_stops[i].position, _stops[i].point.position), index_of(entrance.building) });
		}
	}
	std::vector<BuildingId> nearest(_city.buildings().size(), BuildingId::Invalid);
	if (doors.empty()) {
		return nearest;
	}
	const NearestDoors field(_mesh, doors);
	parallel_for((nearest.size() + batch - 1) / batch, {}, [&](size_t index) {
		Sight sight(_mesh, _mesh.corner_graph().corners());
		for (size_t i = index * batch; i < std::min((index + 1) * batch, nearest.size()); ++i) {
			nearest[i] = find_nearest(field, sight, BuildingId(i));
		}
	});
	for (const Door &door : doors) {
		nearest[door.id] = BuildingId(door.id); // nothing is nearer than what is here
	}
	return nearest;
}

BuildingId NavMeshPaths::find_nearest(const NearestDoors &doors, Sight &sight, BuildingId from) const {
	NearDoor best;
	for (const EntranceId entrance : _city.building(from).entrances) {
		if (index_of(entrance) < _stops.size()) {
			const Stop &stop = _stops[index_of(entrance)];
			NearDoor found = doors.ask(sight, stop.point);
			found.cost += glm::distance(stop.position, stop.point.position);
			best = std::min(best, found);
		}
	}
	return best.door != no_door ? BuildingId(best.door) : BuildingId::Invalid;
}

void NavMeshPaths::find_path(glm::vec3 from, glm::vec3 to, std::vector<glm::vec3> &path) const {
	const bool is_swapped = is_before(to, from);
	const Stop first = stop_at(is_swapped ? to : from), last = stop_at(is_swapped ? from : to);
	path.clear();
	Borrowed finder(*this);
	if (!(*finder).find(first.point, last.point)) {
		return;
	}
	const std::span<const glm::vec3> points = (*finder).points();
	// Steps of less than a millimetre to the mesh are rounding.
	const auto is_off = [](glm::vec3 a, glm::vec3 b) { return glm::distance(a, b) > 1e-3f; };
	if (is_off(first.position, points.front())) {
		path.push_back(first.position);
	}
	path.insert(path.end(), points.begin(), points.end());
	if (is_off(last.position, points.back())) {
		path.push_back(last.position);
	}
	path.front() = first.position;
	path.back() = last.position;
	if (is_swapped) {
		std::reverse(path.begin(), path.end());
	}
}

bool NavMeshPaths::nearest_walkable(glm::vec3 from, glm::vec3 &point) const {
	const NavPoint found = _mesh.nearest(from, std::numeric_limits<float>::infinity());
	point = found.position;
	return found.is_on_mesh();
}

void NavMeshPaths::note_new_ground(glm::vec3 min, glm::vec3 max) {
	++_ground_revision;
	const auto known = std::find_if(_new_ground.begin(), _new_ground.end(), [&](const NewGround &other) { return other.min == min && other.max == max; });
	if (known == _new_ground.end()) {
		_new_ground.push_back({ min, max, _ground_revision });
	} else {
		known->revision = _ground_revision;
	}
}

bool NavMeshPaths::is_new_since(uint64_t revision, glm::vec3 point) const {
	return std::any_of(_new_ground.begin(), _new_ground.end(), [&](const NewGround &box) {
		return box.revision > revision && point.x >= box.min.x && point.x <= box.max.x && point.z >= box.min.z && point.z <= box.max.z;
	});
}

bool NavMeshPaths::is_on_ground(glm::vec3 point) const {
	const NavPoint found = _mesh.nearest(point, height_slack);
	const glm::vec3 away = found.position - point;
	return found.is_on_mesh() && std::hypot(away.x, away.z) <= slack;
}

bool NavMeshPaths::is_walkable(std::span<const glm::vec3> line, uint64_t since) const {
	const auto is_step = [&](glm::vec3 point) {
		return glm::distance(point, line.front()) <= _reach || glm::distance(point, line.back()) <= _reach;
	};
	for (size_t i = 1; i < line.size(); ++i) {
		const glm::vec3 way = line[i] - line[i - 1];
		const int steps = std::max(1, int(glm::length(way) / sample_step));
		for (int step = 0; step < steps; ++step) {
			const glm::vec3 point = line[i - 1] + way * (float(step) / float(steps));
			if (is_new_since(since, point) && !is_step(point) && !is_on_ground(point)) {
				return false;
			}
		}
	}
	return true;
}

double NavMeshPaths::measure_zone(PathFinder &finder, const Stop &from, const Zone &zone, double limit, glm::vec3 &entry) const {
	std::vector<glm::vec3> candidates = { nearest_point(zone, from.position), centroid(zone) };
	candidates.insert(candidates.end(), zone.polygon.begin(), zone.polygon.end());
	for (glm::vec3 candidate : candidates) {
		const Stop stop = stop_at(candidate);
		const double metres = stop.point.is_on_mesh() ? measure(finder, from, { stop.point.position, stop.point }, limit) : infinity;
		if (metres < limit) {
			entry = stop.point.position;
			return metres;
		}
	}
	return infinity;
}

ZoneId NavMeshPaths::nearest_zone(TypeId type, glm::vec3 from, glm::vec3 &entry) const {
	std::vector<std::pair<float, ZoneId>> candidates;
	for (ZoneId zone : _city.zones_of_type(type)) {
		candidates.emplace_back(glm::distance(nearest_point(_city.zone(zone), from), from), zone);
	}
	std::sort(candidates.begin(), candidates.end());
	const Stop start = stop_at(from);
	Borrowed finder(*this);
	ZoneId best = ZoneId::Invalid;
	double best_metres = infinity;
	for (const auto &[crow, zone] : candidates) {
		if (double(crow) > best_metres) {
			break;
		}
		const double metres = measure_zone(*finder, start, _city.zone(zone), best_metres, entry);
		if (metres < best_metres) {
			best_metres = metres;
			best = zone;
		}
	}
	return best;
}

} // namespace pcg
