#include "core/cga/clip.h"

#include <doctest/doctest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "core/base/random.h"
#include "core/cga/edges.h"
#include "core/cga/primitives.h"
#include "core/geometry/polygon.h"
#include "core/geometry/roof.h"
#include "tests/core/geometry/random_outlines.h"

using namespace pcg;
using namespace pcg::cga;

namespace {

const Geometry *polygon(const std::vector<std::vector<glm::dvec3>> &loops, Arena &arena) {
	GeometryBuilder builder;
	for (const auto &loop : loops) {
		builder.add_loop(loop);
	}
	builder.end_face();
	return builder.finish(arena, false);
}

double area_of(const Geometry &geometry) {
	double sum = 0.0;
	for (uint32_t f = 0; f < geometry.face_count; ++f) {
		const GeometryFace &face = geometry.faces[f];
		glm::dvec3 vector(0.0);
		for (uint32_t i = 0; i < face.loop_count; ++i) {
			vector += area_vector(geometry.loop(face.first_loop + i));
		}
		sum += 0.5 * glm::length(vector);
	}
	return sum;
}

double volume_of(const Geometry &geometry) {
	double sum = 0.0;
	for (uint32_t i = 0; i < geometry.loop_count; ++i) {
		sum += glm::dot(geometry.loop(i)[0], area_vector(geometry.loop(i))) / 6.0;
	}
	return sum;
}

} // namespace

TEST_CASE("a cut keeps the first edge, and takes its place where it is cut away") {
	Arena arena;
	Clipper clipper;
	const Geometry *square = polygon({ { { 0, 0, 0 }, { 4, 0, 0 }, { 4, 4, 0 }, { 0, 4, 0 } } }, arena);
	const Geometry *right = clipper.clip(*square, { { 1, 0, 0 }, 1.0 }, arena);
	REQUIRE(right != nullptr);
	CHECK(right->loop(0)[0] == glm::dvec3(1, 0, 0));
	CHECK(right->loop(0)[1] == glm::dvec3(4, 0, 0));
	const Geometry *upper = clipper.clip(*square, { { 0, 1, 0 }, 1.0 }, arena);
	REQUIRE(upper != nullptr);
	CHECK(upper->loop(0)[0] == glm::dvec3(0, 1, 0));
	CHECK(upper->loop(0)[1] == glm::dvec3(4, 1, 0));
}

TEST_CASE("what lies on one side stays or goes as a whole") {
	Arena arena;
	Clipper clipper;
	const Geometry *square = polygon({ { { 0, 0, 0 }, { 4, 0, 0 }, { 4, 4, 0 }, { 0, 4, 0 } } }, arena);
	CHECK(clipper.clip(*square, { { 1, 0, 0 }, 0.0 }, arena) == square);
	CHECK(clipper.clip(*square, { { 1, 0, 0 }, 4.0 }, arena) == nullptr);
}

TEST_CASE("a comb falls into its teeth") {
	Arena arena;
	Clipper clipper;
	const Geometry *comb = polygon({ { { 0, 0, 0 }, { 50, 0, 0 }, { 50, 10, 0 }, { 40, 10, 0 }, { 40, 2, 0 }, { 30, 2, 0 }, { 30, 10, 0 }, { 20, 10, 0 },
									{ 20, 2, 0 }, { 10, 2, 0 }, { 10, 10, 0 }, { 0, 10, 0 } } },
			arena);
	const Geometry *teeth = clipper.clip(*comb, { { 0, 1, 0 }, 5.0 }, arena);
	REQUIRE(teeth != nullptr);
	CHECK(teeth->face_count == 3);
	CHECK(area_of(*teeth) == doctest::Approx(150.0));
	const Geometry *spine = clipper.clip(*comb, { { 0, -1, 0 }, -2.0 }, arena); // exactly at the foot of the teeth
	REQUIRE(spine != nullptr);
	CHECK(area_of(*spine) == doctest::Approx(100.0));
}

