#include "core/navigation/path_finder.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace pcg {

namespace {

// What lies ahead counts a little more than what lies behind: of walks that cost about the same the one that has come farthest is followed. A walk
// costs at most so many times the least possible.
constexpr float haste = 1.01f;

bool is_same_place(glm::vec3 a, glm::vec3 b) { return std::abs(a.x - b.x) < 1e-4f && std::abs(a.z - b.z) < 1e-4f; }

// All but on the straight line between the others.
bool is_between(glm::vec3 a, glm::vec3 middle, glm::vec3 b) {
	return glm::distance(a, middle) + glm::distance(middle, b) <= glm::distance(a, b) + 1e-6f;
}

} // namespace

bool PathFinder::find(const NavPoint &from, const NavPoint &to) {
	_points.clear();
	_length = 0.0;
	if (!from.is_on_mesh() || !to.is_on_mesh() || _mesh->component(from.polygon) != _mesh->component(to.polygon)) {
		return false;
	}
	const uint32_t last = search(from, to);
	if (std::isinf(_goal_cost)) {
		pass_gaps(from, to);
	} else {
		collect(from.position, last, to.position);
	}
	for (size_t i = 1; i < _points.size(); ++i) {
		_length += double(glm::distance(_points[i - 1], _points[i]));
	}
	return true;
}

// From polygon to polygon through the middles of the fewest gaps: not the shortest walk, but one that needs no sight.
void PathFinder::pass_gaps(const NavPoint &from, const NavPoint &to) {
	constexpr uint32_t no_link = no_corner;
	std::vector<uint32_t> came_by(_mesh->polygon_count(), no_link);
	std::vector<uint32_t> polygons = { to.polygon }; // from the goal, so that links are met in the walk's order
	for (size_t i = 0; i < polygons.size() && polygons[i] != from.polygon; ++i) {
		for (uint32_t link = _mesh->first_link(polygons[i]); link < _mesh->first_link(polygons[i] + 1); ++link) {
			const uint32_t next = _mesh->links()[link].target;
			if (came_by[next] == no_link && next != to.polygon) {
				came_by[next] = link;
				polygons.push_back(next);
			}
		}
	}
	add_point(from.position);
	for (uint32_t polygon = from.polygon; polygon != to.polygon; polygon = _mesh->source(came_by[polygon])) {
		const NavLink &gap = _mesh->links()[came_by[polygon]];
		add_point((_mesh->point(gap.left) + _mesh->point(gap.right)) / 2.0f);
	}
	add_point(to.position);
}

void PathFinder::start(glm::vec3 goal) {
	_goal_position = goal;
	_nodes.resize(_graph->corners().count());
	_open.clear();
	if (++_search == 0) { // the counter came round: forget what bears old numbers
		std::fill(_nodes.begin(), _nodes.end(), Node());
		_search = 1;
	}
}

// The last corner of the best walk; none if it is straight. Its cost is `_goal_cost` then.
uint32_t PathFinder::search(const NavPoint &from, const NavPoint &to) {
	uint32_t last = no_corner;
	_goal_cost = _sight.straight(from, to);
	if (_goal_cost <= _mesh->least_cost() * glm::distance(from.position, to.position)) {
		return last;
	}
	start(to.position);
	const std::span<const SeenCorner> before_goal = _sight.look(to);
	_goal = _graph->goal(before_goal);
	for (const SeenCorner &seen : before_goal) {
		_nodes[seen.corner].goal_search = _search;
		_nodes[seen.corner].goal_cost = seen.cost;
	}
	for (const SeenCorner &seen : _sight.look(from)) {
		Node &node = _nodes[seen.corner];
		node.cost = seen.cost;
		node.estimate = estimate(seen.corner);
		node.previous = no_corner;
		node.search = _search;
		_open.push({ node.cost + node.estimate, seen.corner });
	}
	while (!_open.is_empty()) {
		const OpenList::Entry open = _open.pop();
		if (open.estimate >= _goal_cost) {
			break;
		}
		Node &node = _nodes[open.node];
		const float cost = node.cost;
		if (cost == closed) {
			continue; // a better way here was found in the meantime
		}
		node.cost = closed;
		if (node.goal_search == _search && cost + node.goal_cost < _goal_cost) {
			_goal_cost = cost + node.goal_cost;
			last = open.node;
		}
		walk_on(open.node, cost);
	}
	return last;
}

float PathFinder::estimate(uint32_t corner) const {
	const float crow = _mesh->least_cost() * glm::distance(_mesh->point(corner), _goal_position);
	return haste * std::max(crow, _graph->estimate(corner, _goal));
}

void PathFinder::walk_on(uint32_t corner, float cost) {
	const glm::vec3 here = _mesh->point(corner);
	Node *const nodes = _nodes.data();
	const uint32_t search = _search;
	_graph->walks().for_walks(corner, [&](uint32_t there, float ground) {
		Node &next = nodes[there];
		const bool is_new = next.search != search;
		if (!is_new && next.cost <= cost) {
			return; // the walk's own cost need not be known
		}
		const float cost_there = cost + ground * glm::distance(here, _mesh->point(there));
		if (is_new) {
			next.search = search;
			next.estimate = estimate(there);
		} else if (next.cost <= cost_there) {
			return;
		}
		next.cost = cost_there;
		next.previous = corner;
		_open.push({ cost_there + next.estimate, there });
	});
}

void PathFinder::collect(glm::vec3 from, uint32_t last_corner, glm::vec3 to) {
	_bends.clear();
	for (uint32_t corner = last_corner; corner != no_corner; corner = _nodes[corner].previous) {
		_bends.push_back(corner);
	}
	add_point(from);
	for (size_t i = _bends.size(); i-- > 0;) {
		add_point(_mesh->point(_bends[i]));
	}
	add_point(to);
	if (_points.size() == 1) {
		_points.push_back(to); // from and to are one place: still a walk of two points
	}
}

void PathFinder::add_point(glm::vec3 point) {
	if (!_points.empty() && is_same_place(_points.back(), point)) {
		return;
	}
	if (_points.size() > 1 && is_between(_points[_points.size() - 2], _points.back(), point)) {
		_points.pop_back();
	}
	_points.push_back(point);
}

} // namespace pcg
