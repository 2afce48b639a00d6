#include <doctest/doctest.h>

#include <cmath>

#include "core/navigation/corner_graph.h"
#include "core/navigation/path_finder.h"
#include "tests/core/navigation/grid_world.h"

using namespace pcg;
using pcg::test::GridWorld;

namespace {

double length_of(std::span<const glm::vec3> points) {
	double sum = 0.0;
	for (size_t i = 1; i < points.size(); ++i) {
		sum += double(glm::distance(points[i - 1], points[i]));
	}
	return sum;
}

} // namespace

TEST_CASE("a walk on open ground is the straight line") {
	const GridWorld world(10, 10, 0.0, 1);
	const NavMesh mesh = world.mesh();
	PathFinder finder(mesh);
	CHECK(finder.find(mesh.nearest({ 0.5f, 0, 0.5f }, 1), mesh.nearest({ 8.5f, 0, 6.5f }, 1)));
	REQUIRE(finder.points().size() == 2);
	CHECK(finder.points()[0] == glm::vec3(0.5f, 0, 0.5f));
	CHECK(finder.points()[1] == glm::vec3(8.5f, 0, 6.5f));
	CHECK(finder.length() == doctest::Approx(10.0));
}

TEST_CASE("a walk around a wall bends at its corners") {
	// 5 x 3 squares with a wall at x = 2 that leaves the northern row open.
	GridWorld world(5, 3, 0.0, 1);
	world.set_free(2, 1, false);
	world.set_free(2, 2, false);
	const NavMesh mesh = world.mesh();
	PathFinder finder(mesh);
	CHECK(finder.find(mesh.nearest({ 0.5f, 0, 2.5f }, 1), mesh.nearest({ 4.5f, 0, 2.5f }, 1)));
	REQUIRE(finder.points().size() == 4);
	CHECK(finder.points()[1] == glm::vec3(2, 0, 1));
	CHECK(finder.points()[2] == glm::vec3(3, 0, 1));
	// Two diagonals of 1.5 by 1.5 m and 1 m along the wall's top.
	CHECK(finder.length() == doctest::Approx(2.0 * 1.5 * std::sqrt(2.0) + 1.0));
}

TEST_CASE("a walk from a place to itself has two equal points and no length") {
	const GridWorld world(2, 2, 0.0, 1);
	const NavMesh mesh = world.mesh();
	PathFinder finder(mesh);
	const NavPoint here = mesh.nearest({ 1, 0, 1 }, 1);
	CHECK(finder.find(here, here));
	CHECK(finder.points().size() == 2);
	CHECK(finder.length() == 0.0);
}

TEST_CASE("there is no way to an island or from outside of the mesh") {
	GridWorld world(5, 3, 0.0, 1);
	for (int z = 0; z < 3; ++z) {
		world.set_free(2, z, false);
	}
	const NavMesh mesh = world.mesh();
	PathFinder finder(mesh);
	CHECK_FALSE(finder.find(mesh.nearest({ 0.5f, 0, 1 }, 1), mesh.nearest({ 4.5f, 0, 1 }, 1)));
	CHECK(finder.points().empty());
	CHECK_FALSE(finder.find(NavPoint(), mesh.nearest({ 4.5f, 0, 1 }, 1)));
}

TEST_CASE("walks through random mazes stay on free ground and are at most 1 % longer than the shortest, both ways") {
	double sum = 0.0, sum_of_shortest = 0.0, worst = 1.0;
	size_t unreachable = 0;
	for (uint64_t seed = 0; seed < 60; ++seed) {
		CAPTURE(seed);
		const GridWorld world(14, 12, 0.35, seed);
		const NavMesh mesh = world.mesh();
		PathFinder finder(mesh);
		Random random(seed, 1);
		for (int i = 0; i < 4; ++i) {
			const glm::vec3 from = world.random_place(random), to = world.random_place(random);
			const double shortest = world.shortest(from, to);
			const bool is_found = finder.find(mesh.nearest(from, 1), mesh.nearest(to, 1));
			REQUIRE(is_found == std::isfinite(shortest));
			if (!is_found) {
				++unreachable;
				continue;
			}
			for (size_t k = 1; k < finder.points().size(); ++k) {
				CHECK(world.is_visible(finder.points()[k - 1], finder.points()[k]));
			}
			CHECK(length_of(finder.points()) == doctest::Approx(finder.length()));
			CHECK(finder.length() >= shortest - 1e-4);
			CHECK(finder.length() >= double(glm::distance(from, to)) - 1e-4);
			worst = std::max(worst, finder.length() / shortest);
			sum += finder.length();
			sum_of_shortest += shortest;
			REQUIRE(finder.find(mesh.nearest(to, 1), mesh.nearest(from, 1)));
			worst = std::max(worst, finder.length() / shortest);
		}
	}
	CHECK(sum / sum_of_shortest < 1.002);
	CHECK(worst < 1.01);
	CHECK(unreachable > 0);
}

