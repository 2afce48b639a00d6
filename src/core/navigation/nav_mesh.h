#pragma once

#include <cstdint>
#include <memory>
#include <ranges>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/navigation/plan.h"

// Where people can walk: convex polygons and the gaps between them. Built once from regions, then read by any number of threads.
// Metres, y up.
namespace pcg {

constexpr uint32_t no_polygon = 0xFFFFFFFF;

// One baked piece of a city, as an engine hands it over.
struct NavRegion {
	std::vector<glm::vec3> vertices;
	std::vector<std::vector<uint32_t>> polygons; // indices of vertices; convex in plan, either way around
	// For each polygon what a metre in it costs compared to the cheapest ground, >= 1: people cross streets at crossings. Empty: all 1.
	std::vector<float> costs;
};

struct NavMeshOptions {
	// Edges of different polygons are joined where they run side by side, opposite to each other, with a gap of at most this many metres.
	float margin = 0.25f;
	float step = 0.6f; // and at heights that differ by at most this
	float min_gap = 0.1f; // shorter stretches are no way through
};

// A way from one polygon into another. Seen by who walks it, the gap runs from `left` to `right`.
struct NavLink {
	uint32_t target = no_polygon;
	uint32_t left = 0, right = 0; // points of the mesh
};

struct NavPoint {
	uint32_t polygon = no_polygon;
	glm::vec3 position{ 0.0f };

	bool is_on_mesh() const { return polygon != no_polygon; }
};

class CornerGraph;
class CornerPolygons;
class Corners;
class HashIndex;
struct NavGap;

class NavMesh {
public:
	NavMesh(); // without any ground
	// Polygons with fewer than three corners, without area, with indices out of range or coordinates that are not finite are left out.
	static NavMesh build(std::span<const NavRegion> regions, const NavMeshOptions &options = {});
	// The same where `before` was built of regions of which some are others now, with the same options. `changed`: boxes around the old and the new ones
	// of these. Walks that lead past them are taken over.
	static NavMesh rebuild(const NavMesh &before, std::span<const PlanBox> changed, std::span<const NavRegion> regions,
			const NavMeshOptions &options = {});

	size_t polygon_count() const { return _first_corner.empty() ? 0 : _first_corner.size() - 1; }
	// Where polygons have corners and gaps end, each place once; the first are the corners at which walks bend (Corners).
	size_t point_count() const { return _points.size(); }
	glm::vec3 point(uint32_t index) const { return _points[index]; }
	std::span<const glm::vec3> points() const { return _points; }
	// Counter-clockwise seen from above.
	auto corners(uint32_t polygon) const {
		return std::span(_corners).subspan(_first_corner[polygon], _first_corner[polygon + 1] - _first_corner[polygon]) |
				std::views::transform([this](uint32_t point) { return _points[point]; });
	}
	const std::vector<NavLink> &links() const { return _links; }
	uint32_t first_link(uint32_t polygon) const { return _first_link[polygon]; } // also of polygon_count(): the end
	uint32_t source(uint32_t link) const; // found by halving
	float cost(uint32_t polygon) const { return _costs[polygon]; }
	float least_cost() const { return _least_cost; }
	// Two polygons are connected if and only if their components are equal.
	uint32_t component(uint32_t polygon) const;
	size_t component_count() const { return _component_areas.size(); }
	double component_area(uint32_t component) const { return _component_areas[component]; } // square metres

	const CornerGraph &corner_graph() const { return *_corner_graph; }

	// The point of the mesh nearest to `point`, at most `reach` metres away.
	NavPoint nearest(glm::vec3 point, float reach) const;
	// The point of the polygon nearest to `point` in plan, at the polygon's height.
	glm::vec3 nearest_in(uint32_t polygon, glm::vec3 point) const;

private:
	static NavMesh join(std::span<const NavRegion> regions, const NavMeshOptions &options); // all but the graph
	uint32_t add_point(glm::vec3 point, HashIndex &known);
	void add_polygon(const NavRegion &region, size_t index, HashIndex &known, std::vector<uint32_t> &corner_names);
	void set_links(std::vector<NavGap> gaps, HashIndex &known);
	Corners find_corners(const NavMeshOptions &options, CornerPolygons &polygons); // numbers points anew
	void find_components();
	void fill_grid();
	uint32_t column(float x) const;
	uint32_t row(float z) const;

	std::vector<glm::vec3> _points;
	std::vector<uint32_t> _corners; // points
	std::vector<uint32_t> _first_corner; // one more than polygons
	std::vector<float> _costs;
	float _least_cost = 1.0f;
	std::vector<NavLink> _links; // by source
	std::vector<uint32_t> _first_link; // one more than polygons
	uint32_t _main_component = 0; // of most polygons
	struct Island {
		uint32_t polygon, component;
	};
	std::vector<Island> _islands; // all other polygons, sorted
	std::vector<double> _component_areas;
	std::shared_ptr<const CornerGraph> _corner_graph;

	// Polygons by the cells of a grid over the plan.
	glm::vec3 _min{ 0.0f }, _max{ 0.0f };
	float _cell = 1.0f;
	uint32_t _columns = 0, _rows = 0;
	std::vector<uint32_t> _first_in_cell; // one more than cells
	std::vector<uint32_t> _in_cell;
};

} // namespace pcg
