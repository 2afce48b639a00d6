#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/base/random.h"
#include "core/geometry/inverted.h"
#include "core/geometry/roof.h"

using namespace pcg;

namespace {

const RoofOutline rectangle = { { { 0, 0 }, { 10, 0 }, { 10, 4 }, { 0, 4 } } };
const RoofOutline square = { { { 0, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 } } };
const RoofOutline corner = { { { 0, 0 }, { 10, 0 }, { 10, 4 }, { 4, 4 }, { 4, 10 }, { 0, 10 } } };

glm::dvec3 vector_area(const RoofFace &face) {
	glm::dvec3 sum(0.0);
	for (size_t i = 0; i < face.outline.size(); ++i) {
		sum += glm::cross(face.outline[i], face.outline[(i + 1) % face.outline.size()]);
	}
	return sum / 2.0;
}

double height_of(const Roof &roof) {
	double top = -1e9;
	for (const RoofFace &face : roof.faces) {
		for (const glm::dvec3 &point : face.outline) {
			top = std::max(top, point.z);
		}
	}
	return top;
}

size_t count(const Roof &roof, RoofPart part) {
	return size_t(std::count_if(roof.faces.begin(), roof.faces.end(), [part](const RoofFace &face) { return face.part == part; }));
}

double area(const Roof &roof, RoofPart part) {
	double sum = 0.0;
	for (const RoofFace &face : roof.faces) {
		sum += face.part == part ? glm::length(vector_area(face)) : 0.0;
	}
	return sum;
}

// The vector areas of a closed surface sum to nothing.
void check_closed(const Roof &roof) {
	glm::dvec3 sum(0.0);
	for (const RoofFace &face : roof.faces) {
		sum += vector_area(face);
	}
	CHECK(glm::length(sum) == doctest::Approx(0.0).epsilon(1e-6));
	CHECK(roof.is_complete);
}

} // namespace

TEST_CASE("a hip roof of 45 degrees over 10 x 4 is 2 m high, closed, and its planes are the floor's area times the square root of two") {
	const Roof roof = roof_hip(rectangle, { 45.0, false });
	CHECK(count(roof, RoofPart::Plane) == 4);
	CHECK(count(roof, RoofPart::Bottom) == 1);
	CHECK(height_of(roof) == doctest::Approx(2.0));
	CHECK(area(roof, RoofPart::Plane) == doctest::Approx(40.0 * std::sqrt(2.0)));
	check_closed(roof);
}

TEST_CASE("a hip roof by height is as high as it was told") {
	CHECK(height_of(roof_hip(corner, { 3.5, true })) == doctest::Approx(3.5));
	check_closed(roof_hip(corner, { 3.5, true }));
}

TEST_CASE("an overhang is measured on the slope: its eaves drop below the floor") {
	// 1 m along a plane of 30 degrees: 0.866 m out and 0.5 m down.
	const Roof roof = roof_hip(rectangle, { 30.0, false }, 1.0);
	const glm::dvec3 eave = roof.faces[0].outline[0];
	CHECK(eave.x == doctest::Approx(-0.8660254));
	CHECK(eave.y == doctest::Approx(-0.8660254));
	CHECK(eave.z == doctest::Approx(-0.5));
	CHECK(height_of(roof) == doctest::Approx(2.0 * std::tan(30.0 * 3.14159265358979 / 180.0)));
	for (uint32_t i = 0; i < 4; ++i) {
		CHECK(roof.faces[i].edge == i);
	}
}

TEST_CASE("a gable roof over a rectangle has two planes and two upright triangles") {
	const Roof roof = roof_gable(rectangle, { 45.0, false });
	CHECK(count(roof, RoofPart::Plane) == 2);
	CHECK(count(roof, RoofPart::Gable) == 2);
	CHECK(area(roof, RoofPart::Gable) == doctest::Approx(8.0)); // 2 x 4 * 2 / 2
	CHECK(area(roof, RoofPart::Plane) == doctest::Approx(40.0 * std::sqrt(2.0)));
	CHECK(std::abs(vector_area(roof.faces[1]).z) < 1e-9); // edge 1 is a short side
	check_closed(roof);
}

TEST_CASE("the ridge of a gable roof over a square runs along its first edge") {
	const Roof roof = roof_gable(square, { 45.0, false });
	CHECK(roof.faces[0].part == RoofPart::Plane);
	CHECK(roof.faces[1].part == RoofPart::Gable);
	CHECK(area(roof, RoofPart::Plane) == doctest::Approx(16.0 * std::sqrt(2.0)));
	check_closed(roof);
}

TEST_CASE("a gable roof over an L has a gable at each wing's end and stays closed") {
	const Roof roof = roof_gable(corner, { 45.0, false });
	CHECK(count(roof, RoofPart::Gable) == 2);
	CHECK(height_of(roof) == doctest::Approx(2.0));
	check_closed(roof);
}

TEST_CASE("a gable overhang carries ridge and eaves past the wall, which stays") {
	const Roof roof = roof_gable(rectangle, { 45.0, false }, 0.0, 0.5);
	double low = 1e9, high = -1e9;
	for (const RoofFace &face : roof.faces) {
		for (const glm::dvec3 &point : face.outline) {
			low = std::min(low, point.x);
			high = std::max(high, point.x);
		}
	}
	CHECK(low == doctest::Approx(-0.5));
	CHECK(high == doctest::Approx(10.5));
	CHECK(area(roof, RoofPart::Gable) == doctest::Approx(8.0));
	CHECK(area(roof, RoofPart::Plane) == doctest::Approx(44.0 * std::sqrt(2.0)));
}

