#include <doctest/doctest.h>

#include <cmath>

#include "core/io/geojson.h"

using namespace pcg;

namespace {

std::string feature(const std::string &geometry, const std::string &properties = "null") {
	return "{\"type\": \"Feature\", \"properties\": " + properties + ", \"geometry\": " + geometry + "}";
}

std::string square(double x, double y, double side) {
	const auto point = [](double px, double py) { return "[" + std::to_string(px) + ", " + std::to_string(py) + "]"; };
	return "{\"type\": \"Polygon\", \"coordinates\": [[" + point(x, y) + ", " + point(x + side, y) + ", " + point(x + side, y + side) + ", " +
			point(x, y + side) + ", " + point(x, y) + "]]}";
}

std::string collection(const std::string &features) { return "{\"type\": \"FeatureCollection\",\n\"features\": [\n" + features + "\n]}"; }

std::vector<Footprint> read(const std::string &text, MapUnits units = MapUnits::Guess) {
	Diagnostics diagnostics;
	const auto footprints = parse_geojson(text, "map.geojson", diagnostics, units);
	CHECK(to_text(diagnostics) == "");
	REQUIRE(footprints.has_value());
	return *footprints;
}

// The only error of a file.
Diagnostic refused(const std::string &text, MapUnits units = MapUnits::Guess) {
	Diagnostics diagnostics;
	CHECK_FALSE(parse_geojson(text, "map.geojson", diagnostics, units).has_value());
	REQUIRE(diagnostics.error_count() == 1);
	return diagnostics.list()[0];
}

} // namespace

TEST_CASE("footprints in metres are placed around the middle of the map") {
	const auto footprints = read(collection(feature(square(1000, 2000, 10)) + ",\n" + feature(square(1090, 2000, 10))));
	REQUIRE(footprints.size() == 2);
	CHECK(footprints[0].outline == Loop2{ { -50, -5 }, { -40, -5 }, { -40, 5 }, { -50, 5 } });
	CHECK(footprints[1].name == "feature 1");
}

TEST_CASE("degrees become metres: 110,574 a degree of latitude and 111,320 of longitude at the equator, half as many at 60 degrees") {
	const auto equator = read(feature(square(-0.0005, -0.0005, 0.001)));
	CHECK(equator[0].outline[1].x - equator[0].outline[0].x == doctest::Approx(111.320).epsilon(1e-4));
	CHECK(equator[0].outline[2].y - equator[0].outline[1].y == doctest::Approx(110.574).epsilon(1e-4));
	const auto north = read(feature(square(9.9995, 59.9995, 0.001)));
	CHECK(north[0].outline[1].x - north[0].outline[0].x == doctest::Approx(55.800).epsilon(1e-4)); // published: 55.80 km
	CHECK(north[0].outline[2].y - north[0].outline[1].y == doctest::Approx(111.412).epsilon(1e-4)); // published: 111.41 km
}

