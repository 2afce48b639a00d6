#include "core/city/footprint_layout.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "core/base/random.h"
#include "core/city/footprint_map.h"
#include "core/city/open_ground.h"
#include "core/city/plan_layout.h"

namespace pcg {

namespace {

constexpr double beside = 0.1; // metres from a side to where it is asked what lies there

class FootprintBuilder {
public:
	FootprintBuilder(const std::vector<Footprint> &footprints, const LayoutParameters &p, Diagnostics &diagnostics) :
			_footprints(footprints), _p(p), _diagnostics(diagnostics), _map(footprints, double(p.pavement_width) + double(p.street_width)), _ground(_map) {}

	std::optional<Layout> build() {
		_layout.blocks.resize(_map.tile_count());
		for (uint32_t tile = 0; tile < _map.tile_count(); ++tile) {
			_layout.blocks[tile].outline = to_ground(_map.tile_outline(tile));
		}
		bool is_good = true;
		for (uint32_t i = 0; i < _footprints.size(); ++i) {
			is_good = add_lot(i) && is_good;
		}
		for (uint32_t tile = 0; tile < _map.tile_count(); ++tile) {
			add_open_ground(tile);
		}
		for (const OutlineOverlap &overlap : report_overlaps(_footprints, _diagnostics)) {
			_layout.overlaps.push_back({ LotId(overlap.a), LotId(overlap.b), float(overlap.area) });
		}
		_layout.outline = to_ground(_map.outline());
		_layout.seed = _p.seed;
		frame_layout(_layout);
		return is_good ? std::optional<Layout>(std::move(_layout)) : std::nullopt;
	}

private:
	// Width of the street at each side: 0 where another footprint stands, and in a courtyard between several, if there are other sides.
	std::vector<float> street_widths(uint32_t index) const {
		const Loop2 &loop = _footprints[index].outline;
		std::vector<float> open, enclosed;
		for (size_t i = 0; i < loop.size(); ++i) {
			const glm::dvec2 along = loop[(i + 1) % loop.size()] - loop[i];
			const glm::dvec2 outside = loop[i] + along / 2.0 + glm::dvec2(along.y, -along.x) * (beside / std::max(glm::length(along), beside));
			const bool is_free = !_map.is_built(outside, index);
			const bool is_enclosed = is_free && _ground.is_enclosed(outside);
			open.push_back(is_free && !is_enclosed ? _p.street_width : 0.0f);
			enclosed.push_back(is_enclosed ? _p.street_width : 0.0f);
		}
		return std::ranges::all_of(open, [](float width) { return width <= 0.0f; }) ? enclosed : open;
	}

	// False if nobody could enter it.
	bool add_lot(uint32_t index) {
		const Footprint &footprint = _footprints[index];
		Loop2 loop = footprint.outline;
		std::vector<float> widths = street_widths(index);
		size_t front = loop.size();
		double front_length = 0.0;
		for (size_t i = 0; i < loop.size(); ++i) {
			const double length = glm::distance(loop[i], loop[(i + 1) % loop.size()]);
			if (widths[i] > 0.0f && length > front_length) {
				front_length = length;
				front = i;
			}
		}
		if (front == loop.size()) {
			_diagnostics.error("bad-footprint", footprint.name + ": it is walled in by others on all sides, so nobody can enter it",
					"leave it out, or make it one with a neighbour");
			return false;
		}
		std::rotate(loop.begin(), loop.begin() + ptrdiff_t(front), loop.end());
		std::rotate(widths.begin(), widths.begin() + ptrdiff_t(front), widths.end());
		const BlockId block = BlockId(_map.home_of(index));
		_layout.blocks[index_of(block)].lots.push_back(LotId(_layout.lots.size()));
		_layout.lots.push_back({ block, known_type(footprint, _p), to_ground(loop), widths, derive_seed(_p.seed, _layout.lots.size()), sound_height(footprint) });
		for (const Loop2 &hole : footprint.holes) {
			_layout.lots.back().holes.push_back(to_ground(hole));
		}
		const uint32_t around = _map.around(index);
		_layout.lots.back().around = around < _footprints.size() ? LotId(around) : LotId::Invalid; // on errors there is no layout: a lot for each
		return true;
	}

	// What is left of the tile between the footprints. It is near the doors of all lots that reach into the tile.
	void add_open_ground(uint32_t tile) {
		std::vector<uint32_t> near{ tile };
		for (uint32_t i : _map.footprints_in(tile)) {
			near.push_back(_map.home_of(i));
		}
		std::sort(near.begin(), near.end());
		near.erase(std::unique(near.begin(), near.end()), near.end());
		for (const Loop2 &piece : _ground.pieces_in(tile)) {
			for (uint32_t block : near) {
				_layout.blocks[block].pavements.push_back(uint32_t(_layout.ground.size()));
			}
			_layout.ground.push_back({ GroundKind::Pavement, to_ground(piece), BlockId(tile), no_street });
		}
	}

	const std::vector<Footprint> &_footprints;
	const LayoutParameters &_p;
	Diagnostics &_diagnostics;
	FootprintMap _map;
	OpenGround _ground;
	Layout _layout;
};

} // namespace

std::optional<Layout> layout_of_footprints(const std::vector<Footprint> &footprints, const LayoutParameters &parameters, Diagnostics &diagnostics) {
	if (!check_footprints(footprints, diagnostics)) {
		return std::nullopt;
	}
	std::optional<Layout> layout = FootprintBuilder(footprints, parameters, diagnostics).build();
	return layout && assign_types(*layout, parameters, diagnostics) ? std::move(layout) : std::nullopt;
}

} // namespace pcg