TEST_CASE("with both overhangs a gable still stands on its wall and the planes reach past it on all sides") {
	// Along the plane of 45 degrees 1.414 m: 1 m out and 1 m down; 0.5 m past the gables.
	const Roof roof = roof_gable(rectangle, { 45.0, false }, std::sqrt(2.0), 0.5);
	CHECK(area(roof, RoofPart::Gable) == doctest::Approx(8.0));
	CHECK(area(roof, RoofPart::Plane) == doctest::Approx(11.0 * 6.0 * std::sqrt(2.0)));
	for (const RoofFace &face : roof.faces) {
		if (face.part == RoofPart::Gable) {
			CHECK((std::abs(face.outline[0].x) < 1e-9 || std::abs(face.outline[0].x - 10.0) < 1e-9));
			CHECK(face.outline[0].z == doctest::Approx(0.0));
		}
	}
}

TEST_CASE("an index turns the ridge of a gable roof to that edge") {
	const Roof roof = roof_gable(rectangle, { 45.0, false }, 0.0, 0.0, false, 1); // across: 10 m wide, 5 m high
	CHECK(height_of(roof) == doctest::Approx(5.0));
	check_closed(roof);
}

TEST_CASE("a ridge roof runs along x and its walls follow a slanted outline") {
	const RoofOutline slanted = { { { 0, 0 }, { 10, 0 }, { 12, 4 }, { -1, 4 } } };
	const Roof roof = roof_ridge(slanted, { 3.0, true });
	CHECK(count(roof, RoofPart::Plane) == 2);
	CHECK(count(roof, RoofPart::Gable) == 2);
	CHECK(height_of(roof) == doctest::Approx(3.0));
	check_closed(roof);
}

TEST_CASE("a shed roof rises from its edge, with three upright sides over a rectangle") {
	const Roof roof = roof_shed(rectangle, { 45.0, false }, 0);
	CHECK(height_of(roof) == doctest::Approx(4.0));
	CHECK(count(roof, RoofPart::Plane) == 1);
	CHECK(count(roof, RoofPart::Gable) == 3);
	CHECK(area(roof, RoofPart::Gable) == doctest::Approx(40.0 + 2.0 * 8.0)); // back 10 x 4, two triangles 4 * 4 / 2
	check_closed(roof);
	CHECK(height_of(roof_shed(rectangle, { 2.5, true }, 1)) == doctest::Approx(2.5));
}

TEST_CASE("a pyramid's apex stands above the middle; an angle is that of the first edge's triangle") {
	const Roof roof = roof_pyramid(rectangle, { 45.0, false });
	CHECK(height_of(roof) == doctest::Approx(2.0));
	CHECK(count(roof, RoofPart::Plane) == 4);
	check_closed(roof);
}

TEST_CASE("an outline grows with mitred corners and remembers its edges") {
	const OutlineWithEdges grown = grow_outline(corner, 1.0);
	REQUIRE(grown.loops.size() == 1);
	REQUIRE(grown.loops[0].size() == 6);
	double twice = 0.0;
	for (size_t i = 0; i < 6; ++i) {
		const glm::dvec2 a = grown.loops[0][i], b = grown.loops[0][(i + 1) % 6];
		twice += a.x * b.y - b.x * a.y;
		const uint32_t edge = grown.edges[i];
		const glm::dvec2 p = corner[0][edge], q = corner[0][(edge + 1) % 6];
		CHECK(glm::dot(glm::normalize(b - a), glm::normalize(q - p)) == doctest::Approx(1.0));
	}
	CHECK(twice / 2.0 == doctest::Approx(12.0 * 12.0 - 6.0 * 6.0));
}

TEST_CASE("roofs hang over the outlines of stars with sharp corners") {
	size_t tried = 0;
	for (uint64_t seed = 0; seed < 2000; ++seed) {
		Random random(seed, 77);
		std::vector<double> angles(3 + random.index(8));
		std::ranges::generate(angles, [&] { return random.uniform(0.0, 6.283185307); });
		std::ranges::sort(angles);
		Loop2 star;
		for (const double angle : angles) {
			star.push_back(random.uniform(5.0, 20.0) * glm::dvec2(std::cos(angle), std::sin(angle)));
		}
		if (signed_area(star) < 10.0 || is_self_intersecting(star) || !can_grow({ star })) {
			continue;
		}
		++tried;
		CAPTURE(seed);
		const double reach = random.uniform(0.1, 1.0);
		const Roof roof = roof_hip({ star }, { 45.0 }, reach * std::sqrt(2.0));
		double plan = 0.0;
		for (const RoofFace &face : roof.faces) {
			plan += face.part == RoofPart::Plane ? vector_area(face).z : 0.0;
		}
		CHECK(roof.is_complete);
		CHECK(plan == doctest::Approx(0.5 * signed_area(grow_outline({ star }, reach).loops[0])));
		CHECK(plan > 0.5 * signed_area(star));
	}
	CHECK(tried > 500);
}

TEST_CASE("where long sides are almost parallel the ridge runs far in no time") {
	const RoofOutline outline = { { { 5.6240465293841799, -4.8650146101859972 }, { 16.9715136435292, 2.9859939679951362 },
			{ 15.314564534575984, 10.651725480003547 }, { -7.8465257508978592, -5.3706445856063905 } } };
	const Roof roof = roof_hip(outline, { 45.0 });
	CHECK(roof.is_complete);
	CHECK(count(roof, RoofPart::Plane) == 4);
	check_closed(roof);
}

TEST_CASE("an outline with a needle keeps its eaves where they are") {
	const Roof roof = roof_hip({ { { 0, 0 }, { 100, 0 }, { 100, 0.1 } } }, { 45.0 }, 0.5);
	CHECK(roof.faces[0].outline[0].z == 0.0);
}
