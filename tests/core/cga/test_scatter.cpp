#include <doctest/doctest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "core/cga/scatter.h"

using namespace pcg;
using namespace pcg::cga;

namespace {

// An L of 20 x 10 and 10 x 10, flat.
const Geometry *flat_l(Arena &arena) {
	GeometryBuilder builder;
	for (const glm::dvec2 p : { glm::dvec2(0, 0), { 0, 20 }, { 10, 20 }, { 10, 10 }, { 20, 10 }, { 20, 0 } }) {
		builder.add_point({ p.x, 0.0, p.y });
	}
	builder.end_loop();
	builder.end_face();
	return builder.finish(arena, false);
}

bool is_in_l(glm::dvec3 p) { return p.x >= 0 && p.z >= 0 && p.x <= 20 && p.z <= 20 && (p.x <= 10 || p.z <= 10); }

} // namespace

TEST_CASE("places on a surface lie on it, as many in each part as its area says") {
	Arena arena;
	const Scatter scatter(*flat_l(arena));
	Random random(5);
	int in_arm = 0;
	for (int i = 0; i < 3000; ++i) {
		const ScatterPoint place = scatter.on_surface(random);
		CHECK(is_in_l(place.position));
		CHECK(std::abs(place.normal.y) == doctest::Approx(1.0));
		in_arm += place.position.x > 10.0 ? 1 : 0;
	}
	CHECK(in_arm > 900); // a third; the deviation is 26
	CHECK(in_arm < 1100);
}

TEST_CASE("a bell over a surface keeps its middle and width where there is room, and the surface where there is none") {
	Arena arena;
	const Scatter scatter(*flat_l(arena));
	Random random(6);
	glm::dvec3 sum(0.0), squares(0.0);
	for (int i = 0; i < 2000; ++i) {
		const glm::dvec3 p = scatter.on_surface(random, { { 5, 0, 5 }, { 1, 1, 1 } }).position;
		sum += p;
		squares += (p - glm::dvec3(5, 0, 5)) * (p - glm::dvec3(5, 0, 5));
		CHECK(is_in_l(scatter.on_surface(random, { { 12, 0, 12 }, { 3, 0, 3 } }).position)); // around the inner corner
	}
	CHECK(sum.x / 2000 == doctest::Approx(5.0).epsilon(0.02));
	CHECK(std::sqrt(squares.z / 2000) == doctest::Approx(1.0).epsilon(0.06));
}

TEST_CASE("places in a box stay in it, negative sizes too") {
	Random random(7);
	for (int i = 0; i < 500; ++i) {
		const glm::dvec3 p = Scatter::in_box(random, { 2, -3, 0 }, { { 2, -1.5, 0 }, { 5, 5, 0 } });
		CHECK((p.x >= 0 && p.x <= 2 && p.y <= 0 && p.y >= -3 && p.z == 0));
		const glm::dvec3 q = Scatter::in_box(random, { 2, -3, 0 });
		CHECK((q.x >= 0 && q.x <= 2 && q.y <= 0 && q.y >= -3 && q.z == 0));
	}
}
