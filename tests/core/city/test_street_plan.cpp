#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/city/street_edges.h"
#include "core/city/street_generators.h"
#include "core/geometry/polygon.h"

using namespace pcg;

namespace {

// Two blocks side by side: three nodes below, three above; 100 x 50 m each.
StreetPlan two_blocks(float width) {
	StreetPlan plan;
	plan.nodes = { { 0, 0 }, { 100, 0 }, { 200, 0 }, { 0, 50 }, { 100, 50 }, { 200, 50 } };
	for (const auto &[a, b] : { std::pair{ 0u, 1u }, { 1u, 2u }, { 3u, 4u }, { 4u, 5u }, { 0u, 3u }, { 1u, 4u }, { 2u, 5u } }) {
		plan.streets.push_back({ a, b, width });
	}
	plan.blocks = { { { 0, 1, 4, 3 }, 1 }, { { 1, 2, 5, 4 }, 1 } };
	return plan;
}

bool is_near(glm::dvec2 a, glm::dvec2 b) { return glm::distance(a, b) < 1e-9; }

double block_area(const StreetPlan &plan) {
	double sum = 0.0;
	for (const StreetPlan::Block &block : plan.blocks) {
		std::vector<glm::dvec2> points;
		for (uint32_t node : block.nodes) {
			points.push_back(plan.nodes[node]);
		}
		sum += signed_area(points) / 2.0;
	}
	return sum;
}

} // namespace

TEST_CASE("edges of streets meet half a width from the node, and streets run free from there") {
	const StreetPlan plan = two_blocks(8);
	const StreetEdges edges(plan);
	CHECK(is_near(edges.arm(0, 1).corner, { 4, 4 }));
	CHECK(is_near(edges.arm(1, 0).corner, { 100, -4 })); // straight on: no corner, a square end
	CHECK(is_near(edges.arm(0, 3).corner, { -4, -4 })); // outwards
	CHECK(edges.free_length(0) == doctest::Approx(92.0));
	CHECK(edges.free_length(4) == doctest::Approx(42.0));
	const std::vector<glm::dvec2> outline = edges.outline();
	CHECK(signed_area(outline) / 2.0 == doctest::Approx(-208.0 * 58.0)); // clockwise
	CHECK(edges.bad_nodes().empty());
}

TEST_CASE("a corner between streets of different widths lies on both their edges") {
	StreetPlan plan = two_blocks(8);
	plan.streets[0].width = 12; // from west to east
	CHECK(is_near(StreetEdges(plan).arm(0, 1).corner, { 4, 6 }));
}

TEST_CASE("streets wider than their blocks are told") {
	const StreetPlan plan = two_blocks(50);
	CHECK(StreetEdges(plan).bad_nodes().size() == 6);
}

TEST_CASE("a street that is removed makes two blocks one") {
	StreetPlan plan = two_blocks(8);
	remove_streets(plan, 1.0, Random(1));
	REQUIRE(plan.blocks.size() == 1);
	CHECK(plan.streets.size() == 6);
	CHECK(plan.blocks[0].cells == 2);
	CHECK(plan.blocks[0].nodes.size() == 6);
	CHECK(block_area(plan) == doctest::Approx(200.0 * 50.0));
}

TEST_CASE("whatever is removed, no dead end remains, at most three blocks become one, and the land stays whole") {
	LayoutParameters p;
	p.blocks_x = p.blocks_z = 8;
	for (uint64_t seed = 0; seed < 200; ++seed) {
		CAPTURE(seed);
		StreetPlan plan = grid_streets(p);
		const double area = block_area(plan);
		const size_t before = plan.streets.size(), inner = before - 32; // four sides of eight streets
		remove_streets(plan, 0.5, Random(seed));
		std::vector<int> degrees(plan.nodes.size());
		for (const StreetPlan::Street &street : plan.streets) {
			++degrees[street.from];
			++degrees[street.to];
		}
		CHECK(*std::min_element(degrees.begin(), degrees.end()) >= 2);
		CHECK(plan.streets.size() <= before - inner / 4);
		CHECK(std::all_of(plan.blocks.begin(), plan.blocks.end(), [](const StreetPlan::Block &block) { return block.cells <= 3; }));
		CHECK(block_area(plan) == doctest::Approx(area));
	}
}

TEST_CASE("nodes are moved by no more than asked, and never so that streets overlap") {
	LayoutParameters p;
	p.blocks_x = p.blocks_z = 4;
	for (uint64_t seed = 0; seed < 100; ++seed) {
		StreetPlan plan = grid_streets(p);
		const std::vector<glm::dvec2> before = plan.nodes;
		move_nodes(plan, 60.0, Random(seed)); // more than a block is deep
		CHECK(StreetEdges(plan).bad_nodes().empty());
		for (size_t i = 0; i < before.size(); ++i) {
			CHECK(glm::distance(before[i], plan.nodes[i]) <= 60.0);
		}
	}
}

TEST_CASE("a radial net has its rings of blocks, twice as many where they would become too long") {
	LayoutParameters p;
	p.rings = 4;
	p.spokes = 6;
	const std::vector<uint32_t> counts = blocks_by_ring(p);
	CHECK(counts[0] == 1);
	CHECK(counts[1] == 6);
	CHECK(counts.size() == 5);
	CHECK(std::is_sorted(counts.begin(), counts.end()));
	const StreetPlan plan = radial_streets(p);
	size_t sum = 0;
	for (uint32_t count : counts) {
		sum += count;
	}
	CHECK(plan.blocks.size() == sum);
	CHECK(StreetEdges(plan).bad_nodes().empty());
	// All blocks but the middle one lie between rings, block_size() apart.
	CHECK(plan.nodes.size() - plan.streets.size() + plan.blocks.size() == 1); // Euler
}

TEST_CASE("a grown net is whole: its blocks fill its land, and each side of an inner street has one") {
	LayoutParameters p;
	p.kind = LayoutKind::Grown;
	for (uint64_t seed = 0; seed < 50; ++seed) {
		p.seed = seed;
		const StreetPlan plan = grown_streets(p);
		CHECK(plan.nodes.size() - plan.streets.size() + plan.blocks.size() == 1);
		const std::vector<glm::dvec2> outline = StreetEdges(plan).outline();
		CHECK(block_area(plan) < -signed_area(outline) / 2.0);
		CHECK(plan.blocks.size() > 15); // as large as thirty blocks of a grid
		CHECK(plan.blocks.size() < 60);
		CHECK(StreetEdges(plan).bad_nodes().empty());
	}
}
