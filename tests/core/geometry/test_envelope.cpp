#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "core/base/random.h"
#include "core/geometry/envelope.h"
#include "core/geometry/polygon.h"
#include "core/geometry/setback.h"
#include "tests/core/geometry/random_outlines.h"

using namespace pcg;

namespace {

using Kind = EnvelopeFace::Kind;

glm::dvec3 vector_of(const EnvelopeFace &face) {
	glm::dvec3 sum(0.0);
	for (const auto &loop : face.loops) {
		sum += 0.5 * area_vector(loop);
	}
	return sum;
}

// Of what looks up: the plan of everything but walls and bottom.
double roof_plan(const Envelope &envelope) {
	double sum = 0.0;
	for (const EnvelopeFace &face : envelope.faces) {
		sum += face.kind == Kind::Slope || face.kind == Kind::Top ? vector_of(face).z : 0.0;
	}
	return sum;
}

// A closed surface has vectors that cancel.
double gap(const Envelope &envelope) {
	glm::dvec3 sum(0.0);
	for (const EnvelopeFace &face : envelope.faces) {
		sum += vector_of(face);
	}
	return glm::length(sum);
}

Loops2 random_star(Random &random) {
	const size_t count = 3 + random.index(8);
	Loops2 polygon(1);
	for (size_t i = 0; i < count; ++i) {
		const double angle = (double(i) + random.uniform(0.0, 0.7)) * 6.283185307 / double(count), radius = random.uniform(8.0, 20.0);
		polygon[0].push_back({ radius * std::cos(angle), radius * std::sin(angle) });
	}
	return polygon;
}

// Sides of faces that no other face has the other way around.
size_t unpaired_sides(const Envelope &envelope) {
	std::vector<std::pair<glm::dvec3, glm::dvec3>> unpaired;
	for (const EnvelopeFace &face : envelope.faces) {
		for (const auto &loop : face.loops) {
			for (size_t i = 0; i < loop.size(); ++i) {
				const glm::dvec3 from = loop[i], to = loop[(i + 1) % loop.size()];
				const auto back = std::ranges::find(unpaired, std::pair(to, from));
				if (back == unpaired.end()) {
					unpaired.emplace_back(from, to);
				} else {
					unpaired.erase(back);
				}
			}
		}
	}
	return unpaired.size();
}

} // namespace

TEST_CASE("without limits an envelope is a prism") {
	const Loops2 square = { { { 0, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 } }, { { 1, 1 }, { 1, 2 }, { 2, 2 }, { 2, 1 } } };
	const Envelope envelope = make_envelope(square, std::vector<EnvelopeSide>(8), 3.0);
	CHECK(envelope.is_closed);
	REQUIRE(envelope.faces.size() == 10);
	CHECK(envelope.faces[0].kind == Kind::Bottom);
	CHECK(envelope.faces[0].loops.size() == 2);
	CHECK(envelope.faces.back().kind == Kind::Top);
	CHECK(envelope.faces.back().loops.size() == 2);
	CHECK(gap(envelope) < 1e-9);
}

TEST_CASE("over any polygon the planes and the top cover it, and the walls close the rest") {
	int failures = 0, tried = 0;
	for (uint64_t seed = 0; seed < 600; ++seed) {
		Random random(seed, 55);
		const Loops2 polygon = random_star(random);
		if (area_of(polygon) < 20.0 || is_self_intersecting(polygon[0])) {
			continue;
		}
		++tried;
		std::vector<EnvelopeSide> sides;
		for (size_t i = 0; i < polygon[0].size(); ++i) {
			sides.push_back({ random.uniform(0.0, 8.0), random.chance(0.3) ? 90.0 : random.uniform(15.0, 85.0) });
		}
		const Envelope envelope = make_envelope(polygon, sides, random.uniform(4.0, 30.0));
		const bool is_good = envelope.is_closed && std::abs(roof_plan(envelope) - area_of(polygon)) < 1e-5 * area_of(polygon) && gap(envelope) < 1e-4;
		if (!is_good) {
			MESSAGE("seed " << seed << ": closed " << envelope.is_closed << " plan " << roof_plan(envelope) << " of " << area_of(polygon) << " gap "
							<< gap(envelope));
			++failures;
		}
		for (const EnvelopeFace &face : envelope.faces) {
			const glm::dvec3 normal = glm::normalize(vector_of(face));
			CHECK((face.kind == Kind::Bottom ? normal.z < -0.999 : face.kind == Kind::Wall ? std::abs(normal.z) < 1e-4 : normal.z > 0.0));
		}
	}
	CHECK(tried > 300);
	CHECK(failures == 0);
}

