#include "core/geometry/convex_body.h"

#include <doctest/doctest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "core/base/random.h"

using namespace pcg;

namespace {

void add_polygon(Solid &solid, std::vector<glm::dvec3> points) {
	const uint32_t end = uint32_t(points.size());
	solid.add_polygon(points, { &end, 1 });
}

// 4 x 3 x 2 metres from the origin; as a wedge it rises towards x = 4.
Solid body(bool is_wedge) {
	Solid solid;
	solid.is_closed = true;
	const double low = is_wedge ? 0.5 : 3.0;
	add_polygon(solid, { { 0, 0, 0 }, { 4, 0, 0 }, { 4, 0, 2 }, { 0, 0, 2 } });
	add_polygon(solid, { { 0, low, 2 }, { 4, 3, 2 }, { 4, 3, 0 }, { 0, low, 0 } });
	add_polygon(solid, { { 0, 0, 2 }, { 4, 0, 2 }, { 4, 3, 2 }, { 0, low, 2 } });
	add_polygon(solid, { { 4, 0, 0 }, { 0, 0, 0 }, { 0, low, 0 }, { 4, 3, 0 } });
	add_polygon(solid, { { 4, 0, 2 }, { 4, 0, 0 }, { 4, 3, 0 }, { 4, 3, 2 } });
	add_polygon(solid, { { 0, 0, 0 }, { 0, 0, 2 }, { 0, low, 2 }, { 0, low, 0 } });
	return solid;
}

// Upright or lying rectangles on a grid of half metres, so that many lie in the body's sides; every third is turned in its plane.
std::vector<glm::dvec3> random_rectangle(uint64_t seed) {
	Random random(seed, 109);
	const auto on_grid = [&](double most) { return 0.5 * double(random.index(uint64_t(2.0 * most) + 1)); };
	const size_t across = random.index(3);
	glm::dvec3 x(0.0), y(0.0);
	x[int(across + 1) % 3] = y[int(across + 2) % 3] = 1.0;
	const double angle = seed % 3 == 0 ? random.uniform(0.0, 1.5) : 0.0;
	const glm::dvec3 along = (x * std::cos(angle) + y * std::sin(angle)) * (0.5 + on_grid(2.0));
	const glm::dvec3 up = (y * std::cos(angle) - x * std::sin(angle)) * (0.5 + on_grid(2.0));
	const glm::dvec3 from(on_grid(6.0) - 1.0, on_grid(5.0) - 1.0, on_grid(4.0) - 1.0);
	return { from, from + along, from + along + up, from + up };
}

} // namespace

TEST_CASE("a convex body tells of rectangles what cutting them tells") {
	int told[3] = {};
	for (const bool is_wedge : { false, true }) {
		const Solid solid = body(is_wedge);
		const ConvexBody convex(solid);
		for (uint64_t seed = 0; seed < 3000; ++seed) {
			const std::vector<glm::dvec3> corners = random_rectangle(seed);
			const ConvexBody::Relation relation = convex.relation_to(corners, true);
			++told[int(relation)];
			Solid rectangle;
			add_polygon(rectangle, corners);
			const SolidRelation truth = relate(rectangle, solid);
			if (relation == ConvexBody::Relation::Apart) {
				CHECK_FALSE(truth.touches);
				CHECK_FALSE(truth.is_inside);
				CHECK(convex.relation_to(corners, false) != ConvexBody::Relation::Contact);
			} else if (relation == ConvexBody::Relation::Contact) {
				CHECK(truth.touches);
				CHECK_FALSE(truth.overlaps);
			}
		}
	}
	CHECK(told[int(ConvexBody::Relation::Apart)] > 2000);
	CHECK(told[int(ConvexBody::Relation::Contact)] > 150);
	CHECK(told[int(ConvexBody::Relation::Unknown)] > 300);
}

TEST_CASE("a body that is not convex tells nothing") {
	Solid solid = body(false);
	Solid other = body(true);
	for (SolidTriangle &triangle : other.triangles) {
		for (glm::dvec3 *corner : { &triangle.a, &triangle.b, &triangle.c }) {
			corner->x += 10.0;
		}
		solid.triangles.push_back(triangle);
	}
	CHECK(ConvexBody(solid).relation_to(std::vector<glm::dvec3>{ { 50, 50, 50 } }, false) == ConvexBody::Relation::Unknown);
	CHECK(ConvexBody(body(true)).relation_to(std::vector<glm::dvec3>{ { 50, 50, 50 } }, false) == ConvexBody::Relation::Apart);
}
