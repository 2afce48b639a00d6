#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "core/cga/derivation.h"
#include "core/city/layout.h"

// Public ground as initial shapes for street rules.
namespace pcg {

// By its kind alone. A sidewalk that turns out to have no kerb is a square, too.
const char *start_rule_of(const Ground &ground);

// The start rules are those of the kinds of ground: `Street`, `Crossing`, `Junction`, `Sidewalk`, and `Square` for ground that lies along no street.
// A pavement is handed over in parts, so that those beside a crossing are shapes of their own. The first edge of carriageways and crossings runs along
// the street, that of a sidewalk lies on the kerb the other way around: its z looks to the carriageway. Texture coordinates run along the first
// edge (u) and across (v), each from 0 to 1. Attributes, as CityEngine's streets have them: `streetWidth` and `sidewalkWidth` (metres),
// `length` (metres along), `valency` (of a junction: streets that meet), `connectionStart` and `connectionEnd` ("CROSSING" or "JUNCTION", what
// a carriageway meets at its ends), and our own `atCrossing`.
class StreetShapes {
public:
	// The layout outlives it.
	explicit StreetShapes(const Layout &layout);

	// One or more for a piece of ground, equal for equal layouts; they cover it.
	std::vector<cga::InitialShape> of(uint32_t ground) const;
	// "street 12", "pavement of block 3", for messages.
	std::string name_of(uint32_t ground) const;

private:
	using Cell = std::pair<int32_t, int32_t>;
	struct Side { // of a crossing, where it meets pavements
		glm::vec3 from{ 0.0f }, to{ 0.0f };
	};

	void add_crossing(const Ground &ground);
	cga::InitialShape carriageway(const Ground &ground) const;
	cga::InitialShape junction(const Ground &ground) const;
	std::vector<cga::InitialShape> pavement(const Ground &ground) const;
	// The parts of the kerb from `from` to `to` that lie beside crossings, metres along it, in order.
	std::vector<std::pair<float, float>> crossings_at(glm::vec3 from, glm::vec3 to) const;

	const Layout &_layout;
	std::multimap<Cell, Side> _sides; // by where their middle lies
	std::map<uint32_t, std::vector<glm::vec3>> _ends; // of a street's crossings: the middles of their sides across the street
	std::vector<uint32_t> _valencies; // by junction
};

} // namespace pcg
