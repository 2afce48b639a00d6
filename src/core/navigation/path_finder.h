#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/navigation/corner_graph.h"
#include "core/navigation/nav_mesh.h"
#include "core/navigation/open_list.h"
#include "core/navigation/sight.h"

// Shortest walks on a NavMesh: A* over its corners, led by landmarks. They cost at most 1 % more than the cheapest walk that changes the kind of ground
// at corners only, and in theory a unit of CornerGraph's estimates for each bend (5 cm for 300 lots). The memory of a search is kept for the next one, so use one finder for each thread. The mesh must outlive it.
namespace pcg {

class PathFinder {
public:
	explicit PathFinder(const NavMesh &mesh) : _mesh(&mesh), _graph(&mesh.corner_graph()), _sight(mesh, _graph->corners()) {}

	// Both points must lie on the mesh. False if there is no way, which takes no search. Where polygons are piled on one another so that sight ends before
	// everything was seen (Sight::is_cut_short()) the walk may be longer than it need be, but there is one wherever polygons are connected.
	bool find(const NavPoint &from, const NavPoint &to);
	// Of the last find() that was true: the corners of the walk, first = from, last = to, without a point twice in a row.
	std::span<const glm::vec3> points() const { return _points; }
	double length() const { return _length; } // metres

private:
	struct Node {
		float cost = 0.0f; // so far
		float estimate = 0.0f; // of the rest
		uint32_t previous = no_corner;
		uint32_t search = 0; // the node counts only if this is the number of the running search
		uint32_t goal_search = 0; // the same for `goal_cost`
		float goal_cost = 0.0f; // of the straight walk to the goal
	};

	void pass_gaps(const NavPoint &from, const NavPoint &to);
	void start(glm::vec3 goal);
	uint32_t search(const NavPoint &from, const NavPoint &to);
	// Costs a node from which walks have gone on: no other way there is of use.
	static constexpr float closed = -std::numeric_limits<float>::infinity();

	float estimate(uint32_t corner) const;
	void walk_on(uint32_t corner, float cost);
	void collect(glm::vec3 from, uint32_t last_corner, glm::vec3 to);
	void add_point(glm::vec3 point);

	const NavMesh *_mesh;
	const CornerGraph *_graph;
	Sight _sight;
	std::vector<Node> _nodes; // by corner
	OpenList _open;
	uint32_t _search = 0;
	glm::vec3 _goal_position{ 0.0f };
	CornerGraph::Goal _goal{};
	float _goal_cost = 0.0f; // of the best walk so far
	std::vector<uint32_t> _bends; // corners, from the goal back
	std::vector<glm::vec3> _points;
	double _length = 0.0;
};

} // namespace pcg
