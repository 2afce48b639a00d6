#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/diagnostic.h"
#include "core/base/ids.h"
#include "core/city/land_use.h"

// Where streets, blocks and lots lie, before anything is built (paper, "City generation": rectangular blocks with square-like lots).
// Metres, y up, -z north, the city's middle at the origin, ground at y = 0. All polygons are counter-clockwise seen from above.
namespace pcg {

struct LayoutParameters {
	uint32_t blocks_x = 5; // [Limit: 1 to 1000] from west to east
	uint32_t blocks_z = 6; // [Limit: 1 to 1000] from north to south
	uint32_t lots_along = 5; // [Limit: 1 to 100] lots side by side along a block
	uint32_t lots_deep = 2; // [Limit: 1 or 2] rows of lots, back to back; more would have no street
	float lot_front = 20.0f; // [Limit: 5 to 500 m] a lot's width along its street
	float lot_aspect = 1.0f; // [Limit: 0.25 to 4] depth of a lot divided by its front
	float street_width = 8.0f; // [Limit: 2 to 100 m] the carriageway
	float pavement_width = 3.0f; // [Limit: 0.5 to 50 m] on each side
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
};

struct CityBlock {
	std::vector<LotId> lots;
	std::vector<uint32_t> pavements; // indices in Layout::ground
	glm::vec3 min{ 0.0f }, max{ 0.0f }; // with its pavements
	// The block with its pavements and its half of the streets around (all of a street at the city's edge): these tile the city.
	glm::vec3 cell_min{ 0.0f }, cell_max{ 0.0f };
};

enum class GroundKind : uint8_t { Street, Crossing, Pavement };

// A piece of public ground, convex. Pieces do not overlap; together with the lots they cover the whole city.
struct Ground {
	GroundKind kind = GroundKind::Street;
	std::vector<glm::vec3> polygon;
	BlockId block = BlockId::Invalid; // whose pavement this is; streets belong to none
};

struct Layout {
	std::vector<CityBlock> blocks;
	std::vector<Lot> lots;
	std::vector<Ground> ground;
	glm::vec3 min{ 0.0f }, max{ 0.0f };
	uint64_t seed = 0;

	const CityBlock &block(BlockId id) const { return blocks[index_of(id)]; }
	const Lot &lot(LotId id) const { return lots[index_of(id)]; }
};

// Nothing, and errors that name the parameter and its limits, if the parameters make no city.
std::optional<Layout> make_layout(const LayoutParameters &parameters, Diagnostics &diagnostics);

// Parameters for a roughly square city of about `count` lots (exactly so up to 20), otherwise like `base`. Zero stays zero blocks,
// which make_layout refuses.
LayoutParameters layout_for_lots(uint32_t count, LayoutParameters base = {});

// "lot 12 (house)", for messages.
std::string lot_name(const Layout &layout, LotId lot);

} // namespace pcg
