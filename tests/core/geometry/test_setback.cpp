#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/base/random.h"
#include "core/geometry/convex_parts.h"
#include "core/geometry/inner_rectangle.h"
#include "core/geometry/polygon.h"
#include "core/geometry/setback.h"
#include "core/geometry/straight_skeleton.h"
#include "tests/core/geometry/random_outlines.h"

using namespace pcg;

namespace {

// A star around the origin, concave more often than not; every third has a square hole.
Loops2 random_polygon(uint64_t seed) {
	Random random(seed, 101);
	const size_t count = 3 + random.index(10);
	Loops2 polygon(1);
	for (size_t i = 0; i < count; ++i) {
		const double angle = (double(i) + random.uniform(0.0, 0.8)) * 6.283185307 / double(count), radius = random.uniform(6.0, 20.0);
		polygon[0].push_back({ radius * std::cos(angle), radius * std::sin(angle) });
	}
	const bool has_room = contains(polygon[0], { 0.0, 0.0 }) && count > 4;
	if (seed % 3 == 0 && has_room) {
		polygon.push_back({ { 0.5, 0.5 }, { 0.5, -0.5 }, { -0.5, -0.5 }, { -0.5, 0.5 } });
	}
	return polygon;
}

std::vector<std::pair<glm::dvec2, glm::dvec2>> edges_of(const Loops2 &polygon) {
	std::vector<std::pair<glm::dvec2, glm::dvec2>> edges;
	for (const Loop2 &loop : polygon) {
		for (size_t i = 0; i < loop.size(); ++i) {
			edges.push_back({ loop[i], loop[(i + 1) % loop.size()] });
		}
	}
	return edges;
}

double rest_area(const Setback &setback) {
	double sum = 0.0;
	for (const Loops2 &polygon : setback.rest) {
		sum += area_of(polygon);
	}
	return sum;
}

double strip_area(const Setback &setback) {
	double sum = 0.0;
	for (const SetbackStrip &strip : setback.strips) {
		sum += area_of(strip.polygon);
	}
	return sum;
}

bool is_sound(const Loops2 &polygon) {
	const std::vector<std::pair<glm::dvec2, glm::dvec2>> edges = edges_of(polygon);
	return area_of(polygon) > 20.0 && !is_self_intersecting(polygon[0]) &&
			(polygon.size() == 1 || std::ranges::all_of(polygon[1], [&](glm::dvec2 p) { return contains(polygon[0], p) && glm::length(p) < 4.0; }));
}

double total_area(const Polygons2 &polygons) {
	double sum = 0.0;
	for (const Loops2 &polygon : polygons) {
		sum += area_of(polygon);
	}
	return sum;
}

Loop2 rectangle(double x0, double y0, double x1, double y1) {
	return { { x0, y0 }, { x1, y0 }, { x1, y1 }, { x0, y1 } };
}

Loop2 reversed(const Loop2 &loop) { return Loop2(loop.rbegin(), loop.rend()); }

} // namespace

TEST_CASE("strips and what is left are the polygon, whatever the distances") {
	int failures = 0, tried = 0;
	for (uint64_t seed = 0; seed < 1500; ++seed) {
		const Loops2 polygon = random_polygon(seed);
		if (!is_sound(polygon)) {
			continue;
		}
		++tried;
		Random random(seed, 102);
		std::vector<double> distances;
		for (size_t i = 0; i < edges_of(polygon).size(); ++i) {
			distances.push_back(random.chance(0.4) ? 0.0 : random.uniform(0.0, seed % 2 ? 3.0 : 12.0));
		}
		const Setback result = set_back(polygon, distances);
		const double sum = strip_area(result) + rest_area(result), area = area_of(polygon);
		if (!result.is_complete || std::abs(sum - area) > 1e-6 * area) {
			MESSAGE("seed " << seed << ": " << sum << " of " << area << " complete " << result.is_complete);
			++failures;
		}
	}
	CHECK(tried > 500);
	CHECK(failures == 0);
}

TEST_CASE("any sides of stairs and combs can be set back, also where one meets another in its line") {
	for (uint64_t seed = 0; seed < 1500; ++seed) {
		Random random(seed, 103);
		const Loops2 polygon = { random_right_angles(random) };
		const double common = random.chance(0.5) ? 1.0 + double(random.index(8)) : random.uniform(0.1, 9.0);
		std::vector<double> distances;
		for (size_t i = 0; i < polygon[0].size(); ++i) {
			distances.push_back(random.chance(0.4) ? 0.0 : seed % 3 == 0 ? common : seed % 3 == 1 ? 1.0 + double(random.index(6)) : random.uniform(0.1, 6.0));
		}
		const Setback result = set_back(polygon, distances);
		CAPTURE(seed);
		CHECK(result.is_complete);
		CHECK(strip_area(result) + rest_area(result) == doctest::Approx(area_of(polygon)));
	}
	// The upper side comes down to the lower one's line when the short side between them is gone, and goes on alone behind a step.
	const Setback stairs = set_back({ { { 0, 0 }, { 10, 0 }, { 10, 6 }, { 4, 6 }, { 4, 4 }, { 0, 4 } } }, std::vector<double>{ 0, 0, 3, 1, 0, 0 });
	CHECK(rest_area(stairs) == doctest::Approx((4.0 + 2.0 / 3.0) * 4.0 + (6.0 - 2.0 / 3.0) * 3.0));
}