TEST_CASE("small numbers are metres where an outline is as wide as no building is in degrees") {
	const auto yard = read(collection(feature(square(0, 0, 20)) + ",\n" + feature(square(60, 40, 1.5))));
	CHECK(yard[0].outline == Loop2{ { -30.75, -20.75 }, { -10.75, -20.75 }, { -10.75, -0.75 }, { -30.75, -0.75 } });
	const auto street = read(collection(feature(square(9.9, 50, 0.0002)) + ",\n" + feature(square(10.1, 50, 0.0002)))); // at 50 degrees north
	CHECK(street[1].outline[0].x - street[0].outline[0].x == doctest::Approx(0.2 * 71'695.0).epsilon(1e-3)); // published: 71.70 km a degree
	CHECK(read(feature(square(0, 0, 0.5)), MapUnits::Metres)[0].outline[0].x == -0.25);
}

TEST_CASE("features that lie nowhere are left out with a warning") {
	Diagnostics diagnostics;
	const auto footprints = parse_geojson(collection(feature("null") + ",\n" + feature(square(0, 0, 200))), "map.geojson", diagnostics);
	REQUIRE(footprints.has_value());
	CHECK(footprints->size() == 1);
	REQUIRE(diagnostics.list().size() == 1);
	CHECK(diagnostics.list()[0].message.find("1 features are neither Polygon nor MultiPolygon") != std::string::npos);
}

TEST_CASE("heights are metres, texts or levels, and a use is a type") {
	const auto of = [](const char *properties) { return read(feature(square(1000, 0, 10), properties))[0]; };
	CHECK(of(R"({"height": 12.5})").height == 12.5f);
	CHECK(of(R"({"height": "8 m"})").height == 8.0f);
	CHECK(of(R"({"building:levels": "4"})").height == 12.0f);
	CHECK(of("null").height == 0.0f);
	CHECK(of(R"({"building": "school"})").type == "school");
	CHECK(of(R"({"building": "yes"})").type == "");
	CHECK(of(R"({"building": "yes", "use": "shop"})").type == "shop");
}

TEST_CASE("each part of a MultiPolygon is a footprint, clockwise ones are turned and have their holes, lines are left out with a warning") {
	Diagnostics diagnostics;
	const auto footprints = parse_geojson(collection(
			feature("{\"type\": \"MultiPolygon\", \"coordinates\": [[[[0, 0], [0, 900], [900, 900], [0, 0]]], [[[1e3, 0], [2e3, 0], [2e3, 1e3], [1e3, 0]],"
					" [[1.5e3, 10], [1.5e3, 20], [1.6e3, 20], [1.5e3, 10]]]]}") +
			"," + feature("{\"type\": \"LineString\", \"coordinates\": [[0, 0], [1, 1]]}")), "map.geojson", diagnostics);
	REQUIRE(footprints.has_value());
	REQUIRE(footprints->size() == 2);
	CHECK((*footprints)[0].outline == Loop2{ { -100, 400 }, { -1000, 400 }, { -1000, -500 } });
	CHECK((*footprints)[0].holes.empty());
	REQUIRE((*footprints)[1].holes.size() == 1);
	CHECK((*footprints)[1].holes[0] == Loop2{ { 600, -480 }, { 500, -480 }, { 500, -490 } }); // turned
	REQUIRE(diagnostics.warning_count() == 1);
	CHECK(diagnostics.list()[0].message.find("1 features are neither") != std::string::npos);
}

TEST_CASE("holes in degrees become metres around the same middle, and rings of holes are checked as others are") {
	Diagnostics diagnostics;
	const auto footprints = parse_geojson(collection(feature(
			"{\"type\": \"Polygon\", \"coordinates\": [[[-0.001, -0.001], [0.001, -0.001], [0.001, 0.001], [-0.001, 0.001], [-0.001, -0.001]],"
			" [[0, 0], [0, 0.0005], [0.0005, 0.0005], [0, 0]]]}")), "map.geojson", diagnostics);
	REQUIRE(footprints.has_value());
	REQUIRE((*footprints)[0].holes.size() == 1);
	const Loop2 &hole = (*footprints)[0].holes[0];
	CHECK(hole[0].x == doctest::Approx(55.66).epsilon(1e-3)); // half of a thousandth of a degree at the equator
	CHECK(hole[0].y == doctest::Approx(55.29).epsilon(1e-3));
	CHECK(diagnostics.is_empty());
	const Diagnostic open = refused(collection(feature("{\"type\": \"Polygon\", \"coordinates\": [[[0, 0], [900, 0], [900, 900], [0, 0]], [[10, 10], [20, 20]]]}")));
	CHECK(open.message.find("features[0].geometry.coordinates[1]") != std::string::npos);
}

TEST_CASE("malformed files are refused with the place and the number of the feature") {
	const Diagnostic unclosed = refused(collection(feature(square(0, 0, 200)) + ",\n" +
			feature("{\"type\": \"Polygon\", \"coordinates\": [[[0, 0], [200, 0], [200, 200]]]}")));
	CHECK(unclosed.message.find("features[1].geometry.coordinates[0]") != std::string::npos);
	CHECK(unclosed.line == 4);
	CHECK(refused("{\"type\": \"FeatureCollection\", \"features\": [").message.find("not JSON") != std::string::npos);
	CHECK(refused("[]").message.find("expected an object") != std::string::npos);
	CHECK(refused("{\"type\": \"Topology\"}").message.find("not a `Topology`") != std::string::npos);
	CHECK(refused(collection("")).message.find("no Polygon") != std::string::npos);
	CHECK(refused(collection("7")).message.find("features[0]") != std::string::npos);
	CHECK(refused(feature("{\"type\": \"Polygon\", \"coordinates\": []}")).message.find("at least one ring") != std::string::npos);
	CHECK(refused(feature("{\"type\": \"Polygon\", \"coordinates\": [[[0], [1], [2], [0]]]}")).message.find("two numbers") != std::string::npos);
	CHECK(refused(feature("{\"type\": \"Polygon\", \"coordinates\": [[[0, 1e9], [1, 1], [2, 2], [0, 1e9]]]}")).message.find("from -1") !=
			std::string::npos);
	CHECK(refused(feature(square(1000, 0, 10)), MapUnits::Degrees).message.find("longitude") != std::string::npos);
}

TEST_CASE("a number that is too large for any is refused where it begins") {
	const Diagnostic huge = refused(collection(feature(square(0, 0, 200)) + ",\n" +
			feature("{\"type\": \"Polygon\", \"coordinates\": [[[0, 0], [200,\n -1e999], [200, 200], [0, 0]]]}")));
	CHECK(huge.message == "the number -1e999 is too large: no more than 1.7e308 can be kept");
	CHECK(huge.line == 5);
	CHECK(huge.column == 2);
	CHECK(huge.source == " -1e999], [200, 200], [0, 0]]]}}");
	const Diagnostic long_one = refused(feature(square(0, 0, 200), "{\"height\": " + std::string(400, '9') + "}"));
	CHECK(long_one.message.find("the number " + std::string(40, '9') + ".. is too large") == 0);
	CHECK(long_one.column == 46);
}

TEST_CASE("a height that is none is ignored with a warning") {
	Diagnostics diagnostics;
	const auto footprints = parse_geojson(feature(square(1000, 0, 10), R"({"height": "tall"})"), "map.geojson", diagnostics);
	REQUIRE(footprints.has_value());
	CHECK((*footprints)[0].height == 0.0f);
	CHECK(diagnostics.warning_count() == 1);
}
