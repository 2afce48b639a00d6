#include "core/navigation/path_finder.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace pcg {

namespace {

// What lies ahead counts a little more than what lies behind: of ways that cost about the same the one that has come farthest is followed. A walk
// costs at most so many times the least possible; in cities it hardly shows.
constexpr float haste = 1.05f;
// Metres. Estimates by landmarks go from middle to middle of gaps, which is not quite what people walk: near the goal the straight line decides.
constexpr float slack = 3.0f;

// Of the plan: positive if `c` lies left of the direction from `a` to `b`, seen from above.
float side(glm::vec3 a, glm::vec3 b, glm::vec3 c) { return (c.x - a.x) * (b.z - a.z) - (c.z - a.z) * (b.x - a.x); }

// Where the straight way from `from` to `to` passes the gap, or the end of the gap that is closest to it: walks that bend only where they must.
glm::vec3 pass(const NavLink &link, glm::vec3 from, glm::vec3 to) {
	const float left = side(from, to, link.left), right = side(from, to, link.right);
	if (left <= 0.0f) { // the whole gap lies right of the way (or turned around: then either end will do)
		return link.left;
	}
	if (right >= 0.0f) {
		return link.right;
	}
	return link.right + (link.left - link.right) * (right / (right - left));
}

bool is_same_place(glm::vec3 a, glm::vec3 b) { return std::abs(a.x - b.x) < 1e-4f && std::abs(a.z - b.z) < 1e-4f; }

} // namespace

bool PathFinder::find(const NavPoint &from, const NavPoint &to) {
	_points.clear();
	_corridor.clear();
	_length = 0.0;
	if (!from.is_on_mesh() || !to.is_on_mesh() || _mesh->component(from.polygon) != _mesh->component(to.polygon)) {
		return false;
	}
	if (from.polygon != to.polygon) {
		start();
		if (!search(from, to)) {
			return false;
		}
		collect_corridor(_goal_link);
	}
	pull_tight(from.position, to.position);
	for (size_t i = 1; i < _points.size(); ++i) {
		_length += double(glm::distance(_points[i - 1], _points[i]));
	}
	return true;
}

void PathFinder::start() {
	_nodes.resize(_mesh->links().size());
	_entries.resize(_mesh->polygon_count());
	_open.clear();
	_goal_link = no_link;
	_goal_cost = INFINITY;
	if (++_search == 0) { // the counter came round: forget what bears old numbers
		std::fill(_nodes.begin(), _nodes.end(), Node());
		std::fill(_entries.begin(), _entries.end(), Entry());
		_search = 1;
	}
}

bool PathFinder::search(const NavPoint &from, const NavPoint &to) {
	_goal_costs = _mesh->landmarks().of_point(*_mesh, to);
	expand(from.polygon, no_link, from.position, 0.0f, to);
	while (!_open.is_empty()) {
		const OpenList::Entry open = _open.pop();
		if (open.link == no_link) {
			return true;
		}
		Node &node = _nodes[open.link];
		if (node.is_closed) {
			continue; // a better way here was found in the meantime
		}
		node.is_closed = true;
		const uint32_t polygon = _mesh->links()[open.link].target;
		if (polygon == to.polygon) {
			const float cost = node.cost + _mesh->cost(polygon) * glm::distance(node.point, to.position);
			if (cost < _goal_cost) {
				_goal_cost = cost;
				_goal_link = open.link;
				_open.push({ cost, no_link });
			}
			continue;
		}
		if (!is_dominated(polygon, node.point, node.cost)) {
			expand(polygon, open.link, node.point, node.cost, to);
		}
	}
	return false;
}

// Polygons are convex: who came in elsewhere can walk straight to `point`, and did better if that costs no more.
bool PathFinder::is_dominated(uint32_t polygon, glm::vec3 point, float cost) const {
	const Entry &entry = _entries[polygon];
	return entry.search == _search && entry.cost + _mesh->cost(polygon) * glm::distance(entry.point, point) <= cost;
}

void PathFinder::expand(uint32_t polygon, uint32_t from_link, glm::vec3 point, float cost, const NavPoint &to) {
	const std::vector<NavLink> &links = _mesh->links();
	const uint32_t came_from = from_link == no_link ? no_polygon : links[from_link].source;
	const float ground = _mesh->cost(polygon), least = _mesh->least_cost();
	const uint32_t end = _mesh->first_link(polygon + 1);
	if (_entries[polygon].search != _search) {
		_entries[polygon] = { _search, cost, point };
	}
	for (uint32_t i = _mesh->first_link(polygon); i < end; ++i) {
		if (links[i].target == came_from) {
			continue;
		}
		const glm::vec3 next = pass(links[i], point, to.position);
		const float next_cost = cost + ground * glm::distance(point, next);
		Node &node = _nodes[i];
		if (node.search == _search && (node.is_closed || node.cost <= next_cost)) {
			continue;
		}
		if (is_dominated(links[i].target, next, next_cost)) {
			continue;
		}
		node = { next_cost, from_link, _search, false, next };
		const float crow = least * glm::distance(next, to.position);
		const float known = Landmarks::estimate(_mesh->landmarks().of_link(i), _goal_costs);
		_open.push({ next_cost + std::max(crow, haste * known - slack), i });
	}
}

void PathFinder::collect_corridor(uint32_t last_link) {
	for (uint32_t link = last_link; link != no_link; link = _nodes[link].previous) {
		_corridor.push_back(link);
	}
	std::reverse(_corridor.begin(), _corridor.end());
}

void PathFinder::add_point(glm::vec3 point) {
	if (_points.empty() || !is_same_place(_points.back(), point)) {
		_points.push_back(point);
	}
}

// The funnel algorithm (Lee and Preparata 1984; Mononen 2010): a wedge from the apex to the sides of the gap is narrowed gap by gap; where one
// side crosses the other, the walk bends around that other side's corner, which becomes the apex.
void PathFinder::pull_tight(glm::vec3 from, glm::vec3 to) {
	const std::vector<NavLink> &links = _mesh->links();
	const size_t gaps = _corridor.size() + 1; // the last one is the goal, without width
	const auto left_of = [&](size_t i) { return i < _corridor.size() ? links[_corridor[i]].left : to; };
	const auto right_of = [&](size_t i) { return i < _corridor.size() ? links[_corridor[i]].right : to; };
	glm::vec3 apex = from, left = left_of(0), right = right_of(0);
	size_t left_index = 0, right_index = 0;
	add_point(from);
	for (size_t i = 1; i < gaps; ++i) {
		const glm::vec3 new_left = left_of(i), new_right = right_of(i);
		if (side(apex, right, new_right) >= 0.0f) {
			if (is_same_place(apex, right) || side(apex, left, new_right) < 0.0f) {
				right = new_right;
				right_index = i;
			} else {
				add_point(left);
				apex = right = left;
				i = right_index = left_index;
				continue;
			}
		}
		if (side(apex, left, new_left) <= 0.0f) {
			if (is_same_place(apex, left) || side(apex, right, new_left) > 0.0f) {
				left = new_left;
				left_index = i;
			} else {
				add_point(right);
				apex = left = right;
				i = left_index = right_index;
				continue;
			}
		}
	}
	add_point(to);
	if (_points.size() == 1) {
		_points.push_back(to); // from and to are one place: still a walk of two points
	}
}

} // namespace pcg
