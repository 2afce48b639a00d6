#include <doctest/doctest.h>

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
	const Corners corners(mesh, 0.25f, polygons);
	const std::vector<uint32_t> landmarks = choose_landmarks(mesh, corners, polygons, 2);
	REQUIRE(landmarks.size() == 2);
	CHECK(std::abs(corners.position(landmarks[0]).x - corners.position(landmarks[1]).x) > 12.0f);
}

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
		const CornerGraph &old_graph = before.corner_graph(), &graph = after.corner_graph();
		const auto find = [](const CornerGraph &in, glm::vec3 position) {
			uint32_t corner = 0;
			while (corner < in.corners().count() && in.corners().position(corner) != position) {
				++corner;
			}
			return corner;
		};
		const uint32_t from = 0, old_from = find(old_graph, graph.corners().position(from));
		if (old_from == old_graph.corners().count()) {
			continue;
		}
		const std::vector<float> old_costs = walk_costs(old_graph, old_from);
		std::vector<float> costs;
		for (uint32_t corner = 0; corner < graph.corners().count(); ++corner) {
			const uint32_t old_corner = find(old_graph, graph.corners().position(corner));
			costs.push_back(old_corner < old_costs.size() ? old_costs[old_corner] : INFINITY);
		}
		std::vector<uint32_t> all(costs.size());
		std::iota(all.begin(), all.end(), 0);
		repair_walk_costs(graph, from, all, costs);
		CHECK(costs == walk_costs(graph, from));
		++compared;
	}
	CHECK(compared > 10);
}
