#include "core/city/street_generators.h"

#include <algorithm>

namespace pcg {

glm::dvec2 block_size(const LayoutParameters &p) {
	const double around = double(p.street_width) + 2.0 * double(p.pavement_width);
	return { double(p.lots_along) * double(p.lot_front) + around, double(p.lots_deep) * double(p.lot_front) * double(p.lot_aspect) + around };
}

float main_width(const LayoutParameters &p) { return std::max(p.street_width, p.main_street_width); }

// Blocks in rows from north to south, each from west to east.
StreetPlan grid_streets(const LayoutParameters &p) {
	const glm::dvec2 block = block_size(p);
	const double west = -block.x * p.blocks_x / 2.0, north = block.y * p.blocks_z / 2.0;
	const auto node = [&](uint32_t i, uint32_t j) { return j * (p.blocks_x + 1) + i; };
	StreetPlan plan;
	for (uint32_t j = 0; j <= p.blocks_z; ++j) {
		for (uint32_t i = 0; i <= p.blocks_x; ++i) {
			plan.nodes.push_back({ west + block.x * i, north - block.y * j });
			if (i < p.blocks_x) {
				plan.streets.push_back({ node(i, j), node(i + 1, j), p.street_width });
			}
			if (j < p.blocks_z) {
				plan.streets.push_back({ node(i, j), node(i, j + 1), p.street_width });
			}
		}
	}
	for (uint32_t j = 0; j < p.blocks_z; ++j) {
		for (uint32_t i = 0; i < p.blocks_x; ++i) {
			plan.blocks.push_back({ { node(i, j + 1), node(i + 1, j + 1), node(i + 1, j), node(i, j) }, 1 });
		}
	}
	return plan;
}

} // namespace pcg
