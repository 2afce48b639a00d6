#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/diagnostic.h"
#include "core/base/ids.h"
#include "core/city/land_use.h"

// Where streets, blocks and lots lie, before anything is built. Metres, y up, -z north, the city's middle near the origin, ground at y = 0. All
// polygons are counter-clockwise seen from above. Nothing that reads a layout may take blocks or lots for rectangles.
namespace pcg {

enum class LayoutKind : uint8_t {
	Grid, // the paper's: rectangular blocks with square-like lots; less regular with `jitter` and `removed`
	Radial, // rings of blocks around one in the middle
	Grown, // land that was divided again and again: streets meet at all angles, mostly where one ends at another
};

struct LayoutParameters {
	LayoutKind kind = LayoutKind::Grid;
	// Of a grid; a grown city is about as large as a grid of so many blocks.
	uint32_t blocks_x = 5; // [Limit: 1 to 1000] from west to east
	uint32_t blocks_z = 6; // [Limit: 1 to 1000] from north to south
	// Of a radial city.
	uint32_t rings = 4; // [Limit: 1 to 100] of blocks around the middle
	uint32_t spokes = 7; // [Limit: 5 to 64] streets that leave the middle; farther out there are more
	uint32_t lots_along = 5; // [Limit: 1 to 100] lots side by side along a block, or about as many where blocks differ
	uint32_t lots_deep = 2; // [Limit: 1 or 2] rows of lots, back to back; more would have no street
	float lot_front = 20.0f; // [Limit: 5 to 500 m] a lot's width along its street
	float lot_aspect = 1.0f; // [Limit: 0.25 to 4] depth of a lot divided by its front
	float street_width = 8.0f; // [Limit: 2 to 100 m] the carriageway
	float main_street_width = 11.0f; // [Limit: 2 to 100 m] of the spokes from a radial city's middle, and around and through a grown city; no less than street_width
	float pavement_width = 3.0f; // [Limit: 0.5 to 50 m] on each side
	float jitter = 0.0f; // [Limit: 0 to 0.25] how far junctions are moved, as a part of a block's shorter side
	float removed = 0.0f; // [Limit: 0 to 0.5] the part of the inner streets that is left out; their blocks become one
	uint64_t seed = 1;
	std::vector<LandUse> land_use = default_land_use();
	std::vector<District> districts; // where one contains a lot, it decides instead of land_use
};

struct Lot {
	BlockId block = BlockId::Invalid;
	std::string type;
	// The first edge is the front: it lies on a street.
	std::vector<glm::vec3> polygon;
	// Width in metres of the street that the edge lies on, 0 = none. The front has one; corner lots have two or more such edges.
	std::vector<float> street_widths;
	uint64_t seed = 0; // depends on the layout's seed and the lot's id alone
	float height = 0.0f; // metres of what stands there, for rules with an attribute `height`; 0 = theirs to say
	std::vector<std::vector<glm::vec3>> holes = {}; // courtyards, which rules build around; their ground belongs to the lot but for lots within
	LotId around = LotId::Invalid; // in whose courtyard this one stands
};

struct CityBlock {
	std::vector<LotId> lots; // none: the block is a square of pavement, for it is too small to build on
	std::vector<uint32_t> pavements; // indices in Layout::ground
	std::vector<glm::vec3> outline; // with its pavements
};

// A stretch of street from junction to junction; indices in Layout::junctions. Along blocks that were drawn: one for each side, from corner to corner.
struct Street {
	uint32_t from = 0, to = 0;
	float width = 0.0f; // metres, the carriageway
};
constexpr uint32_t no_street = 0xFFFFFFFF;

enum class GroundKind : uint8_t { Street, Junction, Crossing, Pavement };

// A piece of public ground, convex. Pieces do not overlap; together with the lots they cover the whole city.
struct Ground {
	GroundKind kind = GroundKind::Street;
	std::vector<glm::vec3> polygon; // carriageways and crossings: the first edge runs along the street
	BlockId block = BlockId::Invalid; // whose pavement this is; streets belong to none
	uint32_t street = no_street; // on which it lies; junctions (also what lies between drawn blocks) and squares lie on none
};

// A rectangle of the map. Tiles cover the city and do not overlap; ground for walking is baked tile by tile.
struct Tile {
	glm::vec3 min{ 0.0f }, max{ 0.0f };
};

// Two lots that were drawn or measured so that they share ground.
struct LotOverlap {
	LotId a = LotId::Invalid, b = LotId::Invalid;
	float area = 0.0f; // square metres
};

struct Layout {
	std::vector<CityBlock> blocks;
	std::vector<Lot> lots;
	std::vector<glm::vec3> junctions;
	std::vector<Street> streets;
	std::vector<Ground> ground;
	std::vector<Tile> tiles;
	std::vector<LotOverlap> overlaps; // of more than a square metre
	std::vector<glm::vec3> outline; // the city's edge
	glm::vec3 min{ 0.0f }, max{ 0.0f }; // of the outline
	uint64_t seed = 0;

	const CityBlock &block(BlockId id) const { return blocks[index_of(id)]; }
	const Lot &lot(LotId id) const { return lots[index_of(id)]; }
};

constexpr size_t max_lots = 2'000'000; // of one layout

// False, and errors that name each parameter that is out of its limits.
bool check_parameters(const LayoutParameters &parameters, Diagnostics &diagnostics);

// Nothing, and errors that name the parameter and its limits, if the parameters make no city.
std::optional<Layout> make_layout(const LayoutParameters &parameters, Diagnostics &diagnostics);

// Gives a type to each lot that has none. False, with errors, if land use says nothing sensible.
bool assign_types(Layout &layout, const LayoutParameters &parameters, Diagnostics &diagnostics);

// How many blocks the parameters ask for.
uint32_t block_count(const LayoutParameters &parameters);

// Parameters for a roughly square city of about `count` lots (a plain grid: exactly so up to 20), otherwise like `base`. Zero stays zero
// blocks, which make_layout refuses.
LayoutParameters layout_for_lots(uint32_t count, LayoutParameters base = {});

// Outlines of the lots that stand in a lot's courtyards.
std::vector<std::vector<glm::vec3>> lots_within(const Layout &layout, LotId lot);
// In whose courtyards, one within the other, it stands; the nearest first.
std::vector<LotId> lots_around(const Layout &layout, LotId lot);

// "lot 12 (house)", for messages.
std::string lot_name(const Layout &layout, LotId lot);

} // namespace pcg