// Each side in up to three pieces, each with its own distance: fronts in steps meet head-on, and pieces of one line do not count as crossing.
TEST_CASE("sides in pieces can be set back, each piece by its own distance") {
	for (uint64_t seed = 0; seed <= 600; ++seed) {
		Random random(seed < 600 ? seed : 5681, 105); // the pieces of 5681 seem to cross each other, by rounding
		const Loop2 outline = random_right_angles(random);
		Loop2 pieces;
		std::vector<double> distances;
		for (size_t i = 0; i < outline.size(); ++i) {
			const glm::dvec2 way = outline[(i + 1) % outline.size()] - outline[i];
			const size_t count = 1 + random.index(3);
			for (size_t piece = 0; piece < count; ++piece) {
				pieces.push_back(outline[i] + way * (double(piece) / double(count)));
				distances.push_back(random.chance(0.4) ? 0.0 : random.chance(0.5) ? 2.0 : 0.5);
			}
		}
		const Setback result = set_back({ pieces }, distances);
		CAPTURE(seed);
		CHECK_FALSE(is_self_intersecting(pieces));
		CHECK(result.is_complete);
		CHECK(strip_area(result) + rest_area(result) == doctest::Approx(area_of({ pieces })));
	}
}

TEST_CASE("a corner sharper than a tenth of a degree does not grow, one of half a degree does") {
	CHECK_FALSE(grow({ { { 0, 0 }, { 100, 0 }, { 100, 0.1 } } }, 0.5).is_complete);
	const Loops2 needle = { { { 0, 0 }, { 100, 0 }, { 100, 1 } } };
	const Setback grown = grow(needle, 0.5);
	REQUIRE(grown.rest.size() == 1);
	CHECK(strip_area(grown) + rest_area(grown) == doctest::Approx(area_of(needle)));
	CHECK(area_of(grown.rest[0]) > area_of(needle));
}

TEST_CASE("a strip begins with the edge that it comes from") {
	for (uint64_t seed = 0; seed < 300; ++seed) {
		const Loops2 polygon = random_polygon(seed);
		const auto edges = edges_of(polygon);
		if (!is_sound(polygon)) {
			continue;
		}
		for (const double distance : { 0.3, 2.0, 50.0 }) {
			uint32_t last = 0;
			for (const SetbackStrip &strip : set_back(polygon, std::vector<double>(edges.size(), distance)).strips) {
				CHECK(strip.polygon[0][0] == edges[strip.edge].first);
				CHECK(strip.polygon[0][1] == edges[strip.edge].second);
				CHECK(strip.edge >= last);
				last = strip.edge;
			}
			for (const SetbackStrip &strip : grow(polygon, 0.2 * distance).strips) {
				CHECK(strip.polygon[0][0] == edges[strip.edge].first);
				CHECK(strip.polygon[0][1] == edges[strip.edge].second);
			}
		}
	}
}

TEST_CASE("what is left keeps its distance from every edge") {
	for (uint64_t seed = 0; seed < 300; ++seed) {
		const Loops2 polygon = random_polygon(seed);
		if (!is_sound(polygon)) {
			continue;
		}
		const auto edges = edges_of(polygon);
		const Setback result = set_back(polygon, std::vector<double>(edges.size(), 1.0));
		for (const Loops2 &rest : result.rest) {
			for (const auto &[a, b] : edges_of(rest)) {
				for (const auto &[c, d] : edges) {
					const glm::dvec2 way = d - c;
					const double at = glm::clamp(glm::dot(a - c, way) / glm::dot(way, way), 0.0, 1.0);
					CHECK(glm::distance(a, c + at * way) > 1.0 - 1e-6);
				}
			}
		}
	}
}

TEST_CASE("grown by a little and set back by it a polygon is what it was") {
	for (uint64_t seed = 0; seed < 300; ++seed) {
		const Loops2 polygon = random_polygon(seed);
		if (!is_sound(polygon)) {
			continue;
		}
		const Setback grown = grow(polygon, 0.01);
		REQUIRE(grown.rest.size() == 1);
		CHECK(rest_area(grown) + strip_area(grown) == doctest::Approx(area_of(polygon)).epsilon(1e-6));
		const Setback back = set_back(grown.rest[0], std::vector<double>(edges_of(grown.rest[0]).size(), 0.01));
		CHECK(rest_area(back) == doctest::Approx(area_of(polygon)).epsilon(1e-6));
	}
}

