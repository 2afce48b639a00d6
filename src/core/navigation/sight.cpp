#include "core/navigation/sight.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/navigation/plan.h"

namespace pcg {

namespace {

constexpr float graze = 1e-4f; // metres that lines of sight may cut corners by

} // namespace

void Sight::begin(glm::vec3 root, uint32_t corner) {
	_root = root;
	_root_corner = corner;
	_cones.clear();
	_overlapping = 0;
	_seen.clear();
	if (++_look == 0) { // the counter came round
		std::fill(_places.begin(), _places.end(), Place());
		std::fill(_entries.begin(), _entries.end(), Entry());
		_look = 1;
	}
}

std::span<const SeenCorner> Sight::look(const NavPoint &from) {
	begin(from.position, no_corner);
	_starts.assign(1, from.polygon);
	add_touching(*_mesh, _root, 0.0f, _starts);
	spread();
	return _seen;
}

std::span<const SeenCorner> Sight::look(uint32_t corner, std::span<const uint32_t> polygons) {
	begin(_mesh->point(corner), corner);
	_starts.assign(polygons.begin(), polygons.end());
	spread();
	return _seen;
}

float Sight::straight(const NavPoint &from, const NavPoint &to) {
	begin(from.position, no_corner);
	_has_aim = true;
	_aim = to.position;
	_aim_cost = INFINITY;
	_aim_polygons.assign(1, to.polygon);
	add_touching(*_mesh, _aim, 0.0f, _aim_polygons);
	_starts.assign(1, from.polygon);
	add_touching(*_mesh, _root, 0.0f, _starts);
	spread();
	_has_aim = false;
	return _aim_cost;
}

PlanBox Sight::extent() const {
	PlanBox box;
	box.add(_root);
	for (const Cone &cone : _cones) {
		box.add(_mesh->point(_mesh->links()[cone.link].left));
		box.add(_mesh->point(_mesh->links()[cone.link].right));
	}
	for (const SeenCorner &seen : _seen) {
		box.add(_mesh->point(seen.corner));
	}
	return box;
}

void Sight::spread() {
	for (const uint32_t polygon : _starts) {
		_entries[polygon] = { _look, no_cone };
	}
	for (size_t i = 0; i < _starts.size(); ++i) {
		_ground = _mesh->cost(_starts[i]);
		const size_t first = _cones.size();
		look_around(_starts[i]);
		for (size_t cone = first; cone < _cones.size() && !is_cut_short(); ++cone) {
			look_through(uint32_t(cone));
		}
	}
}

void Sight::aim_into(uint32_t polygon) {
	if (std::find(_aim_polygons.begin(), _aim_polygons.end(), polygon) != _aim_polygons.end()) {
		_aim_cost = std::fmin(_aim_cost, _ground * glm::distance(_root, _aim));
	}
}

// From within a polygon, or from its border: all its gaps, but those that the root stands in, which lead to polygons that are starts, too.
void Sight::look_around(uint32_t polygon) {
	if (_has_aim) {
		aim_into(polygon);
	}
	for (uint32_t i = _mesh->first_link(polygon); i < _mesh->first_link(polygon + 1); ++i) {
		const NavLink &link = _mesh->links()[i];
		const glm::vec3 left_end = _mesh->point(link.left), right_end = _mesh->point(link.right);
		see(_corners->at(link.left));
		see(_corners->at(link.right));
		if (distance_to_segment(_root, left_end, right_end) >= touch) {
			const Ray left = ray_to(left_end), right = ray_to(right_end);
			if (!is_needless(left, right)) {
				enter(polygon, i, left, right);
			}
		}
	}
}

// Lines of sight may cut corners a little.
float Sight::slack_of(Ray ray) { return graze * (std::abs(ray.x) + std::abs(ray.z)); }

void Sight::look_through(uint32_t index) {
	const Cone cone = _cones[index];
	if (_has_aim) { // no other cones are entered than those with the aim in them
		aim_into(cone.polygon);
	}
	for (uint32_t i = _mesh->first_link(cone.polygon); i < _mesh->first_link(cone.polygon + 1); ++i) {
		const NavLink &link = _mesh->links()[i];
		const Ray left = ray_to(_mesh->point(link.left)), right = ray_to(_mesh->point(link.right));
		const float left_slack = slack_of(left), right_slack = slack_of(right);
		if (link.target == cone.source || turn(cone.left, right) > right_slack || turn(cone.right, left) < -left_slack) {
			continue;
		}
		const float beyond_left = turn(cone.left, left), beyond_right = -turn(cone.right, right);
		if (beyond_left <= left_slack) {
			see(_corners->at(link.left));
		}
		if (beyond_right <= right_slack) {
			see(_corners->at(link.right));
		}
		const Ray new_left = beyond_left > 0.0f ? cone.left : left, new_right = beyond_right > 0.0f ? cone.right : right;
		if (!_has_aim || !is_needless(new_left, new_right)) {
			enter(cone.polygon, i, new_left, new_right);
		}
	}
}

void Sight::enter(uint32_t source, uint32_t link, Ray left, Ray right) {
	const uint32_t polygon = _mesh->links()[link].target;
	if (_mesh->cost(polygon) != _ground || turn(right, left) <= 1e-6f || is_known(polygon, left, right)) {
		return;
	}
	Entry &entry = _entries[polygon];
	const uint32_t earlier = entry.look == _look ? entry.last : no_cone;
	_overlapping += earlier != no_cone && overlap(_cones[earlier], left, right);
	entry = { _look, uint32_t(_cones.size()) };
	_cones.push_back({ polygon, link, source, earlier, left, right });
}

// Whether nothing between the two directions is looked for. Directions in which no walk bends around the wall at the root lie beside each other.
bool Sight::is_needless(Ray left, Ray right) const {
	if (_has_aim) {
		const Ray aim = ray_to(_aim);
		return turn(left, aim) > slack_of(aim) || turn(right, aim) < -slack_of(aim);
	}
	const auto is_bend = [this](Ray ray) { return _corners->is_bend(_root_corner, { -ray.x, 0.0f, -ray.z }); };
	return _root_corner != no_corner && !is_bend(left) && !is_bend(right);
}

// Whether a wider cone is in the polygon already. On plain ground that cannot be, but where polygons overlap, at seams, cones would go round for ever.
bool Sight::is_known(uint32_t polygon, Ray left, Ray right) const {
	const Entry &entry = _entries[polygon];
	if (entry.look != _look) {
		return false;
	}
	uint32_t cone = entry.last;
	while (cone != no_cone && (turn(_cones[cone].left, left) > 0.0f || turn(_cones[cone].right, right) < 0.0f)) {
		cone = _cones[cone].earlier;
	}
	return cone != no_cone || entry.last == no_cone;
}

void Sight::see(uint32_t corner) {
	if (corner == no_corner || corner == _root_corner || _has_aim) {
		return;
	}
	const glm::vec3 position = _mesh->point(corner);
	Place &place = _places[corner];
	if (place.look != _look) {
		place = { _look, not_seen };
		if (_corners->is_bend(corner, position - _root) && (_root_corner == no_corner || _corners->is_bend(_root_corner, _root - position))) {
			place.seen = uint32_t(_seen.size());
			_seen.push_back({ corner, _ground * glm::distance(_root, position) });
		}
	} else if (place.seen != not_seen) {
		_seen[place.seen].cost = std::fmin(_seen[place.seen].cost, _ground * glm::distance(_root, position));
	}
}

} // namespace pcg
