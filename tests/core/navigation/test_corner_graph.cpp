#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "core/navigation/corner_graph.h"
#include "tests/core/navigation/grid_world.h"

using namespace pcg;
using pcg::test::GridWorld;

TEST_CASE("open ground has no corners, a wall in it has those of its outline") {
	GridWorld world(7, 7, 0.0, 1);
	CHECK(world.mesh().corner_graph().corners().count() == 0);
	world.set_free(3, 3, false);
	world.set_free(4, 3, false);
	const NavMesh mesh = world.mesh();
	const Corners &corners = mesh.corner_graph().corners();
	REQUIRE(corners.count() == 4);
	for (uint32_t corner = 0; corner < 4; ++corner) {
		const glm::vec3 p = mesh.point(corner);
		CHECK((p.x == 3.0f || p.x == 5.0f));
		CHECK((p.z == 3.0f || p.z == 4.0f));
		CHECK(mesh.corner_graph().walks().of(mesh.points(), corner).size() == 2); // along the walls
	}
}

TEST_CASE("walks between corners lead both ways and stay on free ground") {
	for (uint64_t seed = 0; seed < 20; ++seed) {
		CAPTURE(seed);
		const GridWorld world(14, 12, 0.3, seed);
		const NavMesh mesh = world.mesh();
		const CornerGraph &graph = mesh.corner_graph();
		for (uint32_t corner = 0; corner < graph.corners().count(); ++corner) {
			const glm::vec3 here = mesh.point(corner);
			for (const SeenCorner &walk : graph.walks().of(mesh.points(), corner)) {
				const glm::vec3 there = mesh.point(walk.corner);
				CHECK(world.is_visible(here, there));
				CHECK(walk.cost == doctest::Approx(glm::distance(here, there)));
				const auto back = graph.walks().of(mesh.points(), walk.corner);
				CHECK(std::ranges::any_of(back, [&](const SeenCorner &seen) { return seen.corner == corner && seen.cost == walk.cost; }));
			}
		}
	}
}

TEST_CASE("estimates are never more than the walk") {
	size_t count = 0;
	double sum = 0.0, sum_of_walks = 0.0;
	for (uint64_t seed = 0; seed < 10; ++seed) {
		CAPTURE(seed);
		const GridWorld world(14, 12, 0.35, seed);
		const NavMesh mesh = world.mesh();
		const CornerGraph &graph = mesh.corner_graph();
		Sight sight(mesh, graph.corners());
		Random random(seed, 1);
		for (int i = 0; i < 3; ++i) {
			const glm::vec3 to = world.random_place(random);
			const CornerGraph::Goal goal = graph.goal(sight.look(mesh.nearest(to, 1)));
			for (uint32_t corner = uint32_t(i); corner < graph.corners().count(); corner += 7) {
				const glm::vec3 here = mesh.point(corner);
				const double walk = world.shortest(here, to);
				if (!std::isfinite(walk) || world.is_visible(here, to)) {
					continue;
				}
				// A walk that is not the shortest to begin with may come by the corner the wrong way round: only those that bend there count.
				const auto first = graph.walks().of(mesh.points(), corner);
				const bool goes_on = std::ranges::any_of(first, [&](const SeenCorner &next) {
					return walk >= double(next.cost) + world.shortest(mesh.point(next.corner), to) - 1e-3;
				});
				if (goes_on) {
					CHECK(graph.estimate(corner, goal) <= walk * 1.001);
					sum += graph.estimate(corner, goal);
					sum_of_walks += walk;
					++count;
				}
			}
		}
	}
	CHECK(count > 50);
	CHECK(sum > 0.8 * sum_of_walks);
}

TEST_CASE("along a straight street corners lead to the next ones only") {
	// A street 40 m long and 1 m wide with a niche on each side every other metre.
	GridWorld world(41, 3, 0.0, 1);
	for (int x = 0; x < 41; x += 2) {
		world.set_free(x, 0, false);
		world.set_free(x, 2, false);
	}
	const NavMesh mesh = world.mesh();
	const CornerGraph &graph = mesh.corner_graph();
	REQUIRE(graph.corners().count() > 70);
	for (uint32_t corner = 0; corner < graph.corners().count(); ++corner) {
		size_t on_this_side = 0;
		for (const SeenCorner &walk : graph.walks().of(mesh.points(), corner)) {
			on_this_side += mesh.point(walk.corner).z == mesh.point(corner).z;
		}
		CHECK(on_this_side <= 2);
	}
}

TEST_CASE("landmarks on other ground say nothing of a walk that ends at a corner") {
	// A maze that has all the landmarks, and 40 m beside it ground with one wall.
	GridWorld beside(5, 5, 0.0, 1);
	beside.set_free(2, 2, false);
	NavRegion regions[] = { GridWorld(14, 12, 0.3, 1).region(0, 14), beside.region(0, 5) };
	for (glm::vec3 &vertex : regions[1].vertices) {
		vertex.x += 40.0f;
	}
	const NavMesh mesh = NavMesh::build(regions);
	const CornerGraph &graph = mesh.corner_graph();
	std::vector<uint32_t> corners;
	for (uint32_t corner = 0; corner < graph.corners().count(); ++corner) {
		if (mesh.point(corner).x > 30.0f) {
			corners.push_back(corner);
		}
	}
	REQUIRE(corners.size() == 4);
	for (const uint32_t last : corners) {
		const SeenCorner end{ last, 0.0f };
		const CornerGraph::Goal goal = graph.goal({ &end, 1 });
		for (const uint32_t corner : corners) {
			CHECK(graph.estimate(corner, goal) <= glm::distance(mesh.point(corner), mesh.point(last)));
		}
	}
}
