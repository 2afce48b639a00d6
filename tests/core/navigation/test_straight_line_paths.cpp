#include <doctest/doctest.h>

#include <cmath>

#include "core/navigation/straight_line_paths.h"

using namespace pcg;

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

} // namespace

TEST_CASE("without navigation the distance is the straight line between the nearest doors, both ways") {
	CityModel city;
	const BuildingId a = add_building(city, "house", { { 0, 0, 0 }, { 0, 0, -10 } });
	const BuildingId b = add_building(city, "school", { { 3, 0, -14 }, { 40, 0, 0 } });
	const BuildingId doorless = city.add_building();
	const StraightLinePaths paths(city);
	CHECK(paths.distance(a, b) == doctest::Approx(5.0));
	CHECK(paths.distance(b, a) == doctest::Approx(5.0));
	CHECK(paths.distance(a, a) == 0.0);
	CHECK(std::isinf(paths.distance(a, doorless)));
	CHECK(std::isinf(paths.distance(a, BuildingId::Invalid)));
}

TEST_CASE("without navigation the nearest building of a type wins, ties go to the lower id") {
	CityModel city;
	const BuildingId home = add_building(city, "house", { { 0, 0, 0 } });
	const BuildingId left = add_building(city, "school", { { -5, 0, 0 } });
	add_building(city, "school", { { 5, 0, 0 } });
	const StraightLinePaths paths(city);
	CHECK(paths.nearest_building(city.types.find("school"), home) == left);
	CHECK(paths.nearest_building(city.types.find("house"), home) == home);
	CHECK(paths.nearest_building(city.types.find("castle"), home) == BuildingId::Invalid);
	city.remove_building(left);
	CHECK(paths.nearest_building(city.types.find("school"), home) == BuildingId(2));
}

TEST_CASE("without navigation a zone is entered at its nearest point") {
	CityModel city;
	Zone park;
	park.type = city.types.add("park");
	park.polygon = { { 10, 0, 5 }, { 20, 0, 5 }, { 20, 0, -5 }, { 10, 0, -5 } };
	const ZoneId id = city.add_zone(park);
	const StraightLinePaths paths(city);
	glm::vec3 entry{ 0.0f };
	CHECK(paths.nearest_zone(park.type, { 0, 0, 2 }, entry) == id);
	CHECK(entry == glm::vec3(10, 0, 2));
	CHECK(paths.nearest_zone(TypeId::Invalid, { 0, 0, 2 }, entry) == ZoneId::Invalid);
}
