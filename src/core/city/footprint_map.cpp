#include "core/city/footprint_map.h"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/geometry/convex_parts.h"
#include "core/geometry/polygon.h"

namespace pcg {

namespace {

constexpr double tile_size = 40.0; // metres, about: overlays of few outlines are quick
constexpr double farthest = 50'000.0; // metres
constexpr double most_ground = 200e6; // square metres: a box of 14 by 14 km has 125,000 tiles
constexpr double least_area = 1.0; // square metres

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

PlanBox box_of(const Loop2 &loop) {
	PlanBox box;
	for (const glm::dvec2 &point : loop) {
		box.add(point);
	}
	return box;
}

void check(const Footprint &footprint, Diagnostics &diagnostics) {
	const Loop2 &loop = footprint.outline;
	const bool is_near = std::all_of(loop.begin(), loop.end(), [](glm::dvec2 p) { return std::abs(p.x) <= farthest && std::abs(p.y) <= farthest; });
	const auto error = [&](const char *what, const char *hint) { diagnostics.error("bad-footprint", footprint.name + ": " + what, hint); };
	if (!is_near) {
		error("it lies farther than 50 km from the origin", "cut the map into smaller ones");
	} else if (loop.size() < 3 || !(signed_area(loop) / 2.0 >= least_area)) {
		error("its outline has less than 1 square metre", "leave it out, or draw it counter-clockwise with three corners or more");
	} else if (is_self_intersecting(loop)) {
		error("its outline crosses itself", "draw it so that no two of its sides meet between their ends");
	}
}

void check_extent(const std::vector<Footprint> &footprints, Diagnostics &diagnostics) {
	PlanBox all;
	for (const Footprint &footprint : footprints) {
		const PlanBox box = box_of(footprint.outline);
		all.add(box.min);
		all.add(box.max);
	}
	const glm::dvec2 size = all.max - all.min;
	if (size.x * size.y > most_ground) {
		diagnostics.error("too-large", "the footprints spread over " + std::to_string(std::lround(size.x / 1000.0)) + " by " +
						std::to_string(std::lround(size.y / 1000.0)) + " km, and one city has at most 200 square kilometres",
				"cut the map into smaller ones, or look for a footprint that lies far away by mistake");
	}
}

} // namespace

void PlanBox::add(glm::dvec2 point) {
	min = glm::min(min, point);
	max = glm::max(max, point);
}

bool check_footprints(const std::vector<Footprint> &footprints, Diagnostics &diagnostics) {
	const size_t before = diagnostics.error_count();
	if (footprints.empty()) {
		diagnostics.error("bad-footprint", "there are no footprints", "draw at least one");
	}
	for (const Footprint &footprint : footprints) {
		check(footprint, diagnostics);
	}
	if (diagnostics.error_count() == before) {
		check_extent(footprints, diagnostics);
	}
	return diagnostics.error_count() == before;
}

std::vector<OutlineOverlap> report_overlaps(const std::vector<Footprint> &footprints, Diagnostics &diagnostics) {
	std::vector<Loop2> outlines;
	for (const Footprint &footprint : footprints) {
		outlines.push_back(footprint.outline);
	}
	std::vector<OutlineOverlap> overlaps = find_overlaps(outlines);
	for (const OutlineOverlap &overlap : overlaps) {
		diagnostics.warning("overlap", footprints[overlap.a].name + " and " + footprints[overlap.b].name + " overlap by " +
						std::to_string(int(std::round(overlap.area))) + " square metres", "draw them side by side");
	}
	return overlaps;
}

std::string known_type(const Footprint &footprint, const LayoutParameters &p) {
	const bool is_known = std::any_of(p.land_use.begin(), p.land_use.end(), [&](const LandUse &use) { return use.type == footprint.type; });
	return is_known ? footprint.type : std::string();
}

FootprintMap::FootprintMap(const std::vector<Footprint> &footprints, double around) : _footprints(footprints) {
	for (const Footprint &footprint : footprints) {
		_boxes.push_back(box_of(footprint.outline));
		_extent.add(_boxes.back().min);
		_extent.add(_boxes.back().max);
	}
	_extent = { _extent.min - around, _extent.max + around };
	const glm::dvec2 size = _extent.max - _extent.min;
	_columns = uint32_t(std::max(1.0, std::ceil(size.x / tile_size)));
	_rows = uint32_t(std::max(1.0, std::ceil(size.y / tile_size)));
	_tiles.resize(size_t(_columns) * _rows);
	for (uint32_t i = 0; i < _boxes.size(); ++i) {
		for_tiles(_boxes[i], [&](uint32_t tile) { _tiles[tile].push_back(i); });
	}
}

Loop2 FootprintMap::tile_outline(uint32_t tile) const {
	const glm::dvec2 size = (_extent.max - _extent.min) / glm::dvec2(_columns, _rows);
	const glm::dvec2 low = _extent.min + size * glm::dvec2(tile % _columns, tile / _columns);
	return PlanBox{ low, low + size }.outline();
}

uint32_t FootprintMap::home_of(uint32_t footprint) const { return tile_at((_boxes[footprint].min + _boxes[footprint].max) / 2.0); }

glm::uvec2 FootprintMap::cell_of(glm::dvec2 point) const {
	const glm::dvec2 cell = (point - _extent.min) / (_extent.max - _extent.min) * glm::dvec2(_columns, _rows);
	return { uint32_t(std::clamp(cell.x, 0.0, _columns - 1.0)), uint32_t(std::clamp(cell.y, 0.0, _rows - 1.0)) };
}

void FootprintMap::for_tiles(const PlanBox &box, auto action) const {
	const glm::uvec2 low = cell_of(box.min), high = cell_of(box.max);
	for (uint32_t row = low.y; row <= high.y; ++row) {
		for (uint32_t column = low.x; column <= high.x; ++column) {
			action(row * _columns + column);
		}
	}
}

bool FootprintMap::is_built(glm::dvec2 point, uint32_t but) const {
	const std::vector<uint32_t> &here = _tiles[tile_at(point)];
	return std::any_of(here.begin(), here.end(), [&](uint32_t i) { return i != but && contains(_footprints[i].outline, point); });
}

Loops2 FootprintMap::open_ground(uint32_t tile) const {
	Loops2 built, pieces;
	for (uint32_t i : _tiles[tile]) {
		built.push_back(_footprints[i].outline);
	}
	const Loops2 whole{ tile_outline(tile) };
	for (const Loops2 &open : built.empty() ? Polygons2{ whole } : overlay(whole, built, OverlayKind::Difference)) {
		for (const Loops2 &part : convex_parts(open, INFINITY)) {
			pieces.push_back(part[0]);
		}
	}
	return pieces;
}

double FootprintMap::free_way(glm::dvec2 from, glm::dvec2 direction, double reach) const {
	double nearest = reach;
	PlanBox way;
	way.add(from);
	way.add(from + direction * reach);
	for_tiles(way, [&](uint32_t tile) {
		for (const uint32_t i : _tiles[tile]) {
			const Loop2 &loop = _footprints[i].outline;
			for (size_t side = 0; side < loop.size(); ++side) {
				const glm::dvec2 a = loop[side] - from, b = loop[(side + 1) % loop.size()] - from;
				const double below = cross(direction, a), above = cross(direction, b);
				if ((below < 0.0) != (above < 0.0)) {
					const double metres = glm::dot(a + (b - a) * (below / (below - above)), direction);
					nearest = metres >= 0.0 ? std::min(nearest, metres) : nearest;
				}
			}
		}
	});
	return nearest;
}

} // namespace pcg
