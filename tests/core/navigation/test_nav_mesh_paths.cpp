#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <thread>

#include "core/navigation/nav_mesh_paths.h"
#include "core/navigation/reachability.h"
#include "tests/core/navigation/grid_world.h"

using namespace pcg;
using pcg::test::GridWorld;

namespace {

BuildingId add_building(CityModel &city, std::string_view type, std::initializer_list<glm::vec3> doors) {
	const BuildingId building = city.add_building();
	for (const glm::vec3 &door : doors) {
		Entrance entrance;
		entrance.building = building;
		entrance.type = city.types.add(type);
		entrance.position = door;
		city.add_entrance(entrance);
	}
	return building;
}

// 5 x 3 squares with a wall at x = 2 that leaves the northern row open.
GridWorld walled_world() {
	GridWorld world(5, 3, 0.0, 1);
	world.set_free(2, 1, false);
	world.set_free(2, 2, false);
	return world;
}

double length_of(const std::vector<glm::vec3> &points) {
	double sum = 0.0;
	for (size_t i = 1; i < points.size(); ++i) {
		sum += double(glm::distance(points[i - 1], points[i]));
	}
	return sum;
}

} // namespace

TEST_CASE("buildings are as far apart as one walks between their nearest doors") {
	const NavMesh mesh = walled_world().mesh();
	CityModel city;
	const BuildingId west = add_building(city, "house", { { 0.5f, 0, 2.5f } });
	const BuildingId east = add_building(city, "school", { { 4.5f, 0, 2.5f }, { 4.5f, 0, 0.5f } });
	const NavMeshPaths paths(city, mesh);
	// To the northern door: over the wall's corners (2, 1), (3, 1)? No: the straight line from (2, 1) to (4.5, 0.5) is free, so one bend.
	const double expected = 1.5 * std::sqrt(2.0) + std::hypot(2.5, 0.5);
	CHECK(paths.distance(west, east) == doctest::Approx(expected).epsilon(0.002));
	CHECK(paths.distance(east, west) == paths.distance(west, east));
	CHECK(paths.distance(west, west) == 0.0);
	CHECK(std::isinf(paths.distance(west, BuildingId(9))));
	CHECK(std::isinf(paths.distance(BuildingId::Invalid, west)));
}

TEST_CASE("the nearest school is the nearest to walk to, not as the crow flies") {
	const NavMesh mesh = walled_world().mesh();
	CityModel city;
	const BuildingId home = add_building(city, "house", { { 1.9f, 0, 2.5f } });
	const BuildingId behind_the_wall = add_building(city, "school", { { 3.1f, 0, 2.5f } });
	const BuildingId this_side = add_building(city, "school", { { 0.1f, 0, 0.1f } });
	add_building(city, "shop", { { 40.0f, 0, 0.1f } });
	const NavMeshPaths paths(city, mesh);
	CHECK(paths.distance(home, behind_the_wall) > paths.distance(home, this_side));
	CHECK(paths.nearest_building(city.types.find("school"), home) == this_side);
	CHECK(paths.nearest_building(city.types.find("school"), home) == this_side);
	CHECK(paths.nearest_building(city.types.find("house"), home) == home);
	CHECK(paths.nearest_building(city.types.find("shop"), home) == BuildingId::Invalid); // off the mesh
	CHECK(paths.nearest_building(TypeId::Invalid, home) == BuildingId::Invalid);
	CHECK(paths.nearest_building(city.types.find("house"), BuildingId(99)) == BuildingId::Invalid);
}

TEST_CASE("equally near buildings: the lower id") {
	const NavMesh mesh = GridWorld(11, 3, 0.0, 1).mesh();
	CityModel city;
	const BuildingId home = add_building(city, "house", { { 5.5f, 0, 1.5f } });
	const BuildingId east = add_building(city, "school", { { 9.5f, 0, 1.5f } });
	add_building(city, "school", { { 1.5f, 0, 1.5f } });
	CHECK(NavMeshPaths(city, mesh).nearest_building(city.types.find("school"), home) == east);
}

