#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/navigation/corner_graph.h"
#include "core/navigation/landmarks.h"
#include "tests/core/navigation/grid_world.h"

using namespace pcg;
using pcg::test::GridWorld;

TEST_CASE("landmarks lie far apart") {
	GridWorld world(30, 9, 0.0, 1);
	for (int x = 2; x < 28; x += 5) {
		world.set_free(x, 4, false);
	}
	const NavMesh mesh = world.mesh();
	CornerPolygons polygons;
	std::vector<uint32_t> order;
	const Corners corners(mesh, 0.25f, polygons, order);
	const std::vector<uint32_t> landmarks = choose_landmarks(mesh, corners, polygons, 2);
	REQUIRE(landmarks.size() == 2);
	CHECK(std::abs(mesh.point(landmarks[0]).x - mesh.point(landmarks[1]).x) > 12.0f);
}

namespace {

// In whole units, of which a metre has so many.
CornerWalks walks_of(const NavMesh &mesh, float units) {
	CornerWalks walks;
	for (uint32_t corner = 0; corner < mesh.corner_graph().corners().count(); ++corner) {
		walks.push_back(mesh.corner_graph().walks().of(mesh.points(), corner));
		for (SeenCorner &walk : walks.back()) {
			walk.cost = std::floor(walk.cost * units);
		}
	}
	return walks;
}

} // namespace

TEST_CASE("costs that are repaired after squares were blocked and freed are those of a new search, to the bit") {
	size_t compared = 0;
	for (uint64_t seed = 0; seed < 20; ++seed) {
		CAPTURE(seed);
		GridWorld world(16, 14, 0.25, seed);
		const NavMesh before = world.mesh();
		Random random(seed, 1);
		for (int i = 0; i < 3; ++i) {
			world.set_free(int(random.index(16)), int(random.index(14)), i == 0);
		}
		const NavMesh after = world.mesh();
		const auto find = [&](glm::vec3 position) {
			uint32_t corner = 0;
			while (corner < before.corner_graph().corners().count() && before.point(corner) != position) {
				++corner;
			}
			return corner;
		};
		const uint32_t from = 0, old_from = find(after.point(from));
		if (old_from == before.corner_graph().corners().count()) {
			continue;
		}
		const float units = seed % 2 == 0 ? 32.0f : 0.4f; // many walks cost nothing
		const CornerWalks walks = walks_of(after, units);
		const std::vector<float> old_costs = walk_costs(walks_of(before, units), old_from);
		std::vector<float> costs;
		for (uint32_t corner = 0; corner < walks.size(); ++corner) {
			const uint32_t old_corner = find(after.point(corner));
			costs.push_back(old_corner < old_costs.size() ? old_costs[old_corner] : INFINITY);
		}
		std::vector<uint32_t> all(costs.size());
		std::iota(all.begin(), all.end(), 0);
		repair_walk_costs(walks, from, all, costs);
		CHECK(costs == walk_costs(walks, from));
		++compared;
	}
	CHECK(compared > 10);
}

TEST_CASE("costs to all corners are those of the cheapest walks") {
	for (uint64_t seed = 0; seed < 10; ++seed) {
		CAPTURE(seed);
		const NavMesh mesh = GridWorld(16, 14, 0.25, seed).mesh();
		CornerWalks walks;
		for (uint32_t corner = 0; corner < mesh.corner_graph().corners().count(); ++corner) {
			walks.push_back(mesh.corner_graph().walks().of(mesh.points(), corner));
		}
		REQUIRE(walks.size() > 20);
		std::vector<float> slow(walks.size(), INFINITY);
		slow[7] = 0.0f;
		for (size_t round = 0; round < walks.size(); ++round) {
			for (uint32_t corner = 0; corner < walks.size(); ++corner) {
				for (const SeenCorner &walk : walks[corner]) {
					slow[walk.corner] = std::min(slow[walk.corner], slow[corner] + walk.cost);
				}
			}
		}
		CHECK(walk_costs(walks, 7) == slow);
	}
}