TEST_CASE("dear ground is avoided where a cheap way is not much longer") {
	// Three strips of 10 x 1 m from west to east; the middle one is dear, and only the northern one leads around at no cost.
	NavRegion region;
	const auto add = [&](float x0, float z0, float x1, float z1, float cost) {
		const uint32_t first = uint32_t(region.vertices.size());
		region.vertices.insert(region.vertices.end(), { { x0, 0, z0 }, { x0, 0, z1 }, { x1, 0, z1 }, { x1, 0, z0 } });
		region.polygons.push_back({ first, first + 1, first + 2, first + 3 });
		region.costs.push_back(cost);
	};
	add(0, 0, 1, 3, 1); // west
	add(1, 1, 9, 2, 10); // a carriageway
	add(1, -3, 9, 1, 1); // a pavement in an arc
	add(9, 0, 10, 3, 1); // east
	const NavMesh mesh = NavMesh::build({ &region, 1 });
	PathFinder finder(mesh);
	REQUIRE(finder.find(mesh.nearest({ 0.5f, 0, 1.5f }, 1), mesh.nearest({ 9.5f, 0, 1.5f }, 1)));
	for (const glm::vec3 &point : finder.points()) {
		const bool is_on_street = point.x > 1.001f && point.x < 8.999f && point.z > 1.001f;
		CHECK_FALSE(is_on_street);
	}
	CHECK(finder.length() > 9.0);
	CHECK(finder.length() < 10.0);
}

TEST_CASE("a finder can be used many times over with the same answers") {
	const GridWorld world(20, 20, 0.3, 5);
	const NavMesh mesh = world.mesh();
	PathFinder used(mesh);
	Random random(9);
	for (int i = 0; i < 200; ++i) {
		const NavPoint from = mesh.nearest(world.random_place(random), 1), to = mesh.nearest(world.random_place(random), 1);
		PathFinder fresh(mesh);
		REQUIRE(used.find(from, to) == fresh.find(from, to));
		CHECK(used.length() == fresh.length());
	}
}

TEST_CASE("on polygons that are piled on one another sight ends early, and ways are found all the same") {
	Random random(1);
	std::vector<NavRegion> pile;
	for (int i = 0; i < 400; ++i) {
		const float x = float(random.uniform(0.0, 12.0)), z = float(random.uniform(0.0, 12.0));
		const float width = float(random.uniform(1.0, 6.0)), depth = float(random.uniform(1.0, 6.0));
		NavRegion &region = pile.emplace_back();
		region.vertices = { { x, 0, z }, { x, 0, z + depth }, { x + width, 0, z + depth }, { x + width, 0, z } };
		region.polygons = { { 0, 1, 2, 3 } };
	}
	const NavMesh mesh = NavMesh::build(pile);
	CHECK(mesh.corner_graph().cut_short_count() > 0);
	PathFinder finder(mesh);
	size_t found = 0;
	for (int i = 0; i < 100; ++i) {
		const NavPoint from = mesh.nearest({ random.uniform(0.0, 18.0), 0, random.uniform(0.0, 18.0) }, 20);
		const NavPoint to = mesh.nearest({ random.uniform(0.0, 18.0), 0, random.uniform(0.0, 18.0) }, 20);
		REQUIRE(finder.find(from, to) == (mesh.component(from.polygon) == mesh.component(to.polygon)));
		if (mesh.component(from.polygon) == mesh.component(to.polygon)) {
			CHECK(finder.points().front() == from.position);
			CHECK(finder.points().back() == to.position);
			CHECK(finder.length() >= double(glm::distance(from.position, to.position)) - 0.01);
			++found;
		}
	}
	CHECK(found > 50);
}
