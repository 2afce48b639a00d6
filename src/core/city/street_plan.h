#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "core/base/random.h"

// The net of streets that a layout is made from: lines with a width, and the blocks between them. In plan: x east, y north, metres.
namespace pcg {

struct StreetPlan {
	struct Street {
		uint32_t from = 0, to = 0; // nodes
		float width = 0.0f; // of the carriageway
	};
	struct Block {
		std::vector<uint32_t> nodes; // counter-clockwise; a street joins each to the next
		uint32_t cells = 1; // how many blocks have been merged into this one
	};

	std::vector<glm::dvec2> nodes;
	std::vector<Street> streets;
	// Together they fill the net: each street has a block on both sides, or on one and the country on the other.
	std::vector<Block> blocks;
};

// Takes out about this share of the streets that have blocks on both sides and merges those, at most three to one. No dead ends arise,
// and no block inside of another. Only the narrowest streets go: what is left at a junction never goes straight on with another width.
void remove_streets(StreetPlan &plan, double share, Random random);

// Moves each node by up to `distance` metres. Where streets would meet too sharply or leave no room between two junctions, by less.
void move_nodes(StreetPlan &plan, double distance, Random random);

} // namespace pcg
