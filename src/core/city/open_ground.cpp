#include "core/city/open_ground.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/geometry/sides.h"

namespace pcg {

namespace {

constexpr double least_way = 0.5; // metres
constexpr double same_line = 1e-3; // metres

// Metres that two sides which run against each other have in common.
double shared_length(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 d) {
	const double length = glm::distance(a, b);
	if (length < same_line) {
		return 0.0;
	}
	const glm::dvec2 along = (b - a) / length, across{ -along.y, along.x };
	if (std::max(std::abs(glm::dot(c - a, across)), std::abs(glm::dot(d - a, across))) > same_line) {
		return 0.0;
	}
	return std::min(length, glm::dot(c - a, along)) - std::max(0.0, glm::dot(d - a, along));
}

bool may_touch(const Box2 &a, const Box2 &b) {
	return a.min.x <= b.max.x + same_line && b.min.x <= a.max.x + same_line && a.min.y <= b.max.y + same_line && b.min.y <= a.max.y + same_line;
}

bool has_way(const Loop2 &one, const Loop2 &other) {
	for (size_t i = 0; i < one.size(); ++i) {
		for (size_t j = 0; j < other.size(); ++j) {
			if (shared_length(one[i], one[(i + 1) % one.size()], other[j], other[(j + 1) % other.size()]) >= least_way) {
				return true;
			}
		}
	}
	return false;
}

} // namespace

// From the map's edge, which is open all around, from piece to piece.
OpenGround::OpenGround(const FootprintMap &map) : _map(map) {
	const Loop2 edge = map.outline();
	std::vector<std::pair<uint32_t, uint32_t>> waiting;
	for (uint32_t tile = 0; tile < map.tile_count(); ++tile) {
		_pieces.push_back(map.open_ground(tile));
		_is_reached.emplace_back(_pieces.back().size(), false);
		std::vector<Box2> &boxes = _boxes.emplace_back();
		for (const Loop2 &piece : _pieces.back()) {
			boxes.push_back(box_of(piece));
		}
	}
	const Loop2 beyond(edge.rbegin(), edge.rend()); // runs against what touches it from within
	for (uint32_t tile = 0; tile < map.tile_count(); ++tile) {
		reach(tile, beyond, box_of(beyond), waiting);
	}
	while (!waiting.empty()) {
		const auto [tile, piece] = waiting.back();
		waiting.pop_back();
		for (const uint32_t near : map.tiles_around(tile)) {
			reach(near, _pieces[tile][piece], _boxes[tile][piece], waiting);
		}
	}
}

void OpenGround::reach(uint32_t tile, const Loop2 &from, const Box2 &box, std::vector<std::pair<uint32_t, uint32_t>> &waiting) {
	for (uint32_t i = 0; i < _pieces[tile].size(); ++i) {
		if (!_is_reached[tile][i] && may_touch(box, _boxes[tile][i]) && has_way(from, _pieces[tile][i])) {
			_is_reached[tile][i] = true;
			waiting.push_back({ tile, i });
		}
	}
}

bool OpenGround::is_enclosed(glm::dvec2 point) const {
	const uint32_t tile = _map.tile_at(point);
	for (size_t i = 0; i < _pieces[tile].size(); ++i) {
		if (contains(_pieces[tile][i], point)) {
			return !_is_reached[tile][i];
		}
	}
	return false;
}

} // namespace pcg
