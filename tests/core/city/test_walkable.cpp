#include <doctest/doctest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "core/city/footprint_layout.h"
#include "core/city/free_ground.h"
#include "core/city/walkable.h"
#include "core/navigation/nav_mesh_paths.h"

using namespace pcg;

namespace {

// A city without rules: every lot is a lawn.
City empty_city(const LayoutParameters &parameters) {
	Diagnostics diagnostics;
	City city;
	city.layout = *make_layout(parameters, diagnostics);
	city.lots.resize(city.layout.lots.size());
	for (size_t i = 0; i < city.lots.size(); ++i) {
		city.lots[i].free_ground = free_ground(city.layout.lots[i], cga::DerivationResult());
	}
	return city;
}

void build_over(City &city, LotId lot) { city.lots[index_of(lot)].free_ground.clear(); }

// A door in the middle of the lot's front.
void add_door(City &city, LotId lot) {
	Entrance entrance;
	entrance.building = city.model.add_building(lot);
	entrance.type = city.model.types.add("house");
	const std::vector<glm::vec3> &polygon = city.layout.lot(lot).polygon;
	entrance.position = (polygon[0] + polygon[1]) / 2.0f;
	city.model.add_entrance(entrance);
}

double triangle_area(const std::vector<glm::vec3> &triangles) {
	double sum = 0.0;
	for (size_t i = 0; i + 2 < triangles.size(); i += 3) {
		sum += double(glm::cross(triangles[i + 1] - triangles[i], triangles[i + 2] - triangles[i]).y) / 2.0;
	}
	return sum;
}

} // namespace

TEST_CASE("the ground handed to a baker covers the tile, and looks upwards") {
	const City city = empty_city(layout_for_lots(1));
	const glm::vec3 size = city.layout.max - city.layout.min;
	CHECK(triangle_area(tile_faces(city, { city.layout.min, city.layout.max }, 2.0f)) == doctest::Approx(double(size.x) * size.z));
}

TEST_CASE("a baker is given no ground where a building stands") {
	City city = empty_city(layout_for_lots(4));
	const double before = triangle_area(tile_faces(city, { city.layout.min, city.layout.max }, 2.0f));
	build_over(city, LotId(2));
	CHECK(before - triangle_area(tile_faces(city, { city.layout.min, city.layout.max }, 2.0f)) == doctest::Approx(400.0));
}

TEST_CASE("a patch takes ground away and puts its own there, for a baker and for the mesh") {
	City city = empty_city(layout_for_lots(4));
	const Tile all = { city.layout.min, city.layout.max };
	const double before = triangle_area(tile_faces(city, all, 2.0f));
	const std::vector<glm::vec3> &lot = city.layout.lots[0].polygon; // 20 m by 20 m
	const glm::vec3 middle = (lot[0] + lot[2]) / 2.0f, east(1, 0, 0), north(0, 0, -1);
	const auto square = [&](float half) {
		return std::vector<glm::vec3>{ middle - (east + north) * half, middle + (east - north) * half, middle + (east + north) * half,
			middle + (north - east) * half };
	};
	// A monument of 6 m by 6 m with a yard of 2 m by 2 m in it, and an L of 3 * 4 m2 beside it.
	city.patches = { { square(3.0f), { square(1.0f) } } };
	const glm::vec3 corner = middle + east * 4.0f;
	city.patches.push_back({ { corner, corner + east * 4.0f, corner + east * 4.0f + north * 2.0f, corner + east * 2.0f + north * 2.0f,
									 corner + east * 2.0f + north * 4.0f, corner + north * 4.0f }, {} });
	CHECK(before - triangle_area(tile_faces(city, all, 2.0f)) == doctest::Approx(36.0 - 4.0 + 12.0).epsilon(1e-4));
	const NavMesh mesh = city_nav_mesh(city);
	CHECK_FALSE(mesh.nearest(middle + east * 2.0f, 0.5f).is_on_mesh());
	CHECK(mesh.nearest(middle, 0.1f).is_on_mesh());
	CHECK_FALSE(mesh.nearest(corner + (east + north) * 1.0f, 0.5f).is_on_mesh());
	CHECK(mesh.nearest(corner + (east + north) * 3.5f, 0.1f).is_on_mesh());
	CHECK(mesh.component_count() == 2); // the yard is closed
	CHECK(mesh.component_area(0) + mesh.component_area(1) == doctest::Approx(before - 44.0).epsilon(1e-4));
}

TEST_CASE("a later patch lies over an earlier one") {
	City city = empty_city(layout_for_lots(1));
	const std::vector<glm::vec3> lot = city.layout.lots[0].polygon;
	const glm::vec3 middle = (lot[0] + lot[2]) / 2.0f;
	city.patches = { { lot, {} }, { lot, { lot } } };
	CHECK(city_nav_mesh(city).nearest(middle, 0.1f).is_on_mesh());
	std::swap(city.patches[0], city.patches[1]);
	CHECK_FALSE(city_nav_mesh(city).nearest(middle, 0.1f).is_on_mesh());
}

TEST_CASE("a tile of a large city is given its surroundings only") {
	const City city = empty_city(layout_for_lots(300));
	const Tile &tile = city.layout.tiles[7];
	const std::vector<glm::vec3> triangles = tile_faces(city, tile, 2.0f);
	CHECK(triangles.size() < 3 * 2 * 80);
	for (const glm::vec3 &corner : triangles) {
		CHECK(corner.x > tile.min.x - 120.0f);
		CHECK(corner.x < tile.max.x + 120.0f);
	}
}