TEST_CASE("a path has the asked points as ends, also a little off the mesh, and is the same backwards") {
	const NavMesh mesh = walled_world().mesh();
	const CityModel city;
	const NavMeshPaths paths(city, mesh);
	const std::vector<glm::vec3> there = paths.path({ -1.0f, 0, 2.5f }, { 4.5f, 0, 2.5f });
	REQUIRE(there.size() == 5);
	CHECK(there.front() == glm::vec3(-1.0f, 0, 2.5f));
	CHECK(there[1] == glm::vec3(0, 0, 2.5f));
	CHECK(there.back() == glm::vec3(4.5f, 0, 2.5f));
	std::vector<glm::vec3> back = paths.path({ 4.5f, 0, 2.5f }, { -1.0f, 0, 2.5f });
	std::reverse(back.begin(), back.end());
	CHECK(back == there);
	CHECK(paths.path({ -3.0f, 0, 2.5f }, { 4.5f, 0, 2.5f }).empty());
	CHECK(paths.path({ 1, 0, 1 }, { 1, 0, 1 }).size() == 2);
}

TEST_CASE("the nearest walkable point is found from any distance") {
	const NavMesh mesh = walled_world().mesh();
	CityModel city;
	const NavMeshPaths paths(city, mesh);
	glm::vec3 point{ 0.0f };
	CHECK(paths.nearest_walkable({ 0.5f, 40.0f, 0.5f }, point));
	CHECK(point == glm::vec3(0.5f, 0.0f, 0.5f));
	CHECK(paths.nearest_walkable({ -30.0f, 0.0f, 1.5f }, point));
	CHECK(glm::distance(point, glm::vec3(0.0f, 0.0f, 1.5f)) < 0.001f);
	CHECK(paths.nearest_walkable({ -3000.0f, 0.0f, 1.5f }, point));
	CHECK(point.x == 0.0f);
	CHECK(std::hypot(3000.0, double(point.z) - 1.5) < 3000.0 + 0.001); // from so far away cells beside each other are equally far in floats
	const NavMesh empty;
	CHECK(!NavMeshPaths(city, empty).nearest_walkable({ 0.0f, 0.0f, 0.0f }, point));
}

TEST_CASE("distances are the lengths of the paths between the doors, on mazes, for any number of threads") {
	for (uint64_t seed = 0; seed < 10; ++seed) {
		CAPTURE(seed);
		const GridWorld world(20, 20, 0.35, seed);
		const NavMesh mesh = world.mesh();
		CityModel city;
		Random random(seed);
		for (int i = 0; i < 25; ++i) {
			add_building(city, i % 5 == 0 ? "school" : "house", { world.random_place(random) });
		}
		const NavMeshPaths alone(city, mesh), shared(city, mesh);
		const auto ask = [&](const NavMeshPaths &paths) {
			double sum = 0.0;
			for (uint32_t a = 0; a < 25; ++a) {
				for (uint32_t b = 0; b < 25; ++b) {
					const double metres = paths.distance(BuildingId(a), BuildingId(b));
					sum += std::isfinite(metres) ? metres * (a + 1) : 1.0;
				}
				sum += to_number(paths.nearest_building(city.types.find("school"), BuildingId(a)));
			}
			return sum;
		};
		double first = 0.0, second = 0.0;
		std::thread other([&] { first = ask(shared); });
		second = ask(shared);
		other.join();
		CHECK(first == ask(alone));
		CHECK(second == first);
		for (uint32_t b = 1; b < 25; ++b) {
			const double metres = alone.distance(BuildingId(0), BuildingId(b));
			const std::vector<glm::vec3> path = alone.path(city.entrances()[0].position, city.entrances()[b].position);
			CHECK(path.empty() == std::isinf(metres));
			CHECK((path.empty() || std::abs(length_of(path) - metres) < 0.0051));
		}
	}
}

TEST_CASE("the nearest building is the best of all distances, to a hundredth") {
	for (uint64_t seed = 8; seed < 14; ++seed) {
		CAPTURE(seed);
		const GridWorld world(24, 24, 0.3, seed);
		const NavMesh mesh = world.mesh();
		CityModel city;
		Random random(seed);
		for (int i = 0; i < 60; ++i) {
			add_building(city, i % 4 == 0 ? "shop" : "house", { world.random_place(random), world.random_place(random) });
		}
		const NavMeshPaths paths(city, mesh);
		const TypeId shop = city.types.find("shop");
		for (uint32_t i = 0; i < 60; ++i) {
			double best = std::numeric_limits<double>::infinity();
			for (BuildingId candidate : city.buildings_of_type(shop)) {
				best = std::fmin(best, paths.distance(BuildingId(i), candidate));
			}
			const BuildingId nearest = paths.nearest_building(shop, BuildingId(i));
			REQUIRE(is_valid(nearest) == std::isfinite(best));
			CHECK((!is_valid(nearest) || paths.distance(BuildingId(i), nearest) <= best * 1.01 + 0.01));
			CHECK((i % 4 != 0 || nearest == BuildingId(i)));
		}
	}
}

