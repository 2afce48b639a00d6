#include "core/city/footprint_layout.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/base/random.h"
#include "core/city/lot_overlaps.h"
#include "core/city/plan_layout.h"
#include "core/geometry/convex_parts.h"
#include "core/geometry/polygon.h"

namespace pcg {

namespace {

constexpr double tile_size = 40.0; // metres, about: overlays of few buildings are quick
constexpr double farthest = 50'000.0; // metres
constexpr double most_ground = 200e6; // square metres: a box of 14 by 14 km has 125,000 tiles
constexpr double least_area = 1.0; // square metres
constexpr double beside = 0.1; // metres from a side to where it is asked what lies there

struct Box {
	glm::dvec2 min{ INFINITY }, max{ -INFINITY };

	void add(glm::dvec2 point) {
		min = glm::min(min, point);
		max = glm::max(max, point);
	}
	Loop2 outline() const { return { min, { max.x, min.y }, max, { min.x, max.y } }; }
};

Box box_of(const Loop2 &loop) {
	Box box;
	for (const glm::dvec2 &point : loop) {
		box.add(point);
	}
	return box;
}

class FootprintBuilder {
public:
	FootprintBuilder(const std::vector<Footprint> &footprints, const LayoutParameters &p, Diagnostics &diagnostics) :
			_footprints(footprints), _p(p), _diagnostics(diagnostics) {}

	bool check() {
		const size_t before = _diagnostics.error_count();
		for (const Footprint &footprint : _footprints) {
			check(footprint);
		}
		if (_diagnostics.error_count() == before) {
			check_extent();
		}
		return _diagnostics.error_count() == before && !_footprints.empty();
	}

	std::optional<Layout> build() {
		make_tiles();
		for (uint32_t i = 0; i < _footprints.size(); ++i) {
			add_lot(i);
		}
		for (uint32_t tile = 0; tile < _tiles.size(); ++tile) {
			add_open_ground(tile);
		}
		report_overlaps();
		_layout.outline = to_ground(_extent.outline());
		_layout.seed = _p.seed;
		frame_layout(_layout);
		return _is_good ? std::optional<Layout>(std::move(_layout)) : std::nullopt;
	}

private:
	void error(const Footprint &footprint, const std::string &what, const std::string &hint) {
		_is_good = false;
		_diagnostics.error("bad-footprint", footprint.name + ": " + what, hint);
	}

	void check(const Footprint &footprint) {
		const Loop2 &loop = footprint.outline;
		const bool is_near = std::all_of(loop.begin(), loop.end(), [](glm::dvec2 p) { return std::abs(p.x) <= farthest && std::abs(p.y) <= farthest; });
		if (!is_near) {
			error(footprint, "it lies farther than 50 km from the origin", "cut the map into smaller ones");
		} else if (loop.size() < 3 || !(signed_area(loop) / 2.0 >= least_area)) {
			error(footprint, "its outline has less than 1 square metre", "leave it out, or draw it counter-clockwise with three corners or more");
		} else if (is_self_intersecting(loop)) {
			error(footprint, "its outline crosses itself", "draw it so that no two of its sides meet between their ends");
		}
	}

	void check_extent() {
		Box all;
		for (const Footprint &footprint : _footprints) {
			const Box box = box_of(footprint.outline);
			all.add(box.min);
			all.add(box.max);
		}
		const glm::dvec2 size = all.max - all.min;
		if (size.x * size.y > most_ground) {
			_diagnostics.error("too-large", "the footprints spread over " + std::to_string(std::lround(size.x / 1000.0)) + " by " +
							std::to_string(std::lround(size.y / 1000.0)) + " km, and one city has at most 200 square kilometres",
					"cut the map into smaller ones, or look for a footprint that lies far away by mistake");
		}
	}

	// Each footprint is listed in every tile that it touches.
	void make_tiles() {
		for (const Footprint &footprint : _footprints) {
			_boxes.push_back(box_of(footprint.outline));
			_extent.add(_boxes.back().min);
			_extent.add(_boxes.back().max);
		}
		const double around = double(_p.pavement_width) + double(_p.street_width);
		_extent = { _extent.min - around, _extent.max + around };
		const glm::dvec2 size = _extent.max - _extent.min;
		_columns = uint32_t(std::max(1.0, std::ceil(size.x / tile_size)));
		_rows = uint32_t(std::max(1.0, std::ceil(size.y / tile_size)));
		_tiles.resize(size_t(_columns) * _rows);
		_layout.blocks.resize(_tiles.size());
		for (uint32_t tile = 0; tile < _tiles.size(); ++tile) {
			_layout.blocks[tile].outline = to_ground(tile_box(tile).outline());
		}
		for (uint32_t i = 0; i < _boxes.size(); ++i) {
			for_tiles(_boxes[i], [&](uint32_t tile) { _tiles[tile].push_back(i); });
		}
	}

	Box tile_box(uint32_t tile) const {
		const glm::dvec2 size = (_extent.max - _extent.min) / glm::dvec2(_columns, _rows);
		const glm::dvec2 low = _extent.min + size * glm::dvec2(tile % _columns, tile / _columns);
		return { low, low + size };
	}

