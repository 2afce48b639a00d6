#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/navigation/landmarks.h"
#include "core/navigation/nav_mesh.h"
#include "core/navigation/open_list.h"

// Short walks on a NavMesh: A* from gap to gap, led by landmarks, then the string through the corridor is pulled tight. They are about 1 % longer
// than the shortest possible. The memory of a search is kept for the next one, so use one finder for each thread. The mesh must outlive it.
namespace pcg {

class PathFinder {
public:
	explicit PathFinder(const NavMesh &mesh) : _mesh(&mesh) {}

	// Both points must lie on the mesh. False if there is no way, which takes no search.
	bool find(const NavPoint &from, const NavPoint &to);
	// Of the last find() that was true: the corners of the walk, first = from, last = to, without a point twice in a row.
	std::span<const glm::vec3> points() const { return _points; }
	double length() const { return _length; } // metres

private:
	struct Node {
		float cost = 0.0f; // so far, to `point`
		uint32_t previous = 0; // link; no_link at the start
		uint32_t search = 0; // the node counts only if this is the number of the running search
		bool is_closed = false; // ways go on from here: neither cost nor point may change
		glm::vec3 point{ 0.0f }; // where the gap was passed
	};
	// Where a polygon was first walked into in the running search, and the cost until there.
	struct Entry {
		uint32_t search = 0;
		float cost = 0.0f;
		glm::vec3 point{ 0.0f };
	};
	static constexpr uint32_t no_link = 0xFFFFFFFF; // in the open list: the goal itself

	void start();
	bool search(const NavPoint &from, const NavPoint &to);
	void expand(uint32_t polygon, uint32_t from_link, glm::vec3 point, float cost, const NavPoint &to);
	bool is_dominated(uint32_t polygon, glm::vec3 point, float cost) const;
	void collect_corridor(uint32_t last_link);
	void pull_tight(glm::vec3 from, glm::vec3 to);
	void add_point(glm::vec3 point);

	const NavMesh *_mesh;
	std::vector<Node> _nodes; // by link
	std::vector<Entry> _entries; // by polygon
	OpenList _open;
	uint32_t _search = 0;
	Landmarks::Costs _goal_costs;
	uint32_t _goal_link = no_link; // best way into the goal so far
	float _goal_cost = 0.0f;
	std::vector<uint32_t> _corridor; // links
	std::vector<glm::vec3> _points;
	double _length = 0.0;
};

} // namespace pcg
