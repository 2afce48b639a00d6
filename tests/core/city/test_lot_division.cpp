#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/city/lot_division.h"
#include "core/geometry/polygon.h"

using namespace pcg;

namespace {

Parcel rectangle(double width, double depth, std::vector<float> streets) {
	return { { { 0, 0 }, { width, 0 }, { width, depth }, { 0, depth } }, std::move(streets) };
}

double area(const std::vector<Parcel> &parcels) {
	double sum = 0.0;
	for (const Parcel &parcel : parcels) {
		sum += signed_area(parcel.outline) / 2.0;
	}
	return sum;
}

bool have_fronts(const std::vector<Parcel> &parcels) {
	return std::all_of(parcels.begin(), parcels.end(), [](const Parcel &parcel) { return parcel.street_widths[0] > 0.0f; });
}

} // namespace

TEST_CASE("land of two by five lots is divided into ten of the wanted size") {
	const std::vector<Parcel> lots = divide_land(rectangle(100, 40, { 8, 8, 8, 8 }), { 20, 20, 0 }, Random(1));
	REQUIRE(lots.size() == 10);
	CHECK(have_fronts(lots));
	for (const Parcel &lot : lots) {
		CHECK(signed_area(lot.outline) / 2.0 == doctest::Approx(400.0));
		CHECK(glm::distance(lot.outline[0], lot.outline[1]) == doctest::Approx(20.0));
	}
}

TEST_CASE("land with one street is never divided so that a part has none") {
	const std::vector<Parcel> lots = divide_land(rectangle(100, 40, { 8, 0, 0, 0 }), { 20, 20, 0 }, Random(1));
	REQUIRE(lots.size() == 5); // as deep as the land
	CHECK(have_fronts(lots));
	CHECK(area(lots) == doctest::Approx(4000.0));
}

TEST_CASE("the front is the longest edge on a street, and each edge keeps its street's width") {
	const std::vector<Parcel> lots = divide_land(rectangle(20, 25, { 5, 9, 0, 0 }), { 20, 25, 0 }, Random(1));
	REQUIRE(lots.size() == 1);
	CHECK(lots[0].outline == Loop2{ { 20, 0 }, { 20, 25 }, { 0, 25 }, { 0, 0 } });
	CHECK(lots[0].street_widths == std::vector<float>{ 9, 0, 0, 5 });
}

TEST_CASE("land too small for a lot, or without a street, gives none") {
	CHECK(divide_land(rectangle(8, 8, { 5, 5, 5, 5 }), { 20, 20, 0 }, Random(1)).empty());
	CHECK(divide_land(rectangle(100, 5, { 5, 5, 5, 5 }), { 20, 20, 0 }, Random(1)).empty());
	CHECK(divide_land(rectangle(20, 20, { 0, 0, 0, 0 }), { 20, 20, 0 }, Random(1)).empty());
}

TEST_CASE("land with an inner corner is cut there, and the lots are convex") {
	// An L of 100 x 100 less 60 x 60 at its north-east.
	const Parcel land{ { { 0, 0 }, { 100, 0 }, { 100, 40 }, { 40, 40 }, { 40, 100 }, { 0, 100 } }, { 8, 8, 8, 8, 8, 8 } };
	const std::vector<Parcel> lots = divide_land(land, { 20, 20, 0.1 }, Random(3));
	CHECK(lots.size() >= 12);
	CHECK(have_fronts(lots));
	CHECK(area(lots) == doctest::Approx(6400.0));
	CHECK(std::all_of(lots.begin(), lots.end(), [](const Parcel &lot) { return is_convex(lot.outline); }));
}

TEST_CASE("rows of four-cornered land have exactly so many lots, the second looking the other way") {
	const Parcel land{ { { 0, 0 }, { 60, 0 }, { 50, 40 }, { 10, 40 } }, { 1, 2, 3, 4 } };
	const std::vector<Parcel> lots = divide_rows(land, 2, 2);
	REQUIRE(lots.size() == 4);
	CHECK(lots[0].outline == Loop2{ { 0, 0 }, { 30, 0 }, { 30, 20 }, { 5, 20 } });
	CHECK(lots[0].street_widths == std::vector<float>{ 1, 0, 0, 4 });
	CHECK(lots[3].outline == Loop2{ { 50, 40 }, { 30, 40 }, { 30, 20 }, { 55, 20 } });
	CHECK(lots[3].street_widths == std::vector<float>{ 3, 0, 0, 2 });
	const std::vector<Parcel> single = divide_rows(land, 1, 1);
	REQUIRE(single.size() == 1);
	CHECK(single[0].street_widths == std::vector<float>{ 1, 2, 3, 4 });
}
