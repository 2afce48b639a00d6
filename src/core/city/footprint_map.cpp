#include "core/city/footprint_map.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/geometry/convex_parts.h"
#include "core/geometry/sides.h"

namespace pcg {

namespace {

constexpr double tile_size = 40.0; // metres, about: overlays of few outlines are quick
constexpr double farthest = 50'000.0; // metres
constexpr double most_ground = 200e6; // square metres: a box of 14 by 14 km has 125,000 tiles
constexpr double least_area = 1.0; // square metres

bool is_finite(const Loop2 &loop) {
	return std::all_of(loop.begin(), loop.end(), [](glm::dvec2 p) { return std::isfinite(p.x) && std::isfinite(p.y); });
}

bool is_near(const Loop2 &loop) {
	return std::all_of(loop.begin(), loop.end(), [](glm::dvec2 p) { return std::abs(p.x) <= farthest && std::abs(p.y) <= farthest; });
}

// Holes that lie apart and within the outline are what is left of them.
bool are_holes_apart(const Footprint &footprint) {
	Loops2 holes;
	double area = signed_area(footprint.outline);
	for (const Loop2 &hole : footprint.holes) {
		holes.push_back(hole);
		area -= signed_area(hole);
	}
	const Polygons2 left = overlay({ footprint.outline }, holes, OverlayKind::Difference);
	if (left.size() != 1 || left[0].size() != 1 + holes.size()) {
		return false;
	}
	for (const Loop2 &loop : left[0]) {
		area -= signed_area(loop);
	}
	return std::abs(area) < 0.01 * least_area;
}

// An outline or a hole. True if it is sound.
bool check(const Footprint &footprint, const Loop2 &loop, const char *what, Diagnostics &diagnostics) {
	const auto error = [&](const char *problem, const char *hint) {
		diagnostics.error("bad-footprint", footprint.name + ": " + what + problem, hint);
		return false;
	};
	if (!is_finite(loop)) {
		return error(" has a corner that is nowhere: its coordinates are not finite numbers", "look at its points, and at its place in the scene");
	}
	if (!is_near(loop)) {
		return error(" lies farther than 50 km from the origin", "cut the map into smaller ones");
	}
	if (loop.size() < 3 || !(signed_area(loop) / 2.0 >= least_area)) {
		return error(" has less than 1 square metre", "leave it out, or draw it counter-clockwise with three corners or more");
	}
	return !is_self_intersecting(loop) || error(" crosses itself", "draw it so that no two of its sides meet between their ends");
}

void check(const Footprint &footprint, Diagnostics &diagnostics) {
	if (footprint.height != sound_height(footprint)) {
		diagnostics.warning("bad-height", footprint.name + ": its height is none from 0 to 2000 m and is ignored", "write metres as a number");
	}
	bool is_sound = check(footprint, footprint.outline, "its outline", diagnostics);
	for (const Loop2 &hole : footprint.holes) {
		is_sound = is_sound && check(footprint, hole, "a hole in it", diagnostics);
	}
	if (is_sound && !footprint.holes.empty() && !are_holes_apart(footprint)) {
		diagnostics.error("bad-footprint", footprint.name + ": a hole in it meets its outline or another hole, or lies outside",
				"draw holes within the outline and apart from each other");
	}
}

void check_extent(const std::vector<Footprint> &footprints, Diagnostics &diagnostics) {
	Box2 all;
	for (const Footprint &footprint : footprints) {
		const Box2 box = box_of(footprint.outline);
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

float sound_height(const Footprint &footprint) {
	return footprint.height >= 0.0f && footprint.height <= tallest_footprint ? footprint.height : 0.0f; // NaN: 0
}

std::vector<OutlineOverlap> report_overlaps(const std::vector<Footprint> &footprints, Diagnostics &diagnostics) {
	std::vector<Loops2> polygons;
	for (const Footprint &footprint : footprints) {
		polygons.push_back(polygon_of(footprint));
	}
	std::vector<OutlineOverlap> overlaps = find_overlaps(polygons);
	for (const OutlineOverlap &overlap : overlaps) {
		diagnostics.warning("overlap", footprints[overlap.a].name + " and " + footprints[overlap.b].name + " overlap by " +
						std::to_string(int(std::round(overlap.area))) + " square metres", "draw them side by side");
	}
	return overlaps;
}

Loops2 polygon_of(const Footprint &footprint) {
	Loops2 polygon{ footprint.outline };
	for (const Loop2 &hole : footprint.holes) {
		polygon.push_back(hole);
		std::reverse(polygon.back().begin(), polygon.back().end());
	}
	return polygon;
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
	return Box2{ low, low + size }.outline();
}

std::vector<uint32_t> FootprintMap::tiles_around(uint32_t tile) const {
	std::vector<uint32_t> tiles{ tile };
	const uint32_t column = tile % _columns, row = tile / _columns;
	if (column > 0) {
		tiles.push_back(tile - 1);
	}
	if (column + 1 < _columns) {
		tiles.push_back(tile + 1);
	}
	if (row > 0) {
		tiles.push_back(tile - _columns);
	}
	if (row + 1 < _rows) {
		tiles.push_back(tile + _columns);
	}
	return tiles;
}

uint32_t FootprintMap::home_of(uint32_t footprint) const { return tile_at((_boxes[footprint].min + _boxes[footprint].max) / 2.0); }

glm::uvec2 FootprintMap::cell_of(glm::dvec2 point) const {
	const glm::dvec2 cell = (point - _extent.min) / (_extent.max - _extent.min) * glm::dvec2(_columns, _rows);
	return { uint32_t(std::clamp(cell.x, 0.0, _columns - 1.0)), uint32_t(std::clamp(cell.y, 0.0, _rows - 1.0)) };
}

void FootprintMap::for_tiles(const Box2 &box, auto action) const {
	const glm::uvec2 low = cell_of(box.min), high = cell_of(box.max);
	for (uint32_t row = low.y; row <= high.y; ++row) {
		for (uint32_t column = low.x; column <= high.x; ++column) {
			action(row * _columns + column);
		}
	}
}

bool FootprintMap::is_built(glm::dvec2 point, uint32_t but) const {
	const std::vector<uint32_t> &here = _tiles[tile_at(point)];
	return std::any_of(here.begin(), here.end(), [&](uint32_t i) {
		const std::vector<Loop2> &holes = _footprints[i].holes;
		return i != but && contains(_footprints[i].outline, point) &&
				std::none_of(holes.begin(), holes.end(), [&](const Loop2 &hole) { return contains(hole, point); });
	});
}

uint32_t FootprintMap::around(uint32_t footprint) const {
	const Loop2 &inner = _footprints[footprint].outline;
	uint32_t found = uint32_t(_footprints.size());
	double smallest = INFINITY;
	for (const uint32_t i : _tiles[home_of(footprint)]) {
		const double area = signed_area(_footprints[i].outline);
		if (area < smallest && stands_in_hole(inner, polygon_of(_footprints[i]))) {
			found = i;
			smallest = area;
		}
	}
	return found;
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
	Box2 way;
	way.add(from);
	way.add(from + direction * reach);
	for_tiles(way, [&](uint32_t tile) {
		for (const uint32_t i : _tiles[tile]) {
			nearest = std::min(nearest, way_to(_footprints[i].outline, from, direction));
			for (const Loop2 &hole : _footprints[i].holes) {
				nearest = std::min(nearest, way_to(hole, from, direction));
			}
		}
	});
	return nearest;
}

} // namespace pcg