TEST_CASE("a hole is cut open, or stays a hole in the piece around it") {
	Arena arena;
	Clipper clipper;
	const Geometry *ring = polygon({ { { 0, 0, 0 }, { 10, 0, 0 }, { 10, 10, 0 }, { 0, 10, 0 } }, { { 3, 3, 0 }, { 3, 7, 0 }, { 7, 7, 0 }, { 7, 3, 0 } } }, arena);
	const Geometry *half = clipper.clip(*ring, { { 1, 0, 0 }, 5.0 }, arena);
	REQUIRE(half != nullptr);
	CHECK(half->loop_count == 1);
	CHECK(area_of(*half) == doctest::Approx(42.0));
	const Geometry *most = clipper.clip(*ring, { { 1, 0, 0 }, 2.0 }, arena);
	REQUIRE(most != nullptr);
	CHECK(most->face_count == 1);
	CHECK(most->loop_count == 2);
	CHECK(area_of(*most) == doctest::Approx(64.0));
	const Geometry *sides = clipper.clip(*ring, { { 1, 0, 0 }, 3.0 }, arena); // along the hole's edge
	REQUIRE(sides != nullptr);
	CHECK(area_of(*sides) == doctest::Approx(54.0));
}

TEST_CASE("closed surfaces stay closed: the two sides of any cut add up to the whole") {
	Random random(3);
	Clipper clipper;
	for (int round = 0; round < 300; ++round) {
		Arena arena;
		const Geometry *bodies[] = { make_primitive(PrimitiveKind::Cube, 0, 0, arena), make_primitive(PrimitiveKind::Cylinder, 7, 0, arena),
			make_primitive(PrimitiveKind::Cone, 5, 0, arena), make_primitive(PrimitiveKind::Sphere, 8, 6, arena) };
		const Geometry *body = bodies[round % 4];
		const glm::dvec3 normal = glm::normalize(glm::dvec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)));
		const double height = random.uniform(0.2, 0.8), reach = 0.28 * (1.0 - height); // a place that lies in all of them
		const double offset = glm::dot(normal, glm::dvec3(random.uniform(0.5 - reach, 0.5 + reach), height, random.uniform(0.5 - reach, 0.5 + reach)));
		const Geometry *a = clipper.clip(*body, { normal, offset }, arena);
		const Geometry *b = clipper.clip(*body, { -normal, -offset }, arena);
		REQUIRE(a != nullptr);
		REQUIRE(b != nullptr);
		CHECK(a->is_closed);
		CHECK(b->is_closed);
		CHECK(volume_of(*a) + volume_of(*b) == doctest::Approx(volume_of(*body)));
	}
}

TEST_CASE("a stepped body cut at its step has the tower's own foot as cap") {
	Arena arena;
	Clipper clipper;
	GeometryBuilder builder; // an L in the x-y plane, 2 m deep: block 10 x 3, tower 4 wide up to 8
	const std::vector<glm::dvec3> front = { { 0, 0, 2 }, { 10, 0, 2 }, { 10, 3, 2 }, { 4, 3, 2 }, { 4, 8, 2 }, { 0, 8, 2 } };
	builder.add_loop(front);
	builder.end_face();
	std::vector<glm::dvec3> back;
	for (size_t i = 0; i < front.size(); ++i) {
		back.push_back(front[front.size() - 1 - i] - glm::dvec3(0, 0, 2));
		const glm::dvec3 a = front[i], b = front[(i + 1) % front.size()], depth(0, 0, 2);
		builder.add_quad(b, a, a - depth, b - depth);
	}
	builder.add_loop(back);
	builder.end_face();
	const Geometry *body = builder.finish(arena, true);
	CHECK(volume_of(*body) == doctest::Approx(2.0 * (30.0 + 20.0)));
	const Geometry *tower = clipper.clip(*body, { { 0, 1, 0 }, 3.0 }, arena);
	REQUIRE(tower != nullptr);
	CHECK(tower->face_count == 6);
	CHECK(volume_of(*tower) == doctest::Approx(40.0));
	const Geometry *block = clipper.clip(*body, { { 0, -1, 0 }, -3.0 }, arena);
	REQUIRE(block != nullptr);
	CHECK(volume_of(*block) == doctest::Approx(60.0));
}

