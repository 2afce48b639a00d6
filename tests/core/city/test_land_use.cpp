#include <doctest/doctest.h>

#include <algorithm>

#include "core/city/land_use.h"

using namespace pcg;

namespace {

size_t count(const std::vector<std::string> &types, const std::string &type) {
	return size_t(std::count(types.begin(), types.end(), type));
}

} // namespace

TEST_CASE("shares are met to the nearest whole lot") {
	Diagnostics diagnostics;
	const std::vector<glm::vec2> positions(100, glm::vec2(0.5f));
	const auto types = assign_land_use(positions, { { "house", 7.0 }, { "shop", 2.0 }, { "park", 1.0 } }, {}, 1, diagnostics);
	CHECK(count(types, "house") == 70);
	CHECK(count(types, "shop") == 20);
	CHECK(count(types, "park") == 10);
	CHECK(diagnostics.is_empty());
}

TEST_CASE("a rare type gets one lot where there are enough, a type without weight gets none") {
	Diagnostics diagnostics;
	const std::vector<glm::vec2> positions(10, glm::vec2(0.5f));
	const auto types = assign_land_use(positions, { { "house", 1000.0 }, { "school", 1.0 }, { "castle", 0.0 } }, {}, 1, diagnostics);
	CHECK(count(types, "house") == 9);
	CHECK(count(types, "school") == 1);
	CHECK(diagnostics.is_empty());
}

TEST_CASE("fewer lots than types is a warning for each that is missing") {
	Diagnostics diagnostics;
	const std::vector<glm::vec2> positions(2, glm::vec2(0.5f));
	const auto types = assign_land_use(positions, { { "house", 3.0 }, { "school", 2.0 }, { "shop", 1.0 } }, {}, 1, diagnostics);
	CHECK(count(types, "house") == 1);
	CHECK(count(types, "school") == 1);
	REQUIRE(diagnostics.warning_count() == 1);
	CHECK(diagnostics.list()[0].message.find("`shop`") != std::string::npos);
}

TEST_CASE("districts decide for the lots that they contain") {
	Diagnostics diagnostics;
	std::vector<glm::vec2> positions;
	for (int i = 0; i < 400; ++i) {
		positions.push_back({ float(i % 20) / 20.0f + 0.025f, float(i / 20) / 20.0f + 0.025f });
	}
	const auto types = assign_land_use(positions, default_land_use(), quadrant_districts(), 1, diagnostics);
	bool is_good = true;
	for (size_t i = 0; i < types.size(); ++i) {
		const bool is_west = positions[i].x < 0.5f, is_north = positions[i].y < 0.5f;
		const std::string expected = is_north ? (is_west ? "house" : "shop") : (is_west ? "school" : "workplace");
		is_good = is_good && (types[i] == expected || types[i] == "park");
	}
	CHECK(is_good);
	// 100 lots each: 5 % or 10 % parks.
	CHECK(count(types, "house") == 95);
	CHECK(count(types, "shop") == 90);
	CHECK(count(types, "park") == 30);
}

TEST_CASE("another seed deals the same shares differently") {
	Diagnostics diagnostics;
	const std::vector<glm::vec2> positions(100, glm::vec2(0.5f));
	const auto a = assign_land_use(positions, default_land_use(), {}, 1, diagnostics);
	const auto b = assign_land_use(positions, default_land_use(), {}, 2, diagnostics);
	CHECK(a != b);
	CHECK(count(a, "house") == count(b, "house"));
	CHECK(a == assign_land_use(positions, default_land_use(), {}, 1, diagnostics));
}

namespace {

// 20 by 20 places over the city.
std::vector<glm::vec2> places() {
	std::vector<glm::vec2> positions;
	for (int i = 0; i < 400; ++i) {
		positions.push_back({ float(i % 20) / 20.0f + 0.025f, float(i / 20) / 20.0f + 0.025f });
	}
	return positions;
}

std::shared_ptr<const WeightMap> painted(uint32_t width, uint32_t height, std::vector<float> values) {
	return std::make_shared<const WeightMap>(WeightMap{ width, height, std::move(values) });
}

} // namespace

TEST_CASE("a map is read between the middles of its pixels") {
	const WeightMap map{ 2, 2, { 0.0f, 1.0f, 0.5f, 0.5f } };
	CHECK(map.at({ 0.25f, 0.25f }) == doctest::Approx(0.0));
	CHECK(map.at({ 0.75f, 0.25f }) == doctest::Approx(1.0));
	CHECK(map.at({ 0.5f, 0.25f }) == doctest::Approx(0.5));
	CHECK(map.at({ 0.75f, 0.5f }) == doctest::Approx(0.75));
	CHECK(map.at({ 0.0f, 0.0f }) == doctest::Approx(0.0));
	CHECK(map.at({ 1.0f, 1.0f }) == doctest::Approx(0.5));
}

TEST_CASE("painted types stand where their maps are bright, as many as these add up to, for every seed") {
	const std::vector<glm::vec2> positions = places();
	// Workplaces: four pixels from black in the west to white in the east. Schools: the north alone.
	const auto east = painted(4, 1, { 0.0f, 0.0f, 1.0f, 1.0f }), north = painted(1, 4, { 1.0f, 1.0f, 0.0f, 0.0f });
	const std::vector<LandUse> uses{ { "house", 0.6 }, { "workplace", 0.6, east }, { "school", 0.02, north } };
	double workplaces = 0.0, schools = 0.0;
	for (const glm::vec2 place : positions) {
		const double work = 0.6 * double(east->at(place)), school = 0.02 * double(north->at(place)), sum = 0.6 + work + school;
		workplaces += work / sum;
		schools += school / sum;
	}
	for (uint64_t seed = 1; seed <= 1000; ++seed) {
		Diagnostics diagnostics;
		const std::vector<std::string> types = assign_land_use(positions, uses, {}, seed, diagnostics);
		REQUIRE(types.size() == positions.size());
		CHECK(diagnostics.is_empty());
		bool is_good = true;
		for (size_t i = 0; i < types.size(); ++i) {
			is_good = is_good && (types[i] != "workplace" || east->at(positions[i]) > 0.0f) && (types[i] != "school" || north->at(positions[i]) > 0.0f);
		}
		CHECK(is_good);
		CHECK(std::abs(double(count(types, "workplace")) - workplaces) <= 3.0);
		CHECK(std::abs(double(count(types, "school")) - schools) <= 3.0);
	}
}

TEST_CASE("painted types that are rare get a lot, and black maps are told") {
	const auto black = painted(1, 1, { 0.0f }), west = painted(2, 1, { 1.0f, 0.0f });
	Diagnostics rare, dark, nothing;
	CHECK(count(assign_land_use(places(), { { "house", 1.0 }, { "town_hall", 0.0001, west } }, {}, 1, rare), "town_hall") == 1);
	CHECK(rare.is_empty());
	assign_land_use(places(), { { "house", 1.0 }, { "shop", 1.0, black } }, {}, 1, dark);
	REQUIRE(dark.list().size() == 1);
	CHECK(dark.list()[0].message.find("`shop` where its map is not black") != std::string::npos);
	const auto types = assign_land_use(places(), { { "house", 1.0, black }, { "shop", 1.0, black } }, {}, 1, nothing);
	CHECK(count(types, "house") == 200);
	REQUIRE(nothing.list().size() == 1);
	CHECK(nothing.list()[0].message.find("on 400 lots the maps of all types are black") == 0);
}
