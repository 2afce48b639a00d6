#include "core/sim/walk_pool.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace pcg {

double Walk::metres_at(SimTime time) const {
	return time >= arrival ? length : std::clamp((time - departure).in_seconds() * double(speed), 0.0, length);
}

glm::vec3 Walk::position_at(SimTime time) const { return point_along(points, metres_at(time)); }

glm::vec3 point_along(std::span<const glm::vec3> points, double metres, glm::vec3 *direction) {
	double left = metres;
	for (size_t i = 0; i + 1 < points.size(); ++i) {
		const double length = double(glm::distance(points[i], points[i + 1]));
		const bool is_last = i + 2 == points.size();
		if (left <= length || is_last) {
			const double share = length > 0.0 ? std::clamp(left / length, 0.0, 1.0) : 1.0;
			if (direction && length > 0.0) {
				*direction = (points[i + 1] - points[i]) / float(length);
			}
			return share >= 1.0 ? points[i + 1] : points[i] + (points[i + 1] - points[i]) * float(share);
		}
		left -= length;
	}
	return points.empty() ? glm::vec3(0.0f) : points.back();
}

double path_length(std::span<const glm::vec3> points) {
	double sum = 0.0;
	for (size_t i = 0; i + 1 < points.size(); ++i) {
		sum += double(glm::distance(points[i], points[i + 1]));
	}
	return sum;
}

void rest_of(const Walk &walk, SimTime time, std::vector<glm::vec3> &points) {
	const double walked = walk.metres_at(time);
	points.assign(1, point_along(walk.points, walked));
	double metres = 0.0;
	for (size_t i = 1; i < walk.points.size(); ++i) {
		metres += double(glm::distance(walk.points[i - 1], walk.points[i]));
		if (metres > walked || i + 1 == walk.points.size()) {
			points.push_back(walk.points[i]);
		}
	}
}

uint32_t WalkPool::add(std::span<const glm::vec3> points, SimTime departure, float speed, uint32_t walkers) {
	uint32_t index = uint32_t(_walks.size());
	if (_free.empty()) {
		_walks.emplace_back();
		_free.reserve(_walks.capacity());
	} else {
		index = _free.back();
		_free.pop_back();
	}
	Walk &walk = _walks[index];
	walk.points.assign(points.begin(), points.end());
	walk.length = path_length(walk.points);
	walk.departure = departure;
	walk.arrival = departure + Duration::seconds(walk.length / double(speed));
	walk.speed = speed;
	walk.walkers = walkers;
	return index;
}

void WalkPool::leave(uint32_t index) {
	Walk &walk = _walks[index];
	if (--walk.walkers == 0) {
		walk.points.clear();
		_free.push_back(index);
	}
}

void WalkPool::clear() {
	_walks.clear();
	_free.clear();
}

void WalkPool::restore(std::vector<Walk> walks) {
	_walks = std::move(walks);
	_free.clear();
	_free.reserve(_walks.capacity());
	for (Walk &walk : _walks) {
		walk.walkers = 0;
	}
}

} // namespace pcg
