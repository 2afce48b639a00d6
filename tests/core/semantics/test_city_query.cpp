#include <doctest/doctest.h>

#include "core/semantics/city_query.h"

using namespace pcg;

namespace {

// An L: a 4 x 4 square without its upper right 2 x 2 (x > 2 and z < -2), counter-clockwise seen from above.
Zone l_shape() {
	Zone zone;
	zone.polygon = { { 0, 0, 0 }, { 4, 0, 0 }, { 4, 0, -2 }, { 2, 0, -2 }, { 2, 0, -4 }, { 0, 0, -4 } };
	return zone;
}

} // namespace

TEST_CASE("a concave zone contains its arms and its outline but not its notch") {
	const Zone zone = l_shape();
	CHECK(contains(zone, { 1, 9, -3 }));
	CHECK(contains(zone, { 3, 0, -1 }));
	CHECK_FALSE(contains(zone, { 3, 0, -3 }));
	CHECK(contains(zone, { 4, 0, -1 }));
	CHECK(contains(zone, { 2, 0, -2 }));
	CHECK_FALSE(contains(Zone(), { 0, 0, 0 }));
}

TEST_CASE("the nearest point of a zone is the point itself inside and on the outline outside") {
	const Zone zone = l_shape();
	CHECK(nearest_point(zone, { 1, 0, -1 }) == glm::vec3(1, 0, -1));
	CHECK(nearest_point(zone, { 6, 0, -1 }) == glm::vec3(4, 0, -1));
	CHECK(nearest_point(zone, { 3, 0, -2.5f }) == glm::vec3(3, 0, -2));
	CHECK(nearest_point(Zone(), { 3, 0, 1 }) == glm::vec3(3, 0, 1));
}

TEST_CASE("area and centre of area of an L are those of its two rectangles") {
	// 4x2 centred at (2, -1) and 2x2 centred at (1, -3): (8 * (2, -1) + 4 * (1, -3)) / 12.
	CHECK(area(l_shape()) == doctest::Approx(12.0));
	const glm::vec3 centre = centroid(l_shape());
	CHECK(centre.x == doctest::Approx(20.0 / 12.0));
	CHECK(centre.z == doctest::Approx(-20.0 / 12.0));
}