TEST_CASE("grown wings that meet close to a hole") {
	const Loops2 u = { { { 0, 0 }, { 10, 0 }, { 10, 10 }, { 6, 10 }, { 6.5, 4 }, { 3.5, 4 }, { 4, 10 }, { 0, 10 } } };
	const Setback result = grow(u, 1.2);
	REQUIRE(result.rest.size() == 1);
	CHECK(result.rest[0].size() == 2);
	CHECK(rest_area(result) + strip_area(result) == doctest::Approx(area_of(u)));
}

TEST_CASE("an outline that crosses itself is not moved and does not hang") {
	Random random(7, 7);
	Loop2 scribble;
	for (int i = 0; i < 40; ++i) {
		scribble.push_back({ random.uniform(0.0, 40.0), random.uniform(0.0, 40.0) });
	}
	const Setback result = set_back({ scribble }, std::vector<double>(40, 1.0));
	CHECK(!result.is_complete);
	CHECK(result.strips.empty());
	CHECK(!grow({ scribble }, 1.0).is_complete);
	CHECK(largest_rectangle({ scribble }).size() % 4 == 0);
	CHECK(convex_parts({ scribble }, 1e9).size() < 1000);
	CHECK(overlay({ scribble }, { rectangle(0, 0, 20, 20) }, OverlayKind::Difference).size() < 1000);
}

TEST_CASE("laid over each other: union, difference, intersection") {
	const Loops2 a = { rectangle(0, 0, 4, 4) }, b = { rectangle(2, 1, 6, 3) };
	CHECK(total_area(overlay(a, b, OverlayKind::Union)) == doctest::Approx(20.0));
	CHECK(total_area(overlay(a, b, OverlayKind::Difference)) == doctest::Approx(12.0));
	CHECK(total_area(overlay(a, b, OverlayKind::Intersection)) == doctest::Approx(4.0));
	const auto ring = overlay(a, { rectangle(1, 1, 3, 3) }, OverlayKind::Difference);
	REQUIRE(ring.size() == 1);
	CHECK(ring[0].size() == 2); // a hole
	CHECK(total_area(ring) == doctest::Approx(12.0));
	CHECK(overlay(a, a, OverlayKind::Difference).empty());
	CHECK(total_area(overlay(a, {}, OverlayKind::Difference)) == doctest::Approx(16.0));
	// Neighbours that share an edge, and a corner only.
	const auto joined = overlay({ rectangle(0, 0, 1, 1), rectangle(1, 0, 2, 1) }, {}, OverlayKind::Union);
	REQUIRE(joined.size() == 1);
	CHECK(without_straight_points(joined[0][0], 1e-9).size() == 4);
	CHECK(overlay({ rectangle(0, 0, 1, 1), rectangle(1, 1, 2, 2) }, {}, OverlayKind::Union).size() == 2);
}

TEST_CASE("union and intersection of random polygons have the areas that sets have") {
	int failures = 0;
	for (uint64_t seed = 0; seed < 300; ++seed) {
		const Loops2 a = random_polygon(2 * seed);
		Loops2 b = random_polygon(2 * seed + 1);
		if (!is_sound(a) || !is_sound(b)) {
			continue;
		}
		for (Loop2 &loop : b) {
			for (glm::dvec2 &p : loop) {
				p += glm::dvec2(double(seed % 7), double(seed % 5));
			}
		}
		const double both = total_area(overlay(a, b, OverlayKind::Intersection)), either = total_area(overlay(a, b, OverlayKind::Union));
		const double first_only = total_area(overlay(a, b, OverlayKind::Difference));
		const bool is_good = std::abs(area_of(a) + area_of(b) - both - either) < 1e-4 && std::abs(area_of(a) - both - first_only) < 1e-4;
		failures += is_good ? 0 : 1;
	}
	CHECK(failures == 0);
}

TEST_CASE("the largest rectangle lies in the polygon, and no other found by trying is larger") {
	for (uint64_t seed = 0; seed < 120; ++seed) {
		const Loops2 polygon = random_polygon(seed);
		if (!is_sound(polygon)) {
			continue;
		}
		const Loop2 found = largest_rectangle(polygon);
		REQUIRE(found.size() == 4);
		const double area = 0.5 * signed_area(found);
		CHECK(total_area(overlay({ found }, polygon, OverlayKind::Difference)) < 1e-4);
		Random random(seed, 103);
		for (int i = 0; i < 300; ++i) {
			const glm::dvec2 low = { random.uniform(-20.0, 20.0), random.uniform(-20.0, 20.0) };
			const glm::dvec2 size = { random.uniform(0.0, 20.0), random.uniform(0.0, 20.0) };
			if (size.x * size.y <= area * 1.001) {
				continue;
			}
			CHECK(total_area(overlay({ rectangle(low.x, low.y, low.x + size.x, low.y + size.y) }, polygon, OverlayKind::Difference)) > 1e-6);
		}
		CHECK(0.5 * signed_area(largest_rectangle_along_edges(polygon)) > 0.0);
	}
}