TEST_CASE("all streets, pavements and lots of a city are connected") {
	for (uint32_t lots : { 1u, 7u, 40u, 300u }) {
		const City city = empty_city(layout_for_lots(lots));
		const NavMesh mesh = city_nav_mesh(city);
		CHECK(mesh.component_count() == 1);
		const glm::vec3 size = city.layout.max - city.layout.min;
		CHECK(mesh.component_area(0) == doctest::Approx(double(size.x) * size.z));
	}
}

TEST_CASE("people cross streets at crossings and keep to the pavements") {
	LayoutParameters parameters;
	parameters.blocks_x = 2;
	parameters.blocks_z = 1;
	City city = empty_city(parameters);
	for (size_t i = 0; i < city.lots.size(); ++i) {
		build_over(city, LotId(i));
	}
	const NavMesh mesh = city_nav_mesh(city);
	PathFinder finder(mesh);
	// From one block's eastern pavement to the next block's western one, 5 m north of a crossing: straight over the street it would be 11 m.
	const float z = 15.0f;
	const NavPoint from = mesh.nearest({ -5.5f, 0, z }, 1), to = mesh.nearest({ 5.5f, 0, z }, 1);
	REQUIRE(finder.find(from, to));
	for (size_t i = 1; i < finder.points().size(); ++i) {
		for (int k = 0; k <= 20; ++k) {
			const glm::vec3 p = glm::mix(finder.points()[i - 1], finder.points()[i], float(k) / 20.0f);
			const bool is_on_carriageway = std::abs(p.x) < 3.9f && std::abs(p.z) < 19.9f;
			CHECK_FALSE(is_on_carriageway);
		}
	}
}

TEST_CASE("an entrance that cannot be reached is a warning that names the lot") {
	LayoutParameters parameters = layout_for_lots(3);
	parameters.land_use = { { "house", 1.0 } };
	City city = empty_city(parameters);
	add_door(city, LotId(0));
	Diagnostics diagnostics;
	const auto report = [&] { report_unreachable(city, reach_of_entrances(city.model, city_nav_mesh(city)), diagnostics); };
	report();
	CHECK(diagnostics.is_empty());
	city.model.move_entrance(EntranceId(0), { 0, 0, 500 }, { 0, 0, 1 });
	report();
	REQUIRE(diagnostics.warning_count() == 1);
	CHECK(diagnostics.list()[0].message.find("1 of 1 entrance cannot be reached on foot: lot 0 (house)") == 0);
}

TEST_CASE("zones without ground are one warning that names their lots") {
	LayoutParameters parameters = layout_for_lots(3);
	parameters.land_use = { { "park", 1.0 } };
	City city = empty_city(parameters);
	const TypeId park = city.model.types.add("park");
	for (uint32_t i = 0; i < 2; ++i) {
		city.model.add_zone({ park, city.layout.lots[i].polygon, 3.0f, LotId(i), false });
	}
	const auto message = [&] {
		Diagnostics diagnostics;
		report_unreachable_zones(city, reach_of_zones(city.model, city_nav_mesh(city)), diagnostics);
		return diagnostics.is_empty() ? std::string() : diagnostics.list()[0].message;
	};
	CHECK(message() == "");
	city.model.move_zone(ZoneId(1), { { 0, 50, 0 }, { 9, 50, 0 }, { 9, 50, -9 } }, 3.0f);
	CHECK(message() == "1 of 2 zones cannot be reached on foot: lot 1 (park), type `park`, no walkable ground in it");
	city.model.put_zone(ZoneId(0), { park, { { 500, 0, 0 }, { 509, 0, 0 }, { 509, 0, -9 } }, 3.0f, LotId::Invalid, false });
	CHECK(message().find("2 of 2 zones cannot be reached on foot: on no lot, type `park`, no walkable ground in it; lot 1") == 0);
}

TEST_CASE("many entrances that cannot be reached are one warning that counts them and names the first five") {
	LayoutParameters parameters = layout_for_lots(9);
	parameters.land_use = { { "house", 1.0 } };
	City city = empty_city(parameters);
	std::vector<Reach> verdicts;
	for (uint32_t i = 0; i < 9; ++i) {
		add_door(city, LotId(i));
		verdicts.push_back(i == 1 ? Reach::Reachable : i == 3 ? Reach::Removed : i == 4 ? Reach::Island : Reach::OffMesh);
	}
	Diagnostics diagnostics;
	report_unreachable(city, verdicts, diagnostics);
	REQUIRE(diagnostics.warning_count() == 1);
	const std::string &message = diagnostics.list()[0].message;
	CHECK(message.find("7 of 8 entrances cannot be reached on foot: lot 0 (house)") == 0);
	for (const char *told : { "lot 2 (house)", "lot 4 (house)", "lot 5 (house)", "lot 6 (house)", "is not connected with the streets", "; and 2 more" }) {
		CHECK_MESSAGE(message.find(told) != std::string::npos, told);
	}
	for (const char *left_out : { "lot 1 ", "lot 3 ", "lot 7 ", "lot 8 " }) {
		CHECK_MESSAGE(message.find(left_out) == std::string::npos, left_out);
	}
}

TEST_CASE("around 196 houses that stand free every corner is looked out of to the end") {
	std::vector<Footprint> houses;
	for (int i = 0; i < 196; ++i) {
		const double x = 60.0 * (i % 14), y = 60.0 * (i / 14);
		houses.emplace_back().outline = { { x, y }, { x + 20, y }, { x + 20, y + 20 }, { x, y + 20 } };
	}
	Diagnostics diagnostics;
	City city;
	city.layout = *layout_of_footprints(houses, LayoutParameters(), diagnostics);
	city.lots.resize(houses.size());
	const NavMesh mesh = city_nav_mesh(city);
	CHECK(mesh.corner_graph().corners().count() >= 4 * houses.size());
	CHECK(mesh.corner_graph().cut_short_count() == 0);
}
