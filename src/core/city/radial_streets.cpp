#include "core/city/street_generators.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pcg {

namespace {

// Distance of a ring's streets from the middle, and how many there are.
struct Ring {
	double apothem = 0.0;
	uint32_t sides = 0;

	double side_length() const { return 2.0 * apothem * std::tan(std::numbers::pi / sides); }
};

// From that around the middle block outwards. Sectors are halved where blocks would become much longer than wanted.
std::vector<Ring> rings_of(const LayoutParameters &p) {
	const glm::dvec2 block = block_size(p);
	const double first_side = std::max(0.6 * block.x, 3.0 * double(main_width(p)) + 2.0 * double(p.pavement_width));
	std::vector<Ring> rings{ { first_side / (2.0 * std::tan(std::numbers::pi / p.spokes)), p.spokes } };
	for (uint32_t i = 0; i < p.rings; ++i) {
		Ring next{ rings.back().apothem + block.y, rings.back().sides };
		next.sides *= i + 1 < p.rings && next.side_length() > 1.6 * block.x ? 2 : 1;
		rings.push_back(next);
	}
	return rings;
}

} // namespace

std::vector<uint32_t> blocks_by_ring(const LayoutParameters &parameters) {
	std::vector<uint32_t> counts{ 1 };
	const std::vector<Ring> rings = rings_of(parameters);
	for (size_t i = 0; i + 1 < rings.size(); ++i) {
		counts.push_back(rings[i].sides);
	}
	return counts;
}

StreetPlan radial_streets(const LayoutParameters &p) {
	const std::vector<Ring> rings = rings_of(p);
	StreetPlan plan;
	std::vector<uint32_t> first; // node of each ring
	for (size_t k = 0; k < rings.size(); ++k) {
		const uint32_t sides = rings[k].sides;
		first.push_back(uint32_t(plan.nodes.size()));
		const double radius = rings[k].apothem / std::cos(std::numbers::pi / sides);
		for (uint32_t i = 0; i < sides; ++i) {
			const double angle = std::numbers::pi * (0.5 + 2.0 * i / sides);
			plan.nodes.push_back({ radius * std::cos(angle), radius * std::sin(angle) });
			plan.streets.push_back({ first[k] + i, first[k] + (i + 1) % sides, p.street_width });
		}
	}
	StreetPlan::Block middle;
	for (uint32_t i = 0; i < p.spokes; ++i) {
		middle.nodes.push_back(i);
	}
	plan.blocks.push_back(middle);
	for (size_t k = 0; k + 1 < rings.size(); ++k) {
		const uint32_t sides = rings[k].sides, split = rings[k + 1].sides / sides;
		const auto outer = [&](uint32_t i) { return first[k + 1] + i % rings[k + 1].sides; };
		for (uint32_t i = 0; i < sides; ++i) {
			const bool is_main = i % (sides / p.spokes) == 0;
			plan.streets.push_back({ first[k] + i, outer(i * split), is_main ? main_width(p) : p.street_width });
			StreetPlan::Block block;
			block.nodes = { first[k] + (i + 1) % sides, first[k] + i };
			for (uint32_t j = 0; j <= split; ++j) {
				block.nodes.push_back(outer(i * split + j));
			}
			plan.blocks.push_back(std::move(block));
		}
	}
	return plan;
}

} // namespace pcg
