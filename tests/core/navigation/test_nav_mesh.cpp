#include <doctest/doctest.h>

#include <cmath>

#include "core/navigation/corner_graph.h"
#include "core/navigation/nav_mesh.h"
#include "core/navigation/path_finder.h"
#include "tests/core/navigation/grid_world.h"

using namespace pcg;
using pcg::test::GridWorld;

namespace {

NavRegion rectangle(float x0, float z0, float x1, float z1, float y = 0.0f) {
	NavRegion region;
	region.vertices = { { x0, y, z0 }, { x0, y, z1 }, { x1, y, z1 }, { x1, y, z0 } };
	region.polygons = { { 0, 1, 2, 3 } };
	return region;
}

NavMesh mesh_of(std::vector<NavRegion> regions) { return NavMesh::build(regions); }

} // namespace

TEST_CASE("polygons that share an edge are linked both ways, with the gap's ends on the right hands") {
	NavRegion region;
	region.vertices = { { 0, 0, 0 }, { 0, 0, 2 }, { 3, 0, 2 }, { 3, 0, 0 }, { 5, 0, 2 }, { 5, 0, 0 } };
	region.polygons = { { 0, 1, 2, 3 }, { 3, 5, 4, 2 } }; // the second runs the other way around
	const NavMesh mesh = mesh_of({ region });
	REQUIRE(mesh.links().size() == 2);
	const NavLink &east = mesh.links()[mesh.first_link(0)];
	CHECK(east.target == 1);
	// Walking east, north (-z) is on the left.
	CHECK(mesh.point(east.left) == glm::vec3(3, 0, 0));
	CHECK(mesh.point(east.right) == glm::vec3(3, 0, 2));
	const NavLink &west = mesh.links()[mesh.first_link(1)];
	CHECK(mesh.point(west.left) == glm::vec3(3, 0, 2));
	CHECK(mesh.source(mesh.first_link(0)) == 0);
	CHECK(mesh.source(mesh.first_link(1)) == 1);
	CHECK(mesh.point_count() == 6);
	CHECK(mesh.component(0) == mesh.component(1));
	CHECK(mesh.component_area(0) == doctest::Approx(10.0));
}

TEST_CASE("regions are joined across a seam where their edges overlap, even with other vertices and a small gap") {
	// West: one edge from z = 0 to 6. East: two polygons from z = 1 to 3 and 4 to 9, 0.1 m away.
	const NavMesh mesh = mesh_of({ rectangle(0, 0, 4, 6), rectangle(4.1f, 1, 8, 3), rectangle(4.1f, 4, 8, 9) });
	REQUIRE(mesh.links().size() == 4);
	const NavLink &first = mesh.links()[mesh.first_link(0)], &second = mesh.links()[mesh.first_link(0) + 1];
	CHECK(std::abs(mesh.point(first.left).z - mesh.point(first.right).z) == doctest::Approx(2.0));
	CHECK(std::abs(mesh.point(second.left).z - mesh.point(second.right).z) == doctest::Approx(2.0));
	CHECK(mesh.point(first.left).x == doctest::Approx(4.05));
	CHECK(mesh.component_count() == 1);
}

TEST_CASE("edges too far apart, at other heights, crosswise or side by side in one direction are not joined") {
	CHECK(mesh_of({ rectangle(0, 0, 4, 4), rectangle(4.3f, 0, 8, 4) }).links().empty());
	CHECK(mesh_of({ rectangle(0, 0, 4, 4), rectangle(4, 0, 8, 4, 1.0f) }).links().empty());
	CHECK(mesh_of({ rectangle(0, 0, 4, 4), rectangle(4, 0, 8, 4, 0.5f) }).links().size() == 2);
	CHECK(mesh_of({ rectangle(0, 0, 4, 4), rectangle(4, 4, 8, 8) }).links().empty()); // a common corner only
	CHECK(mesh_of({ rectangle(0, 0, 4, 4), rectangle(1, 0, 4.1f, 4) }).links().empty()); // overlapping
}