TEST_CASE("where a face ends in the middle of an upright line, the walls beside it have its point too") {
	// Two wings that look to the front; of the three sides that do, the planes begin at 5 m and rise by 45 degrees.
	const Loops2 comb = { { { 0, 0 }, { 3, 0 }, { 3, 2 }, { 10, 2 }, { 10, 4 }, { 3, 4 }, { 3, 6 }, { 10, 6 }, { 10, 8 }, { 3, 8 }, { 3, 10 }, { 0, 10 } } };
	std::vector<EnvelopeSide> sides(comb[0].size());
	sides[0] = sides[2] = sides[6] = { 5.0, 45.0 };
	const Envelope envelope = make_envelope(comb, sides, 20.0);
	CHECK(envelope.faces.size() == 16);
	CHECK(unpaired_sides(envelope) == 0);
}

TEST_CASE("over stairs and combs, where many things happen at one height, all faces fit together") {
	for (uint64_t seed = 0; seed < 600; ++seed) {
		Random random(seed, 56);
		Loops2 polygon = { random_right_angles(random) };
		std::vector<EnvelopeSide> sides;
		const bool is_whole = random.chance(0.5);
		for (size_t i = 0; i < polygon[0].size(); ++i) {
			sides.push_back({ is_whole ? double(random.index(8)) : random.uniform(0.0, 8.0), random.chance(0.3) ? 90.0 : is_whole ? 45.0 : random.uniform(15.0, 85.0) });
		}
		const Envelope envelope = make_envelope(polygon, sides, is_whole ? 4.0 + double(random.index(20)) : random.uniform(4.0, 30.0));
		CAPTURE(seed);
		CHECK(envelope.is_closed);
		CHECK(unpaired_sides(envelope) == 0);
		CHECK(std::abs(roof_plan(envelope) - area_of(polygon)) < 1e-5 * area_of(polygon));
	}
}

TEST_CASE("sides of one line that begin apart end in an upright step") {
	// The front in two halves, of which the second begins at 1 m: both at 45 degrees up to 3 m, 3 m and 2 m in.
	const Loops2 lot = { { { 0, 0 }, { 10, 0 }, { 20, 0 }, { 20, 10 }, { 0, 10 } } };
	std::vector<EnvelopeSide> sides(5);
	sides[0] = { 0.0, 45.0 };
	sides[1] = { 1.0, 45.0 };
	const Envelope envelope = make_envelope(lot, sides, 3.0);
	CHECK(envelope.is_closed);
	CHECK(unpaired_sides(envelope) == 0);
	CHECK(envelope.faces.back().kind == Kind::Top);
	CHECK(vector_of(envelope.faces.back()).z == doctest::Approx(10.0 * 7.0 + 10.0 * 8.0));
	// Left, back, right, the half front, and the step: a triangle of 1 by 1, then a strip 1 wide along the slope.
	const auto step = std::ranges::find_if(envelope.faces, [](const EnvelopeFace &face) { return face.edge >= 10; });
	REQUIRE(step != envelope.faces.end());
	CHECK(step->kind == Kind::Wall);
	CHECK(glm::length(vector_of(*step)) == doctest::Approx(0.5 + 2.0));
}

TEST_CASE("a plane that rises around a courtyard has it as a hole, unless a straight side of it keeps what lies behind") {
	const Loop2 square = { { 0, 0 }, { 20, 0 }, { 20, 20 }, { 0, 20 } };
	const auto slope_over = [&](const Loop2 &courtyard) {
		std::vector<EnvelopeSide> sides(square.size() + courtyard.size());
		sides[0] = { 0.0, 45.0 };
		const Envelope envelope = make_envelope({ square, courtyard }, sides, 10.0);
		CHECK(envelope.is_closed);
		CHECK(unpaired_sides(envelope) == 0);
		return *std::ranges::find(envelope.faces, Kind::Slope, &EnvelopeFace::kind);
	};
	const EnvelopeFace around = slope_over({ { 9, 2 }, { 10, 4 }, { 11, 2 } });
	CHECK(around.loops.size() == 2);
	CHECK(vector_of(around).z == doctest::Approx(20.0 * 10.0 - 2.0));
	const EnvelopeFace beside = slope_over({ { 9, 2 }, { 9, 4 }, { 11, 4 }, { 11, 2 } });
	CHECK(beside.loops.size() == 1);
	CHECK(vector_of(beside).z == doctest::Approx(20.0 * 10.0 - 2.0 * 8.0));
}

TEST_CASE("an envelope over nothing or over a crossing outline is empty") {
	CHECK(make_envelope({ { { 0, 0 }, { 4, 0 }, { 0, 4 }, { 4, 4 } } }, std::vector<EnvelopeSide>(4), 3.0).faces.empty());
	CHECK(make_envelope({ { { 0, 0 }, { 4, 0 }, { 4, 4 } } }, std::vector<EnvelopeSide>(3), 0.0).faces.empty());
}
