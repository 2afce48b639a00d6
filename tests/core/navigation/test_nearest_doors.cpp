#include <doctest/doctest.h>

#include <cmath>

#include "core/navigation/corner_graph.h"
#include "core/navigation/nearest_doors.h"
#include "core/navigation/path_finder.h"
#include "tests/core/navigation/grid_world.h"

using namespace pcg;
using pcg::test::GridWorld;

namespace {

std::vector<Door> random_doors(const GridWorld &world, const NavMesh &mesh, size_t count, Random &random) {
	std::vector<Door> doors;
	for (uint32_t i = 0; i < count; ++i) {
		doors.push_back({ mesh.nearest(world.random_place(random), 1.0f), float(i % 3) / 4.0f, 100 + i });
	}
	return doors;
}

} // namespace

TEST_CASE("the nearest door is that of all searches one by one") {
	size_t found = 0, alone = 0;
	for (uint64_t seed = 0; seed < 30; ++seed) {
		CAPTURE(seed);
		const GridWorld world(18, 16, 0.42, seed);
		const NavMesh mesh = world.mesh();
		Random random(seed, 1);
		const std::vector<Door> doors = random_doors(world, mesh, 1 + seed % 9, random);
		const NearestDoors nearest(mesh, doors);
		Sight sight(mesh, mesh.corner_graph().corners());
		PathFinder finder(mesh);
		for (int i = 0; i < 20; ++i) {
			const NavPoint from = mesh.nearest(world.random_place(random), 1.0f);
			double best = INFINITY;
			for (const Door &door : doors) {
				best = std::fmin(best, finder.find(from, door.point) ? finder.length() + double(door.step) : INFINITY);
			}
			const NearDoor answer = nearest.ask(sight, from);
			CHECK((answer.door == no_door) == std::isinf(best));
			if (answer.door == no_door) {
				++alone;
				continue;
			}
			++found;
			CHECK(double(answer.cost) <= best + 0.001); // searches one by one may take a hundredth more
			CHECK(best <= double(answer.cost) * 1.01 + 0.001);
			REQUIRE(finder.find(from, doors[answer.door - 100].point));
			CHECK(finder.length() + double(doors[answer.door - 100].step) <= double(answer.cost) * 1.01 + 0.001);
		}
	}
	CHECK(found > 200);
	CHECK(alone > 0);
}

TEST_CASE("a door in view is nearest by the straight way, and off the mesh there is none") {
	const GridWorld world(10, 10, 0.0, 1);
	const NavMesh mesh = world.mesh();
	const std::vector<Door> doors = { { mesh.nearest({ 1, 0, 1 }, 1), 0.0f, 3 }, { mesh.nearest({ 4, 0, 5 }, 1), 0.0f, 8 }, { {}, 0.0f, 1 } };
	const NearestDoors nearest(mesh, doors);
	Sight sight(mesh, mesh.corner_graph().corners());
	CHECK(nearest.ask(sight, mesh.nearest({ 1, 0, 2 }, 1)) == NearDoor{ 1.0f, 3 });
	CHECK(nearest.ask(sight, mesh.nearest({ 8, 0, 8 }, 1)) == NearDoor{ 5.0f, 8 });
	CHECK(nearest.ask(sight, {}).door == no_door);
	CHECK(NearestDoors(mesh, {}).ask(sight, mesh.nearest({ 8, 0, 8 }, 1)).door == no_door);
}

TEST_CASE("of doors equally near the one of the lower id") {
	const NavMesh mesh = GridWorld(11, 3, 0.0, 1).mesh();
	const std::vector<Door> doors = { { mesh.nearest({ 9.5f, 0, 1.5f }, 1), 0.0f, 7 }, { mesh.nearest({ 1.5f, 0, 1.5f }, 1), 0.0f, 2 } };
	Sight sight(mesh, mesh.corner_graph().corners());
	CHECK(NearestDoors(mesh, doors).ask(sight, mesh.nearest({ 5.5f, 0, 1.5f }, 1)).door == 2);
}
