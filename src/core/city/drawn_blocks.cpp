#include "core/city/drawn_blocks.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/city/block_division.h"
#include "core/city/footprint_map.h"
#include "core/city/plan_layout.h"
#include "core/geometry/sides.h"

namespace pcg {

namespace {

constexpr double smoothed = 0.05; // of a lot's front: so far an outline may be moved to have fewer corners
constexpr double widest_street = 40.0; // metres
constexpr double narrowest_street = 2.0; // metres; blocks that touch have pavements between their lots
constexpr double in_front = 1e-3; // metres from a side to where its street begins
constexpr size_t named_blocks = 5; // in a message

// Of the corners from `first` to `last` (numbers count on around the loop), marks those without which the outline would move by more than `tolerance` (Douglas
// and Peucker).
void mark_corners(const Loop2 &loop, size_t first, size_t last, double tolerance, std::vector<bool> &is_kept) {
	std::vector<std::pair<size_t, size_t>> waiting{ { first, last } };
	while (!waiting.empty()) {
		const auto [from, to] = waiting.back();
		waiting.pop_back();
		size_t farthest = from;
		double most = tolerance;
		for (size_t i = from + 1; i < to; ++i) {
			const double away = distance_to(loop[from % loop.size()], loop[to % loop.size()], loop[i % loop.size()]);
			if (away > most) {
				most = away;
				farthest = i;
			}
		}
		if (farthest != from) {
			is_kept[farthest % loop.size()] = true;
			waiting.push_back({ from, farthest });
			waiting.push_back({ farthest, to });
		}
	}
}

Loop2 with_fewer_corners(const Loop2 &loop, double tolerance) {
	const auto is_west = [](glm::dvec2 a, glm::dvec2 b) { return a.x < b.x; };
	const size_t west = size_t(std::min_element(loop.begin(), loop.end(), is_west) - loop.begin());
	const size_t east = size_t(std::max_element(loop.begin(), loop.end(), is_west) - loop.begin());
	std::vector<bool> is_kept(loop.size());
	is_kept[west] = is_kept[east] = true;
	mark_corners(loop, west, east > west ? east : east + loop.size(), tolerance, is_kept);
	mark_corners(loop, east, west > east ? west : west + loop.size(), tolerance, is_kept);
	Loop2 result;
	for (size_t i = 0; i < loop.size(); ++i) {
		if (is_kept[i]) {
			result.push_back(loop[i]);
		}
	}
	return result;
}

// By less where it would be no outline any more.
Loop2 simplified(const Loop2 &loop, double tolerance) {
	for (; tolerance > in_front; tolerance /= 4.0) {
		Loop2 result = with_fewer_corners(loop, tolerance);
		if (result.size() >= 3 && signed_area(result) > 0.0 && !is_self_intersecting(result)) {
			return result;
		}
	}
	return loop;
}

class BlocksBuilder {
public:
	BlocksBuilder(const std::vector<Footprint> &blocks, const LayoutParameters &p, Diagnostics &diagnostics) :
			_blocks(blocks), _p(p), _diagnostics(diagnostics), _map(blocks, double(p.street_width)) {}

	std::optional<Layout> build() {
		for (uint32_t i = 0; i < _blocks.size(); ++i) {
			add(i);
		}
		for (uint32_t tile = 0; tile < _map.tile_count(); ++tile) {
			for (const Loop2 &piece : _map.open_ground(tile)) {
				_layout.ground.push_back({ GroundKind::Junction, to_ground(piece), BlockId::Invalid, no_street });
			}
		}
		if (!report_overlaps(_blocks, _diagnostics).empty()) {
			find_lot_overlaps();
		}
		_layout.outline = to_ground(_map.outline());
		_layout.seed = _p.seed;
		frame_layout(_layout);
		return report_empty() ? std::optional<Layout>(std::move(_layout)) : std::nullopt;
	}

private:
	void add(uint32_t index) {
		const Footprint &block = _blocks[index];
		const size_t count = block.outline.size();
		const uint32_t first = uint32_t(_layout.junctions.size());
		BlockBorder border{ block.outline, {}, { block.holes.begin(), block.holes.end() }, blocks_within(index) };
		for (uint32_t side = 0; side < count; ++side) {
			border.streets.push_back(uint32_t(_layout.streets.size()));
			_layout.junctions.push_back(to_ground(block.outline[side]));
			_layout.streets.push_back({ first + side, first + uint32_t((side + 1) % count), street_beside(block.outline[side], block.outline[(side + 1) % count]) });
		}
		const size_t lots_before = _layout.lots.size();
		add_block(_layout, border, _p, false);
		for (size_t lot = lots_before; lot < _layout.lots.size(); ++lot) {
			_layout.lots[lot].type = known_type(block, _p);
			_layout.lots[lot].height = sound_height(block);
		}
	}

