#pragma once

#include <vector>

#include "core/city/footprint_map.h"

namespace pcg {

// What footprints leave of the map, and where it is walled in by several of them.
class OpenGround {
public:
	explicit OpenGround(const FootprintMap &map);

	const Loops2 &pieces_in(uint32_t tile) const { return _pieces[tile]; } // convex
	// Of a point on open ground: no way of 0.5 m or more leads out to the map's edge.
	bool is_enclosed(glm::dvec2 point) const;

private:
	void reach(uint32_t tile, const Loop2 &from, const Box2 &box, std::vector<std::pair<uint32_t, uint32_t>> &waiting);

	const FootprintMap &_map;
	std::vector<Loops2> _pieces; // by tile
	std::vector<std::vector<Box2>> _boxes;
	std::vector<std::vector<bool>> _is_reached; // from the edge, by tile and piece
};

} // namespace pcg
