#pragma once

#include <string>
#include <vector>

#include "core/city/footprint_layout.h"
#include "core/city/lot_overlaps.h"
#include "core/geometry/box2.h"

// Where footprints lie: in tiles, so that whatever is laid over them meets few.
namespace pcg {

// False, and errors that name each footprint that cannot be laid out, or say that all of them spread too far. Warnings of heights that are none.
bool check_footprints(const std::vector<Footprint> &footprints, Diagnostics &diagnostics);

// Its height if that is one, else 0: not known.
float sound_height(const Footprint &footprint);

// Those that share ground, each pair with a warning that names both.
std::vector<OutlineOverlap> report_overlaps(const std::vector<Footprint> &footprints, Diagnostics &diagnostics);

// Outline and holes as one polygon.
Loops2 polygon_of(const Footprint &footprint);

// The type that a footprint is said to have if there are rules for it; else empty.
std::string known_type(const Footprint &footprint, const LayoutParameters &parameters);

class FootprintMap {
public:
	// With `around` metres of ground beyond the outermost. The footprints outlive it.
	FootprintMap(const std::vector<Footprint> &footprints, double around);

	Loop2 outline() const { return _extent.outline(); }
	uint32_t tile_count() const { return uint32_t(_tiles.size()); }
	Loop2 tile_outline(uint32_t tile) const;
	const std::vector<uint32_t> &footprints_in(uint32_t tile) const { return _tiles[tile]; } // that touch it, or nearly so
	uint32_t tile_at(glm::dvec2 point) const { return cell_of(point).y * _columns + cell_of(point).x; }
	std::vector<uint32_t> tiles_around(uint32_t tile) const; // itself and those that share a side with it
	uint32_t home_of(uint32_t footprint) const; // the tile in which its middle lies
	bool is_built(glm::dvec2 point, uint32_t but) const; // by a footprint other than `but`; holes are not
	// The smallest footprint that has one in a hole, for the most part; the number of footprints if none has.
	uint32_t around(uint32_t footprint) const;
	// What footprints, with their holes, leave of a tile, in convex pieces.
	Loops2 open_ground(uint32_t tile) const;
	// Metres from a point in a direction (unit) to the next side of a footprint; `reach` if there is none nearer.
	double free_way(glm::dvec2 from, glm::dvec2 direction, double reach) const;

private:
	glm::uvec2 cell_of(glm::dvec2 point) const;
	void for_tiles(const Box2 &box, auto action) const;

	const std::vector<Footprint> &_footprints;
	std::vector<Box2> _boxes;
	Box2 _extent;
	uint32_t _columns = 1, _rows = 1;
	std::vector<std::vector<uint32_t>> _tiles; // footprints
};

} // namespace pcg