TEST_CASE("after an edit and prepare() the answers are those of the edited city") {
	const NavMesh mesh = GridWorld(20, 3, 0.0, 1).mesh();
	CityModel city;
	const BuildingId home = add_building(city, "house", { { 0.5f, 0, 1.5f } });
	const BuildingId near = add_building(city, "school", { { 5.5f, 0, 1.5f } });
	const BuildingId far = add_building(city, "school", { { 15.5f, 0, 1.5f } });
	NavMeshPaths paths(city, mesh);
	CHECK(paths.nearest_building(city.types.find("school"), home) == near);
	city.move_entrance(city.building(near).entrances[0], { 19.5f, 0, 1.5f }, { 1, 0, 0 });
	paths.prepare();
	CHECK(paths.distance(home, near) == doctest::Approx(19.0));
	CHECK(paths.nearest_building(city.types.find("school"), home) == far);
	city.remove_building(far);
	paths.prepare();
	CHECK(paths.nearest_building(city.types.find("school"), home) == near);
	// Buildings and types that came later are known from the next prepare() on.
	const BuildingId new_shop = add_building(city, "shop", { { 9.5f, 0, 1.5f } });
	CHECK(std::isinf(paths.distance(home, new_shop)));
	CHECK(paths.nearest_building(city.types.find("shop"), home) == BuildingId::Invalid);
	CHECK(paths.nearest_building(city.types.find("school"), new_shop) == BuildingId::Invalid);
	paths.prepare();
	CHECK(paths.nearest_building(city.types.find("shop"), home) == new_shop);
}

TEST_CASE("after the ground was replaced and prepare() the answers are those of the new ground") {
	NavMesh mesh = walled_world().mesh();
	CityModel city;
	const BuildingId west = add_building(city, "house", { { 0.5f, 0, 2.5f } });
	const BuildingId east = add_building(city, "school", { { 4.5f, 0, 2.5f } });
	NavMeshPaths paths(city, mesh);
	CHECK(paths.distance(west, east) == doctest::Approx(1.0 + 3.0 * std::sqrt(2.0)).epsilon(0.002));
	mesh = GridWorld(5, 3, 0.0, 1).mesh();
	paths.prepare();
	CHECK(paths.distance(west, east) == doctest::Approx(4.0));
	mesh = NavMesh();
	paths.prepare();
	CHECK(std::isinf(paths.distance(west, east)));
	CHECK(paths.path({ 0.5f, 0, 2.5f }, { 4.5f, 0, 2.5f }).empty());
}

TEST_CASE("the nearest zone is the nearest to walk to, entered at its nearest reachable point") {
	const NavMesh mesh = walled_world().mesh();
	CityModel city;
	const auto add_park = [&](float x0, float z0, float x1, float z1) {
		Zone zone;
		zone.type = city.types.add("park");
		zone.polygon = { { x0, 0, z1 }, { x1, 0, z1 }, { x1, 0, z0 }, { x0, 0, z0 } };
		return city.add_zone(zone);
	};
	const ZoneId behind_the_wall = add_park(3, 2, 4, 3);
	const ZoneId this_side = add_park(0, 0, 1, 1);
	add_park(50, 50, 60, 60);
	const NavMeshPaths paths(city, mesh);
	glm::vec3 entry{ 0.0f };
	CHECK(paths.nearest_zone(city.types.find("park"), { 1.9f, 0, 2.9f }, entry) == this_side);
	CHECK(entry == glm::vec3(1, 0, 1));
	CHECK(paths.nearest_zone(city.types.find("park"), { 3.5f, 0, 1.5f }, entry) == behind_the_wall);
	CHECK(entry == glm::vec3(3.5f, 0, 2));
	CHECK(paths.nearest_zone(TypeId::Invalid, { 0, 0, 0 }, entry) == ZoneId::Invalid);
	CHECK(paths.nearest_zone(city.types.find("park"), { -90, 0, 0 }, entry) == ZoneId::Invalid);
}