TEST_CASE("of equal rectangles the one nearest to the centre of gravity") {
	// 4 x 1 below, 4 x 1 above, and a small room beside the upper one that draws the centre up.
	const Loops2 polygon = { { { 0, 0 }, { 4, 0 }, { 4, 1 }, { 1, 1 }, { 1, 2 }, { 4, 2 }, { 4, 2.4 }, { 4.4, 2.4 }, { 4.4, 3 }, { 0, 3 } } };
	const Loop2 found = largest_rectangle(polygon);
	REQUIRE(found.size() == 4);
	CHECK(0.5 * signed_area(found) == doctest::Approx(4.0));
	CHECK(found[0].y == doctest::Approx(2.0));
}

TEST_CASE("convex parts are convex, cover the polygon and begin with its first edge") {
	int concave = 0;
	for (uint64_t seed = 0; seed < 400; ++seed) {
		const Loops2 polygon = random_polygon(seed);
		if (!is_sound(polygon)) {
			continue;
		}
		const Polygons2 parts = convex_parts(polygon, 1e9);
		CHECK(total_area(parts) == doctest::Approx(area_of(polygon)).epsilon(1e-9));
		for (const Loops2 &part : parts) {
			CHECK(part.size() == 1);
			CHECK(is_convex(part[0]));
		}
		concave += parts.size() > 1 ? 1 : 0;
		REQUIRE(!parts.empty());
		CHECK(parts[0][0][0] == polygon[0][0]);
		CHECK(parts[0][0][1] == polygon[0][1]);
	}
	CHECK(concave > 100);
}

TEST_CASE("shapes without an area give nothing, not a crash") {
	CHECK(overlay({}, {}, OverlayKind::Union).empty());
	CHECK(largest_rectangle({}).empty());
	CHECK(largest_rectangle({ { { 0, 0 }, { 1, 0 } } }).empty());
	CHECK(largest_rectangle_along_edges({ { { 0, 0 }, { 1, 0 }, { 2, 0 } } }).empty());
	CHECK(convex_parts({ { { 0, 0 }, { 1, 0 }, { 2, 0 } } }, 1e9).size() == 1);
	CHECK(!set_back({ { { 0, 0 }, { 1, 0 }, { NAN, 1 } } }, std::vector{ 1.0, 1.0, 1.0 }).is_complete);
	CHECK(without_straight_points(reversed(rectangle(0, 0, 1, 1)), 1e-9).size() == 4);
}

TEST_CASE("setbacks of triangles and convex quadrangles are what the skeleton says, to the last bit, and their strips join as an overlay joins them") {
	int plain = 0, chained = 0;
	for (uint64_t seed = 0; seed < 2000; ++seed) {
		Random random(seed, 107);
		const size_t count = 3 + random.index(2);
		Loops2 polygon(1);
		std::vector<double> distances;
		for (size_t i = 0; i < count; ++i) {
			const double angle = (double(i) + random.uniform(0.0, 0.8)) * 6.283185307 / double(count), radius = random.uniform(6.0, 20.0);
			polygon[0].push_back({ radius * std::cos(angle), radius * std::sin(angle) });
			distances.push_back(random.index(3) == 0 ? 0.0 : random.index(3) == 0 ? 1.5 : random.uniform(0.1, 4.0));
		}
		const Setback result = set_back(polygon, distances);
		if (!result.is_plain) {
			continue;
		}
		++plain;
		const StraightSkeleton skeleton = straight_skeleton(polygon, distances, 1.0);
		REQUIRE(skeleton.fronts.size() == 1);
		CHECK(result.rest == Polygons2{ { skeleton.fronts[0].points } });
		REQUIRE(skeleton.faces.size() == result.strips.size());
		Loops2 strips;
		for (size_t i = 0; i < result.strips.size(); ++i) {
			Loop2 swept;
			for (const SkeletonVertex &vertex : skeleton.faces[i].outline) {
				swept.push_back(vertex.position);
			}
			CHECK(result.strips[i].edge == skeleton.faces[i].edge);
			CHECK(result.strips[i].polygon == Loops2{ swept });
			strips.push_back(swept);
		}
		const Polygons2 joined = joined_strips(result);
		CHECK(joined == overlay(strips, {}, OverlayKind::Union));
		chained += joined.size() == 1 && strips.size() > 1;
	}
	CHECK(plain > 600);
	CHECK(chained > 200);
}