TEST_CASE("the nearest point is found from inside, beside, above and not from too far") {
	const NavMesh mesh = mesh_of({ rectangle(0, 0, 4, 4), rectangle(10, 0, 14, 4, 2.0f) });
	CHECK(mesh.nearest({ 1, 0, 1 }, 1).position == glm::vec3(1, 0, 1));
	CHECK(mesh.nearest({ 5, 0, 2 }, 2).position == glm::vec3(4, 0, 2));
	CHECK(mesh.nearest({ 5, 0, 5 }, 2).position == glm::vec3(4, 0, 4));
	CHECK(mesh.nearest({ 9.5f, 2.5f, 1 }, 2).position == glm::vec3(10, 2, 1));
	CHECK_FALSE(mesh.nearest({ 7, 0, 2 }, 2).is_on_mesh());
	CHECK(mesh.nearest({ 6, 0, 2 }, 100).polygon == 0);
	CHECK_FALSE(mesh.nearest({ NAN, 0, 2 }, 100).is_on_mesh());
	CHECK_FALSE(NavMesh().nearest({ 0, 0, 0 }, 100).is_on_mesh());
	CHECK_FALSE(mesh_of({}).nearest({ 0, 0, 0 }, 100).is_on_mesh());
}

TEST_CASE("the nearest point on a slope lies at the slope's height") {
	NavRegion region;
	region.vertices = { { 0, 0, 0 }, { 0, 0, 4 }, { 4, 2, 4 }, { 4, 2, 0 } };
	region.polygons = { { 0, 1, 2, 3 } };
	CHECK(mesh_of({ region }).nearest({ 1, 0.4f, 2 }, 1).position.y == doctest::Approx(0.5));
}

TEST_CASE("the nearest polygon is the one that looking at all of them finds") {
	const GridWorld world(30, 20, 0.5, 3);
	const NavMesh mesh = mesh_of({ world.region(0, 30) });
	Random random(4);
	for (int i = 0; i < 300; ++i) {
		const glm::vec3 point{ float(random.uniform(-5, 35)), 0, float(random.uniform(-5, 25)) };
		float best = INFINITY;
		for (uint32_t polygon = 0; polygon < mesh.polygon_count(); ++polygon) {
			best = std::min(best, glm::distance(mesh.nearest_in(polygon, point), point));
		}
		const NavPoint found = mesh.nearest(point, 50);
		REQUIRE(found.is_on_mesh());
		CHECK(glm::distance(found.position, point) == doctest::Approx(best));
	}
}

TEST_CASE("broken polygons are left out, the others stay") {
	NavRegion region = rectangle(0, 0, 4, 4);
	region.vertices.push_back({ NAN, 0, 0 });
	region.polygons.push_back({ 0, 1 });
	region.polygons.push_back({ 0, 1, 99 });
	region.polygons.push_back({ 0, 1, 4 });
	region.polygons.push_back({ 0, 1, 1 });
	CHECK(mesh_of({ region }).polygon_count() == 1);
}

TEST_CASE("a world cut into regions has the same walks as in one piece") {
	for (uint64_t seed = 0; seed < 20; ++seed) {
		CAPTURE(seed);
		const GridWorld world(16, 12, 0.3, seed);
		const NavMesh whole = mesh_of({ world.region(0, 16) });
		const NavMesh cut = mesh_of({ world.region(0, 5), world.region(5, 11), world.region(11, 16) });
		CHECK(cut.links().size() == whole.links().size());
		CHECK(cut.component_count() == whole.component_count());
		PathFinder in_whole(whole), in_cut(cut);
		Random random(seed);
		for (int i = 0; i < 20; ++i) {
			const glm::vec3 from = world.random_place(random), to = world.random_place(random);
			REQUIRE(in_whole.find(whole.nearest(from, 1), whole.nearest(to, 1)) == in_cut.find(cut.nearest(from, 1), cut.nearest(to, 1)));
			CHECK(in_cut.length() == doctest::Approx(in_whole.length()).epsilon(0.01));
		}
	}
}

