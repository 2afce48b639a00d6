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
