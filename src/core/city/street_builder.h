#pragma once

#include "core/city/city_generator.h"
#include "core/city/derivers.h"
#include "core/city/ground.h"
#include "core/city/lot_messages.h"
#include "core/city/street_shapes.h"

namespace pcg {

// Makes the public ground by the street rules of CityOptions, part by part. Pieces for which they have no start rule, or fail, come out plain.
class StreetBuilder {
public:
	// The layout and the options outlive it.
	StreetBuilder(const Layout &layout, const CityOptions &options);

	// Tiles of streets first, then blocks.
	size_t part_count() const { return _groups.streets.size() + _groups.blocks.size(); }
	// By any thread, one part for each call.
	void build(size_t part, PublicGround &ground, Derivers &derivers);
	// After all parts. A start rule that is missing is a warning.
	void report(Diagnostics &diagnostics) const;

private:
	cga::DerivationResult build_piece(uint32_t piece, Derivers &derivers, Diagnostics &diagnostics) const;
	bool can_build(const std::string &start_rule) const;

	const Layout &_layout;
	const LotRules &_rules;
	StreetShapes _shapes;
	GroundGroups _groups;
	std::vector<std::vector<std::pair<uint32_t, Diagnostics>>> _messages; // by part: of its pieces
};

// Records in City::model for what the ground means. Entrances cannot be there, for they lead into buildings: a warning.
void register_ground(City &city, Diagnostics &diagnostics);

} // namespace pcg