TEST_CASE("level and upright cuts of roofs over whole metres, many of them along ridges and eaves, leave bodies whose faces share all edges") {
	Clipper clipper;
	for (uint64_t seed = 0; seed < 200; ++seed) {
		Arena arena;
		Random random(seed, 31);
		const RoofOutline outline = { random.chance(0.5) ? random_stairs(random) : random_comb(random) };
		GeometryBuilder builder;
		for (const RoofFace &face : (seed % 4 == 0 ? roof_gable(outline, { 45.0 }) : roof_hip(outline, { 45.0 })).faces) {
			builder.add_loop(face.outline);
			builder.end_face();
		}
		const Geometry *roof = builder.finish(arena, true);
		CAPTURE(seed);
		REQUIRE(has_paired_edges(*roof));
		for (const glm::dvec3 normal : { glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 1.0, 0.0) }) {
			for (const double offset : { 0.5, 1.0, 1.5, 2.0, 3.0, 5.0 }) {
				CAPTURE(offset);
				double volume = 0.0;
				for (const double side : { -1.0, 1.0 }) {
					const Geometry *part = clipper.clip(*roof, { side * normal, side * offset }, arena);
					CHECK((part == nullptr || has_paired_edges(*part)));
					volume += part != nullptr ? volume_of(*part) : 0.0;
				}
				CHECK(volume == doctest::Approx(volume_of(*roof)));
			}
		}
	}
}

// The floor of the part shares one half of the cut with the roof above the eave, the other one with the cap. What stands on a wall is cut as the wall is.
TEST_CASE("cut along the eave of a wing the floor of a roof has a corner where the eave ends, the floor of walls has none") {
	Clipper clipper;
	Arena arena;
	GeometryBuilder builder;
	const RoofOutline outline = { { { 0.0, 0.0 }, { 10.0, 0.0 }, { 10.0, 4.0 }, { 4.0, 4.0 }, { 4.0, 10.0 }, { 0.0, 10.0 } } };
	for (const RoofFace &face : roof_hip(outline, { 45.0 }).faces) {
		builder.add_loop(face.outline);
		builder.end_face();
	}
	const Geometry *roof = clipper.clip(*builder.finish(arena, true), { { -1.0, 0.0, 0.0 }, -4.0 }, arena);
	REQUIRE(roof != nullptr);
	const auto floor_of = [](const Geometry &body) {
		size_t corners = 0;
		for (uint32_t f = 0; f < body.face_count; ++f) {
			corners = face_normal(body, body.faces[f]).z < -0.9 ? body.outline(body.faces[f]).size() : corners;
		}
		return corners;
	};
	CHECK(floor_of(*roof) == 5);
	std::vector<glm::dvec3> low, high;
	for (const glm::dvec2 &point : outline[0]) {
		low.insert(low.begin(), { point, 0.0 });
		high.push_back({ point, 3.0 });
	}
	builder.clear();
	builder.add_loop(low);
	builder.end_face();
	builder.add_loop(high);
	builder.end_face();
	for (size_t i = 0; i < high.size(); ++i) {
		const glm::dvec3 a = high[i], b = high[(i + 1) % high.size()], down(0.0, 0.0, 3.0);
		builder.add_quad(a - down, b - down, b, a);
	}
	const Geometry *walls = clipper.clip(*builder.finish(arena, true), { { -1.0, 0.0, 0.0 }, -4.0 }, arena);
	REQUIRE(walls != nullptr);
	CHECK(floor_of(*walls) == 4);
	CHECK(walls->face_count == 6);
}