TEST_CASE("doors off the mesh, on an island and removed are told from those that can be reached") {
	GridWorld world(8, 3, 0.0, 1);
	for (int z = 0; z < 3; ++z) {
		world.set_free(5, z, false);
	}
	CityModel city;
	add_building(city, "house", { { 0.5f, 0, 0.5f }, { 6.5f, 0, 0.5f }, { 20, 0, 0 }, { 1, 0, 1 } });
	city.remove_entrance(EntranceId(3));
	CHECK(reach_of_entrances(city, world.mesh()) == std::vector<Reach>{ Reach::Reachable, Reach::Island, Reach::OffMesh, Reach::Removed });
}

TEST_CASE("zones are reached at their middle, a corner or their outline, and those without ground, on an island or nowhere are told from them") {
	GridWorld world(24, 3, 0.0, 1);
	for (int z = 0; z < 3; ++z) {
		for (int x = 14; x < 20; ++x) {
			world.set_free(x, z, false);
		}
	}
	CityModel city;
	const auto add_zone = [&](float x0, float z0, float x1, float z1) {
		Zone zone;
		zone.polygon = { { x0, 0, z1 }, { x1, 0, z1 }, { x1, 0, z0 }, { x0, 0, z0 } };
		city.add_zone(zone);
	};
	add_zone(1, 1, 3, 2);
	add_zone(5, -40, 45, 41); // around much more than the ground
	add_zone(2, -60, 40, 1.5f); // only one of its sides meets it
	add_zone(20.5f, 0, 23, 2);
	add_zone(16.9f, 1.2f, 17.1f, 1.3f);
	add_zone(100, 0, 110, 10);
	add_zone(NAN, 0, INFINITY, 1);
	city.add_zone(Zone());
	add_zone(0, 0, 1, 1);
	city.remove_zone(ZoneId(8));
	CHECK(reach_of_zones(city, world.mesh(), 1.0f) == std::vector<Reach>{ Reach::Reachable, Reach::Reachable, Reach::Reachable, Reach::Island, Reach::OffMesh,
			Reach::OffMesh, Reach::OffMesh, Reach::OffMesh, Reach::Removed });
}

TEST_CASE("a way that led where people walk can be walked until the ground on it has changed") {
	GridWorld world(20, 3, 0.0, 1);
	NavMesh mesh = world.mesh();
	CityModel city;
	NavMeshPaths paths(city, mesh);
	const std::vector<glm::vec3> middle = { { 0.5f, 0, 1.5f }, { 8.0f, 0, 1.5f }, { 19.5f, 0, 1.5f } };
	const std::vector<glm::vec3> side = { { 0.5f, 0, 0.5f }, { 19.5f, 0, 0.5f } };
	CHECK(paths.ground_revision() == 0);
	CHECK(paths.is_walkable(middle, 0));
	world.set_free(10, 1, false);
	mesh = world.mesh();
	paths.note_new_ground({ 10, 0, 0 }, { 15, 0, 3 });
	paths.prepare();
	const uint64_t first = paths.ground_revision();
	CHECK(first > 0);
	CHECK(!paths.is_walkable(middle, 0));
	CHECK(paths.is_walkable(middle, first)); // it was known
	CHECK(paths.is_walkable(side, 0));
	CHECK(paths.is_walkable(std::vector(middle.begin(), middle.begin() + 2), 0)); // ends before it
	CHECK(paths.is_walkable(paths.path(middle.front(), middle.back()), 0));
	paths.note_new_ground({ 0, 0, 0 }, { 5, 0, 3 });
	CHECK(paths.is_walkable(middle, first)); // not there
	paths.note_new_ground({ 10, 0, 0 }, { 15, 0, 3 });
	CHECK(!paths.is_walkable(middle, first));
	// Doors lie beside the ground: from there and to there people step.
	paths.note_new_ground({ 10, 0, -5 }, { 15, 0, 3 });
	CHECK(paths.is_walkable(std::vector<glm::vec3>{ { 12.0f, 0, -1.5f }, { 12.0f, 0, 0.5f }, { 19.5f, 0, 0.5f } }, 0));
	CHECK(!paths.is_walkable(std::vector<glm::vec3>{ { 12.0f, 0, -3.5f }, { 12.0f, 0, 0.5f }, { 19.5f, 0, 0.5f } }, 0));
}