TEST_CASE("after a region was replaced walks are as short as on a ground that is built anew") {
	size_t inherited = 0;
	for (uint64_t seed = 0; seed < 30; ++seed) {
		CAPTURE(seed);
		GridWorld world(40, 12, 0.3, seed);
		std::vector<NavRegion> regions = { world.region(0, 17), world.region(17, 23), world.region(23, 40) };
		NavMesh mesh = mesh_of(regions);
		Random random(seed, 1);
		for (int edit = 0; edit < 3; ++edit) {
			for (int i = 0; i < 12; ++i) {
				world.set_free(18 + int(random.index(4)), int(random.index(12)), random.chance(0.5));
			}
			regions[1] = world.region(17, 23);
			PlanBox changed;
			changed.add({ 17, 0, 0 });
			changed.add({ 23, 0, 12 });
			mesh = NavMesh::rebuild(mesh, { &changed, 1 }, regions);
		}
		const NavMesh fresh = mesh_of(regions);
		const CornerGraph &graph = mesh.corner_graph();
		REQUIRE(graph.corners().count() == fresh.corner_graph().corners().count());
		for (uint32_t corner = 0; corner < graph.corners().count(); ++corner) {
			for (const SeenCorner &walk : graph.walks().of(mesh.points(), corner)) {
				const auto back = graph.walks().of(mesh.points(), walk.corner);
				REQUIRE(std::ranges::any_of(back, [&](const SeenCorner &seen) { return seen.corner == corner && seen.cost == walk.cost; }));
			}
			const auto theirs = fresh.corner_graph().walks().of(fresh.points(), corner);
			inherited += std::ranges::equal(graph.walks().of(mesh.points(), corner), theirs, [](const SeenCorner &a, const SeenCorner &b) { return a.corner == b.corner && a.cost == b.cost; });
		}
		PathFinder after(mesh), anew(fresh);
		for (int i = 0; i < 30; ++i) {
			const glm::vec3 from = world.random_place(random), to = world.random_place(random);
			REQUIRE(after.find(mesh.nearest(from, 1), mesh.nearest(to, 1)) == anew.find(fresh.nearest(from, 1), fresh.nearest(to, 1)));
			CHECK(after.length() == doctest::Approx(anew.length()).epsilon(0.01));
		}
	}
	CHECK(inherited > 1000);
}

TEST_CASE("where ways are longer than landmarks have numbers for they are as short as ever, after edits, too") {
	// One way to and fro, 420 m long in 29 m by 29 m.
	GridWorld world(29, 29, 0.0, 1);
	for (int z = 1; z < 29; z += 2) {
		for (int x = 0; x < 29; ++x) {
			world.set_free(x, z, x == (z % 4 == 1 ? 28 : 0));
		}
	}
	NavMesh mesh = world.mesh();
	for (const bool is_open : { false, true, false }) {
		PathFinder finder(mesh);
		for (const glm::vec3 from : { glm::vec3(0.5f, 0, 0.5f), glm::vec3(20.5f, 0, 8.5f) }) {
			const glm::vec3 to(28.5f, 0, 28.5f);
			REQUIRE(finder.find(mesh.nearest(from, 1), mesh.nearest(to, 1)));
			CHECK(finder.length() <= world.shortest(from, to) * 1.01 + 0.001);
			CHECK((is_open || finder.length() > 280.0));
		}
		world.set_free(14, 15, !is_open);
		PlanBox changed;
		changed.add({ 14, 0, 15 });
		changed.add({ 15, 0, 16 });
		const NavRegion region = world.region(0, 29);
		mesh = NavMesh::rebuild(mesh, { &changed, 1 }, { &region, 1 });
	}
}

TEST_CASE("where nothing of the ground before is left it is built anew") {
	const GridWorld world(12, 12, 0.3, 4);
	const NavRegion region = world.region(0, 12);
	PlanBox nothing; // told wrong: all has changed
	const NavMesh mesh = NavMesh::rebuild(GridWorld(12, 12, 0.3, 5).mesh(), { &nothing, 1 }, { &region, 1 });
	PathFinder finder(mesh);
	Random random(4);
	for (int i = 0; i < 30; ++i) {
		const glm::vec3 from = world.random_place(random), to = world.random_place(random);
		const double shortest = world.shortest(from, to);
		REQUIRE(finder.find(mesh.nearest(from, 1), mesh.nearest(to, 1)) == std::isfinite(shortest));
		CHECK((!std::isfinite(shortest) || finder.length() <= shortest * 1.01 + 0.001));
	}
}
