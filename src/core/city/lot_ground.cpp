#include "core/city/lot_ground.h"

#include <algorithm>

#include <glm/vec4.hpp>

#include "core/city/free_ground.h"
#include "core/city/lot_overlaps.h"
#include "core/city/plan_layout.h"

namespace pcg {

namespace {

using Polygon = std::vector<glm::vec3>;

enum Layer { Vacated, Standing }; // what stands in courtyards lies over what stands around it, in layers of its own

Polygon moved(const Polygon &polygon, const glm::mat4 &motion) {
	Polygon result;
	for (const glm::vec3 &corner : polygon) {
		result.push_back(glm::vec3(motion * glm::vec4(corner, 1.0f)));
	}
	if (signed_area(to_plan(result)) < 0.0) { // mirrored or turned over
		std::reverse(result.begin(), result.end());
	}
	return result;
}

class LotLayers {
public:
	LotLayers(const City &city, std::span<const PlacedLot> lots) :
			_city(city), _lots(lots), _is_at_home(city.lots.size()), _lies_over_vacated(city.lots.size()), _is_patched(lots.size()) {
		for (size_t i = 0; i < lots.size(); ++i) {
			_is_at_home[index_of(lots[i].lot)] = _is_at_home[index_of(lots[i].lot)] || lots[i].is_at_home;
			if (!city.layout.lot(lots[i].lot).holes.empty()) {
				_rings.push_back(i);
			}
		}
		for (size_t i = 0; i < lots.size() && !_rings.empty(); ++i) {
			_outlines.push_back(outline_of(city.layout, lots[i]));
		}
		const auto note = [&](LotId lot, LotId below) {
			_lies_over_vacated[index_of(lot)] = _lies_over_vacated[index_of(lot)] || !_is_at_home[index_of(below)];
		};
		for (const LotOverlap &overlap : city.layout.overlaps) {
			note(overlap.a, overlap.b);
			note(overlap.b, overlap.a);
		}
		for (size_t i = 0; i < city.lots.size(); ++i) {
			for (const LotId around : lots_around(city.layout, LotId(i))) {
				note(LotId(i), around);
			}
		}
	}

	LayeredPatches patches() {
		LayeredPatches result;
		for (size_t i = 0; i < _is_at_home.size(); ++i) {
			if (!_is_at_home[i]) {
				result[{ Vacated, i }] = { _city.layout.lots[i].polygon, left_behind(LotId(i)) };
			}
		}
		find_patched();
		for (size_t i = 0; i < _lots.size(); ++i) {
			if (_is_patched[i]) {
				result[{ Standing + rings_around(i), _lots[i].object }] = patch_of(_lots[i]);
			}
		}
		return result;
	}

private:
	bool stands_in(size_t inner, size_t ring) const { return inner != ring && stands_in_hole(_outlines[inner][0], _outlines[ring]); }

	int rings_around(size_t placed) const {
		return int(std::ranges::count_if(_rings, [&](size_t ring) { return stands_in(placed, ring); }));
	}

	// Lots that were moved; and those that were not, but stand where the ground of others has changed.
	void find_patched() {
		std::vector<size_t> open;
		const auto add = [&](size_t placed) {
			if (!_is_patched[placed]) {
				_is_patched[placed] = true;
				open.push_back(placed);
			}
		};
		for (size_t i = 0; i < _lots.size(); ++i) {
			if (!_lots[i].is_at_home || _lies_over_vacated[index_of(_lots[i].lot)]) {
				add(i);
			}
		}
		while (!open.empty()) {
			const size_t ring = open.back();
			open.pop_back();
			for (size_t i = 0; i < _outlines.size() && _outlines[ring].size() > 1; ++i) {
				if (!_is_patched[i] && stands_in(i, ring)) {
					add(i);
				}
			}
		}
	}

	// The courtyard that it stood in; else a lawn.
	std::vector<Polygon> left_behind(LotId lot) const {
		const Lot &left = _city.layout.lot(lot);
		for (const LotId around : lots_around(_city.layout, lot)) {
			if (_is_at_home[index_of(around)]) {
				return pieces_within(_city.lots[index_of(around)].free_ground, left.polygon);
			}
		}
		return free_ground(left, cga::DerivationResult());
	}

	GroundPatch patch_of(const PlacedLot &placed) const {
		GroundPatch patch{ moved(_city.layout.lot(placed.lot).polygon, placed.motion), {} };
		for (const Polygon &piece : _city.lots[index_of(placed.lot)].free_ground) {
			patch.pieces.push_back(moved(piece, placed.motion));
		}
		return patch;
	}

	const City &_city;
	std::span<const PlacedLot> _lots;
	std::vector<size_t> _rings; // those of _lots with courtyards
	std::vector<Loops2> _outlines; // of _lots; none where there are no rings
	std::vector<bool> _is_at_home, _lies_over_vacated; // by LotId
	std::vector<bool> _is_patched; // of _lots
};

} // namespace

std::vector<Polygon> lot_ground(const City &city, LotId lot) {
	return pieces_without(city.lots[index_of(lot)].free_ground, lots_within(city.layout, lot));
}

Loops2 outline_of(const Layout &layout, const PlacedLot &placed) {
	const Lot &lot = layout.lot(placed.lot);
	Loops2 polygon{ to_plan(moved(lot.polygon, placed.motion)) };
	for (const Polygon &hole : lot.holes) {
		const Loop2 loop = to_plan(moved(hole, placed.motion));
		polygon.push_back(Loop2(loop.rbegin(), loop.rend()));
	}
	return polygon;
}

LayeredPatches patches_of_lots(const City &city, std::span<const PlacedLot> lots) { return LotLayers(city, lots).patches(); }

} // namespace pcg
