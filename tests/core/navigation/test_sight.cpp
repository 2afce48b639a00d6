#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "core/navigation/corner_graph.h"
#include "tests/core/navigation/grid_world.h"

using namespace pcg;
using pcg::test::GridWorld;

namespace {

// The one blocked square around a corner of the grid, as the direction there; none if more or fewer are blocked.
bool find_wall(const GridWorld &world, int x, int z, glm::vec3 &direction) {
	int count = 0;
	for (int dx : { -1, 0 }) {
		for (int dz : { -1, 0 }) {
			if (!world.is_free(x + dx, z + dz)) {
				++count;
				direction = { dx + 0.5f, 0.0f, dz + 0.5f };
			}
		}
	}
	return count == 1;
}

} // namespace

TEST_CASE("places see each other where the straight way is free") {
	size_t seen = 0, hidden = 0;
	for (uint64_t seed = 0; seed < 30; ++seed) {
		CAPTURE(seed);
		const GridWorld world(14, 12, 0.25, seed);
		const NavMesh mesh = world.mesh();
		Sight sight(mesh, mesh.corner_graph().corners());
		Random random(seed, 1);
		for (int i = 0; i < 40; ++i) {
			const glm::vec3 from = world.random_place(random), to = world.random_place(random);
			const float cost = sight.straight(mesh.nearest(from, 1), mesh.nearest(to, 1));
			const bool is_seen = world.is_visible(from, to);
			CHECK(std::isfinite(cost) == is_seen);
			if (is_seen) {
				CHECK(cost == doctest::Approx(glm::distance(from, to)));
			}
			++(is_seen ? seen : hidden);
		}
	}
	CHECK(seen > 200);
	CHECK(hidden > 200);
}

TEST_CASE("the corners seen from a place are those at which a walk from there bends around a wall") {
	size_t count = 0;
	for (uint64_t seed = 0; seed < 30; ++seed) {
		CAPTURE(seed);
		const GridWorld world(14, 12, 0.25, seed);
		const NavMesh mesh = world.mesh();
		Sight sight(mesh, mesh.corner_graph().corners());
		Random random(seed, 1);
		for (int i = 0; i < 10; ++i) {
			const glm::vec3 from = world.random_place(random);
			std::vector<glm::vec3> seen;
			for (const SeenCorner &corner : sight.look(mesh.nearest(from, 1))) {
				seen.push_back(mesh.point(corner.corner));
				CHECK(corner.cost == doctest::Approx(glm::distance(from, seen.back())));
			}
			for (int x = 1; x < world.width(); ++x) {
				for (int z = 1; z < world.depth(); ++z) {
					const glm::vec3 here(x, 0, z), way = here - from;
					glm::vec3 wall;
					const bool is_corner = find_wall(world, x, z, wall);
					// The blocked square neither ahead between its two walls nor passed on its far side.
					const float across = wall.x * way.x * -2.0f, along = wall.z * way.z * -2.0f;
					if (std::abs(std::abs(std::atan2(way.z, way.x)) - std::acos(-1.0f) / 2.0f) < 0.02f || std::abs(std::sin(std::atan2(way.z, way.x))) < 0.02f) {
						continue; // along a wall: either will do
					}
					const bool is_bend = is_corner && (across > 0.0f) != (along > 0.0f) && world.is_visible(from, here);
					const bool is_seen = std::find(seen.begin(), seen.end(), here) != seen.end();
					CHECK(is_seen == is_bend);
					count += is_bend;
				}
			}
		}
	}
	CHECK(count > 500);
}

TEST_CASE("nobody sees from one kind of ground into another") {
	NavRegion region;
	region.vertices = { { 0, 0, 0 }, { 0, 0, 2 }, { 2, 0, 2 }, { 2, 0, 0 }, { 4, 0, 2 }, { 4, 0, 0 } };
	region.polygons = { { 0, 1, 2, 3 }, { 3, 2, 4, 5 } };
	region.costs = { 1.0f, 2.0f };
	const NavMesh mesh = NavMesh::build({ &region, 1 });
	Sight sight(mesh, mesh.corner_graph().corners());
	const NavPoint west = mesh.nearest({ 1, 0, 1 }, 1), east = mesh.nearest({ 3, 0, 1 }, 1), border = mesh.nearest({ 2, 0, 1 }, 1);
	CHECK(std::isinf(sight.straight(west, east)));
	CHECK(sight.straight(west, border) == doctest::Approx(1.0));
	CHECK(sight.straight(border, east) == doctest::Approx(2.0));
	CHECK(sight.look(west).size() == 2); // the ends of the border
}
