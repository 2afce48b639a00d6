#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "core/navigation/distance_cache.h"
#include "core/navigation/nearest_doors.h"
#include "core/navigation/path_finder.h"
#include "core/ports/path_provider.h"
#include "core/semantics/city_model.h"

// Walking paths and distances on a NavMesh. The city and the mesh must outlive it.
namespace pcg {

class NavMeshPaths : public PathProvider {
public:
	// A point up to `reach` metres off the mesh walks straight to its nearest point first; from further away there is no way.
	NavMeshPaths(const CityModel &city, const NavMesh &mesh, float reach = 2.0f);

	// After edits of the city, or of the mesh in its place: looks at the entrances anew and forgets distances. Not while other threads ask. Done by the
	// constructor too.
	void prepare();

	// The mesh is another one within that box in plan: to be called before prepare().
	void note_new_ground(glm::vec3 min, glm::vec3 max);

	// In whole centimetres, and remembered. Every pair of buildings gives the length of the path between the two entrances for which it is shortest.
	double distance(BuildingId from, BuildingId to) const override;
	// The first question for a type answers it for all buildings, by one search from all its doors; then it is a look into a table. The walk to the answer is
	// at most 1 % longer than to any other. Where ground differs in cost, dearer ground counts as so much farther. Buildings that came after
	// prepare() have none.
	BuildingId nearest_building(TypeId type, BuildingId from) const override;
	// The same points in both directions.
	void find_path(glm::vec3 from, glm::vec3 to, std::vector<glm::vec3> &points) const override;
	bool nearest_walkable(glm::vec3 from, glm::vec3 &point) const override;
	// People enter at the point of the zone nearest to them as the crow flies, where that can be reached, else at its middle or at a corner.
	ZoneId nearest_zone(TypeId type, glm::vec3 from, glm::vec3 &entry) const override;
	uint64_t ground_revision() const override { return _ground_revision; }
	// Looks at the line every `sample_step` within the boxes that changed, but for the steps from and to the mesh at its ends.
	bool is_walkable(std::span<const glm::vec3> line, uint64_t since) const override;

private:
	struct Stop {
		glm::vec3 position{ 0.0f }; // before the door
		NavPoint point; // its nearest point on the mesh
	};
	class Borrowed; // a finder out of the pool
	struct Table {
		std::once_flag is_made;
		std::vector<BuildingId> nearest; // by building
	};

	Stop stop_at(glm::vec3 position) const;
	// Metres including the steps to and from the mesh; infinity if there is no way or if it is at least `limit` as the crow flies.
	double measure(PathFinder &finder, const Stop &from, const Stop &to, double limit) const;
	double measure_buildings(BuildingId from, BuildingId to) const;
	std::vector<BuildingId> find_nearest(TypeId type) const;
	BuildingId find_nearest(const NearestDoors &doors, Sight &sight, BuildingId from) const;
	double measure_zone(PathFinder &finder, const Stop &from, const Zone &zone, double limit, glm::vec3 &entry) const;
	bool is_new_since(uint64_t revision, glm::vec3 point) const;
	bool is_on_ground(glm::vec3 point) const;

	const CityModel &_city;
	const NavMesh &_mesh;
	float _reach;
	struct NewGround {
		glm::vec3 min{ 0.0f }, max{ 0.0f };
		uint64_t revision = 0; // that it came with
	};
	std::vector<NewGround> _new_ground;
	uint64_t _ground_revision = 0;
	std::vector<Stop> _stops; // by EntranceId
	mutable std::unique_ptr<DistanceCache> _distances;
	mutable std::vector<std::unique_ptr<Table>> _nearest; // by type
	mutable std::mutex _pool_mutex;
	mutable std::vector<std::unique_ptr<PathFinder>> _pool;
};

} // namespace pcg