	Loops2 blocks_within(uint32_t index) const {
		Loops2 outlines;
		for (uint32_t i = 0; i < _blocks.size() && !_blocks[index].holes.empty(); ++i) {
			if (_map.around(i) == index) {
				outlines.push_back(_blocks[i].outline);
			}
		}
		return outlines;
	}

	// Metres.
	float street_beside(glm::dvec2 a, glm::dvec2 b) const {
		const glm::dvec2 along = (b - a) / std::max(glm::distance(a, b), in_front), outwards{ along.y, -along.x };
		const double way = in_front + _map.free_way((a + b) / 2.0 + outwards * in_front, outwards, widest_street);
		return way < widest_street ? float(std::max(way, narrowest_street)) : _p.street_width;
	}

	void find_lot_overlaps() {
		std::vector<Loops2> polygons;
		for (const Lot &lot : _layout.lots) {
			polygons.push_back({ to_plan(lot.polygon) });
		}
		for (const OutlineOverlap &overlap : find_overlaps(polygons)) {
			_layout.overlaps.push_back({ LotId(overlap.a), LotId(overlap.b), float(overlap.area) });
		}
	}

	// False if there is no lot at all.
	bool report_empty() {
		std::string names;
		size_t count = 0;
		for (size_t i = 0; i < _blocks.size(); ++i) {
			if (_layout.blocks[i].lots.empty() && ++count <= named_blocks) {
				names += (count > 1 ? "; " : "") + _blocks[i].name;
			}
		}
		if (count == 0) {
			return true;
		}
		names += count > named_blocks ? "; and " + std::to_string(count - named_blocks) + " more" : "";
		const char *hint = "draw them larger, or make the layout's lot_front, lot_aspect or pavement_width smaller";
		if (count == _blocks.size()) {
			_diagnostics.error("no-room", "no block has room for a lot: " + names, hint);
			return false;
		}
		_diagnostics.warning("no-room", "blocks without room for a lot are paved: " + names, hint);
		return true;
	}

	const std::vector<Footprint> &_blocks;
	const LayoutParameters &_p;
	Diagnostics &_diagnostics;
	FootprintMap _map;
	Layout _layout;
};

// Counts what they would hold if nothing were lost to pavements.
bool are_too_many(const std::vector<Footprint> &blocks, const LayoutParameters &p) {
	double area = 0.0;
	for (const Footprint &block : blocks) {
		area += signed_area(block.outline) / 2.0;
	}
	return area / (double(p.lot_front) * double(p.lot_front) * double(p.lot_aspect)) > double(max_lots);
}

} // namespace

std::optional<Layout> layout_of_blocks(const std::vector<Footprint> &blocks, const LayoutParameters &parameters, Diagnostics &diagnostics) {
	const bool is_good = check_parameters(parameters, diagnostics);
	if (!check_footprints(blocks, diagnostics) || !is_good) {
		return std::nullopt;
	}
	if (are_too_many(blocks, parameters)) {
		diagnostics.error("too-large", "these blocks would be divided into more than " + std::to_string(max_lots) + " lots", "make lot_front larger");
		return std::nullopt;
	}
	std::vector<Footprint> simple = blocks;
	for (Footprint &block : simple) {
		block.outline = simplified(block.outline, smoothed * double(parameters.lot_front));
		for (Loop2 &hole : block.holes) {
			hole = simplified(hole, smoothed * double(parameters.lot_front));
		}
	}
	std::optional<Layout> layout = BlocksBuilder(simple, parameters, diagnostics).build();
	return layout && assign_types(*layout, parameters, diagnostics) ? std::move(layout) : std::nullopt;
}

} // namespace pcg
