#include "core/geometry/triangulate.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "core/base/random.h"

using namespace pcg;

namespace {

double area_of(const std::vector<glm::dvec2> &points, const std::vector<uint32_t> &triangles) {
	double sum = 0.0;
	for (size_t i = 0; i + 2 < triangles.size(); i += 3) {
		const glm::dvec2 a = points[triangles[i]], b = points[triangles[i + 1]], c = points[triangles[i + 2]];
		const double size = 0.5 * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
		CHECK(size >= 0.0);
		sum += size;
	}
	return sum;
}

std::vector<uint32_t> triangles_of(const std::vector<glm::dvec2> &points, const std::vector<uint32_t> &loop_ends) {
	std::vector<uint32_t> triangles;
	triangulate(points, loop_ends, triangles);
	return triangles;
}

} // namespace

TEST_CASE("a convex polygon becomes a fan of n - 2 triangles") {
	const std::vector<glm::dvec2> points = { { 0, 0 }, { 4, 0 }, { 5, 3 }, { 2, 5 }, { -1, 3 } };
	const auto triangles = triangles_of(points, { 5 });
	CHECK(triangles.size() == 9);
	CHECK(area_of(points, triangles) == doctest::Approx(21.0)); // shoelace: (12 + 19 + 11) / 2
}

TEST_CASE("a concave polygon is covered exactly, whichever way it runs") {
	std::vector<glm::dvec2> points = { { 0, 0 }, { 30, 0 }, { 30, 20 }, { 20, 20 }, { 20, 10 }, { 10, 10 }, { 10, 20 }, { 0, 20 } };
	CHECK(area_of(points, triangles_of(points, { 8 })) == doctest::Approx(500.0));
	std::reverse(points.begin(), points.end());
	CHECK(area_of(points, triangles_of(points, { 8 })) == doctest::Approx(500.0));
}

TEST_CASE("holes stay open, also several on one line") {
	const std::vector<glm::dvec2> points = { { 0, 0 }, { 20, 0 }, { 20, 10 }, { 0, 10 }, //
		{ 2, 3 }, { 2, 7 }, { 6, 7 }, { 6, 3 }, //
		{ 8, 3 }, { 8, 7 }, { 12, 7 }, { 12, 3 }, //
		{ 14, 3 }, { 14, 7 }, { 18, 7 }, { 18, 3 } };
	const auto triangles = triangles_of(points, { 4, 8, 12, 16 });
	CHECK(area_of(points, triangles) == doctest::Approx(200.0 - 3 * 16.0));
	CHECK(triangles.size() / 3 <= 16 + 2 * 3 - 2); // corners + 2 holes - 2, less what is flat
}

TEST_CASE("random star polygons are covered exactly") {
	Random random(7);
	for (int round = 0; round < 200; ++round) {
		std::vector<glm::dvec2> points;
		const int count = 3 + int(random.index(30));
		double doubled = 0.0;
		for (int i = 0; i < count; ++i) {
			const double angle = 6.283185307179586 * i / count, radius = random.uniform(1.0, 10.0);
			points.push_back({ radius * std::cos(angle), radius * std::sin(angle) });
		}
		for (int i = 0; i < count; ++i) {
			const glm::dvec2 a = points[size_t(i)], b = points[size_t((i + 1) % count)];
			doubled += a.x * b.y - a.y * b.x;
		}
		CHECK(area_of(points, triangles_of(points, { uint32_t(count) })) == doctest::Approx(0.5 * doubled));
	}
}

TEST_CASE("degenerate and crossing outlines end, with triangles that exist") {
	CHECK(triangles_of({ { 0, 0 }, { 1, 0 } }, { 2 }).empty());
	CHECK(triangles_of({}, {}).empty());
	const std::vector<glm::dvec2> bow_tie = { { 0, 0 }, { 10, 10 }, { 10, 0 }, { 0, 9 } };
	for (const uint32_t index : triangles_of(bow_tie, { 4 })) {
		CHECK(index < 4);
	}
	const std::vector<glm::dvec2> line = { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 3, 0 } };
	CHECK(area_of(line, triangles_of(line, { 4 })) == doctest::Approx(0.0));
}
