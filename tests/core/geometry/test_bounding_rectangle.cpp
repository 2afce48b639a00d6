#include "core/geometry/bounding_rectangle.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "core/base/random.h"

using namespace pcg;

TEST_CASE("a turned rectangle full of points is found, along its longer side and nearest to what is preferred") {
	Random random(1);
	for (int i = 0; i < 40; ++i) {
		const double angle = -1.5 + 3.0 * random.uniform(), length = 5.0 + 5.0 * random.uniform(), width = 1.0 + 3.0 * random.uniform();
		const glm::dvec2 along(std::cos(angle), std::sin(angle)), across(-along.y, along.x);
		std::vector<glm::dvec2> points = { {}, along * length, along * length + across * width, across * width };
		for (int k = 0; k < 20; ++k) {
			points.push_back(along * (length * random.uniform()) + across * (width * random.uniform()));
		}
		CHECK(glm::distance(longer_side_of_least_rectangle(points, { 1.0, 0.0 }), along) < 1e-9); // angle within 90 degrees of x
		CHECK(glm::distance(longer_side_of_least_rectangle(points, -along), -along) < 1e-9);
	}
}

TEST_CASE("points on a line, one point and none give a direction too") {
	const std::vector<glm::dvec2> line = { { 0, 0 }, { 1, 1 }, { 2, 2 } };
	CHECK(glm::distance(longer_side_of_least_rectangle(line, { 1.0, 0.0 }), glm::normalize(glm::dvec2(1.0, 1.0))) < 1e-9);
	CHECK(longer_side_of_least_rectangle(std::vector<glm::dvec2>{ { 3, 4 } }, { 0.0, 1.0 }) == glm::dvec2(0.0, 1.0));
	CHECK(longer_side_of_least_rectangle({}, { 0.0, 1.0 }) == glm::dvec2(0.0, 1.0));
}