	glm::uvec2 cell_of(glm::dvec2 point) const {
		const glm::dvec2 cell = (point - _extent.min) / (_extent.max - _extent.min) * glm::dvec2(_columns, _rows);
		return { uint32_t(std::clamp(cell.x, 0.0, _columns - 1.0)), uint32_t(std::clamp(cell.y, 0.0, _rows - 1.0)) };
	}

	void for_tiles(const Box &box, auto action) const {
		const glm::uvec2 low = cell_of(box.min), high = cell_of(box.max);
		for (uint32_t row = low.y; row <= high.y; ++row) {
			for (uint32_t column = low.x; column <= high.x; ++column) {
				action(row * _columns + column);
			}
		}
	}

	bool is_built(glm::dvec2 point, uint32_t but) const {
		const glm::uvec2 cell = cell_of(point);
		const std::vector<uint32_t> &here = _tiles[cell.y * _columns + cell.x];
		return std::any_of(here.begin(), here.end(), [&](uint32_t i) { return i != but && contains(_footprints[i].outline, point); });
	}

	void add_lot(uint32_t index) {
		const Footprint &footprint = _footprints[index];
		Loop2 loop = footprint.outline;
		std::vector<float> widths;
		size_t front = loop.size();
		double front_length = 0.0;
		for (size_t i = 0; i < loop.size(); ++i) {
			const glm::dvec2 along = loop[(i + 1) % loop.size()] - loop[i];
			const glm::dvec2 outside = loop[i] + along / 2.0 + glm::dvec2(along.y, -along.x) * (beside / std::max(glm::length(along), beside));
			const bool is_open = !is_built(outside, index);
			widths.push_back(is_open ? _p.street_width : 0.0f);
			if (is_open && glm::length(along) > front_length) {
				front_length = glm::length(along);
				front = i;
			}
		}
		if (front == loop.size()) {
			error(footprint, "it is walled in by others on all sides, so nobody can enter it", "leave it out, or make it one with a neighbour");
			return;
		}
		std::rotate(loop.begin(), loop.begin() + ptrdiff_t(front), loop.end());
		std::rotate(widths.begin(), widths.begin() + ptrdiff_t(front), widths.end());
		const glm::uvec2 cell = cell_of((_boxes[index].min + _boxes[index].max) / 2.0);
		const BlockId block = BlockId(cell.y * _columns + cell.x);
		_layout.blocks[index_of(block)].lots.push_back(LotId(_layout.lots.size()));
		const bool is_known = std::any_of(_p.land_use.begin(), _p.land_use.end(), [&](const LandUse &use) { return use.type == footprint.type; });
		_layout.lots.push_back({ block, is_known ? footprint.type : std::string(), to_ground(loop), widths,
				derive_seed(_p.seed, _layout.lots.size()), footprint.height });
	}

	// What is left of the tile between the footprints. It is near the doors of all lots that reach into the tile.
	void add_open_ground(uint32_t tile) {
		Loops2 built;
		std::vector<uint32_t> near{ tile };
		for (uint32_t i : _tiles[tile]) {
			built.push_back(_footprints[i].outline);
			const glm::uvec2 cell = cell_of((_boxes[i].min + _boxes[i].max) / 2.0);
			near.push_back(cell.y * _columns + cell.x);
		}
		std::sort(near.begin(), near.end());
		near.erase(std::unique(near.begin(), near.end()), near.end());
		const Loops2 whole{ tile_box(tile).outline() };
		for (const Loops2 &open : built.empty() ? Polygons2{ whole } : overlay(whole, built, OverlayKind::Difference)) {
			for (const Loops2 &part : convex_parts(open, INFINITY)) {
				for (uint32_t block : near) {
					_layout.blocks[block].pavements.push_back(uint32_t(_layout.ground.size()));
				}
				_layout.ground.push_back({ GroundKind::Pavement, to_ground(part[0]), BlockId(tile), no_street });
			}
		}
	}

	void report_overlaps() {
		std::vector<Loop2> outlines;
		for (const Footprint &footprint : _footprints) {
			outlines.push_back(footprint.outline);
		}
		for (const OutlineOverlap &overlap : find_overlaps(outlines)) {
			_layout.overlaps.push_back({ LotId(overlap.a), LotId(overlap.b), float(overlap.area) });
			_diagnostics.warning("overlap", _footprints[overlap.a].name + " and " + _footprints[overlap.b].name + " overlap by " +
							std::to_string(int(std::round(overlap.area))) + " square metres", "draw them side by side");
		}
	}

	const std::vector<Footprint> &_footprints;
	const LayoutParameters &_p;
	Diagnostics &_diagnostics;
	bool _is_good = true;
	std::vector<Box> _boxes;
	Box _extent;
	uint32_t _columns = 1, _rows = 1;
	std::vector<std::vector<uint32_t>> _tiles; // footprints
	Layout _layout;
};

} // namespace

std::optional<Layout> layout_of_footprints(const std::vector<Footprint> &footprints, const LayoutParameters &parameters, Diagnostics &diagnostics) {
	if (footprints.empty()) {
		diagnostics.error("bad-footprint", "there are no footprints", "draw at least one");
		return std::nullopt;
	}
	FootprintBuilder builder(footprints, parameters, diagnostics);
	if (!builder.check()) {
		return std::nullopt;
	}
	std::optional<Layout> layout = builder.build();
	return layout && assign_types(*layout, parameters, diagnostics) ? std::move(layout) : std::nullopt;
}

} // namespace pcg
