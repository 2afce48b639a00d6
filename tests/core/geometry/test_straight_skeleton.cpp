#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "core/base/random.h"
#include "core/geometry/straight_skeleton.h"

using namespace pcg;

namespace {

using Loop = Loop2;
constexpr double endless = std::numeric_limits<double>::infinity();

double area(const Loop &loop) {
	double twice = 0.0;
	for (size_t i = 0; i < loop.size(); ++i) {
		const glm::dvec2 a = loop[i], b = loop[(i + 1) % loop.size()];
		twice += a.x * b.y - b.x * a.y;
	}
	return twice / 2.0;
}

double area(const SkeletonFace &face) {
	Loop loop;
	for (const SkeletonVertex &vertex : face.outline) {
		loop.push_back(vertex.position);
	}
	return area(loop);
}

double area_of_edge(const StraightSkeleton &skeleton, uint32_t edge) {
	double sum = 0.0;
	for (const SkeletonFace &face : skeleton.faces) {
		sum += face.edge == edge ? area(face) : 0.0;
	}
	return sum;
}

double total_area(const StraightSkeleton &skeleton) {
	double sum = 0.0;
	for (const SkeletonFace &face : skeleton.faces) {
		sum += area(face);
	}
	for (const SkeletonFront &front : skeleton.fronts) {
		sum += area(front.points);
	}
	return sum;
}

double highest(const StraightSkeleton &skeleton) {
	double time = 0.0;
	for (const SkeletonFace &face : skeleton.faces) {
		for (const SkeletonVertex &vertex : face.outline) {
			time = std::max(time, vertex.time);
		}
	}
	return time;
}

// Each vertex of a face lies as far from the edge's line as its time says.
void check_heights(const StraightSkeleton &skeleton, const Loops2 &loops, const std::vector<double> &speeds) {
	std::vector<std::pair<glm::dvec2, glm::dvec2>> edges;
	for (const Loop &loop : loops) {
		for (size_t i = 0; i < loop.size(); ++i) {
			edges.push_back({ loop[i], loop[(i + 1) % loop.size()] });
		}
	}
	for (const SkeletonFace &face : skeleton.faces) {
		const auto [a, b] = edges[face.edge];
		const glm::dvec2 direction = glm::normalize(b - a), normal(-direction.y, direction.x);
		const double speed = speeds.empty() ? 1.0 : speeds[face.edge];
		for (const SkeletonVertex &vertex : face.outline) {
			CHECK(glm::dot(normal, vertex.position - a) == doctest::Approx(vertex.time * speed).epsilon(1e-6));
		}
	}
}

} // namespace

TEST_CASE("a square's skeleton is four equal triangles that meet in the middle") {
	const Loops2 square = { { { 0, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 } } };
	const StraightSkeleton skeleton = straight_skeleton(square, {}, endless);
	CHECK(skeleton.is_complete);
	REQUIRE(skeleton.faces.size() == 4);
	for (const SkeletonFace &face : skeleton.faces) {
		CHECK(face.outline.size() == 3);
		CHECK(area(face) == doctest::Approx(4.0));
	}
	CHECK(highest(skeleton) == doctest::Approx(2.0));
	CHECK(skeleton.fronts.empty());
}

TEST_CASE("a rectangle's skeleton has a ridge: two trapezoids and two triangles") {
	const Loops2 rectangle = { { { 0, 0 }, { 10, 0 }, { 10, 4 }, { 0, 4 } } };
	const StraightSkeleton skeleton = straight_skeleton(rectangle, {}, endless);
	CHECK(skeleton.is_complete);
	REQUIRE(skeleton.faces.size() == 4);
	CHECK(area_of_edge(skeleton, 0) == doctest::Approx(16.0)); // (10 + 6) / 2 * 2
	CHECK(area_of_edge(skeleton, 1) == doctest::Approx(4.0));
	CHECK(skeleton.faces[0].outline.size() == 4);
	CHECK(skeleton.faces[1].outline.size() == 3);
	CHECK(skeleton.faces[0].edge == 0);
	CHECK(skeleton.faces[0].outline[0].position == glm::dvec2(0, 0));
	CHECK(skeleton.faces[0].outline[1].position == glm::dvec2(10, 0));
}

TEST_CASE("an L has a valley from its inner corner and six faces that cover it") {
	const Loops2 shape = { { { 0, 0 }, { 10, 0 }, { 10, 4 }, { 4, 4 }, { 4, 10 }, { 0, 10 } } };
	const StraightSkeleton skeleton = straight_skeleton(shape, {}, endless);
	CHECK(skeleton.is_complete);
	CHECK(skeleton.faces.size() == 6);
	CHECK(total_area(skeleton) == doctest::Approx(64.0));
	CHECK(highest(skeleton) == doctest::Approx(2.0)); // both wings are 4 m wide
	check_heights(skeleton, shape, {});
}

TEST_CASE("a front splits where an inner corner reaches the opposite side") {
	// A long bar with a notch from above that leaves 1 m: the notch's corners reach the bottom before the wings close.
	const Loops2 shape = { { { 0, 0 }, { 20, 0 }, { 20, 6 }, { 11, 6 }, { 11, 1 }, { 9, 1 }, { 9, 6 }, { 0, 6 } } };
	const StraightSkeleton skeleton = straight_skeleton(shape, {}, endless);
	CHECK(skeleton.is_complete);
	CHECK(total_area(skeleton) == doctest::Approx(110.0)); // 120 - 2 * 5
	CHECK(highest(skeleton) > 2.9);
	check_heights(skeleton, shape, {});
}

TEST_CASE("a pointed corner splits the side that it reaches") {
	const Loops2 shape = { { { 0, 0 }, { 10, 0 }, { 10, 8 }, { 5, 2 }, { 0, 8 } } };
	const StraightSkeleton skeleton = straight_skeleton(shape, {}, endless);
	CHECK(skeleton.is_complete);
	CHECK(total_area(skeleton) == doctest::Approx(50.0)); // 80 - 10 * 6 / 2
	check_heights(skeleton, shape, {});
}

TEST_CASE("a ring closes to a ridge all around") {
	const Loops2 ring = { { { 0, 0 }, { 10, 0 }, { 10, 10 }, { 0, 10 } }, { { 3, 3 }, { 3, 7 }, { 7, 7 }, { 7, 3 } } };
	const StraightSkeleton skeleton = straight_skeleton(ring, {}, endless);
	CHECK(skeleton.is_complete);
	CHECK(total_area(skeleton) == doctest::Approx(84.0));
	CHECK(highest(skeleton) == doctest::Approx(1.5));
	check_heights(skeleton, ring, {});
}

TEST_CASE("a front that stops leaves strips and the rest") {
	const Loops2 rectangle = { { { 0, 0 }, { 10, 0 }, { 10, 6 }, { 0, 6 } } };
	const StraightSkeleton skeleton = straight_skeleton(rectangle, {}, 1.0);
	CHECK(skeleton.is_complete);
	REQUIRE(skeleton.fronts.size() == 1);
	CHECK(area(skeleton.fronts[0].points) == doctest::Approx(32.0)); // 8 x 4
	CHECK(area_of_edge(skeleton, 0) == doctest::Approx(9.0)); // (10 + 8) / 2
	CHECK(skeleton.fronts[0].edges.size() == 4);
}

TEST_CASE("a setback of one side only leaves a strip with square ends") {
	const Loops2 rectangle = { { { 0, 0 }, { 10, 0 }, { 10, 6 }, { 0, 6 } } };
	const StraightSkeleton skeleton = straight_skeleton(rectangle, std::vector{ 2.0, 0.0, 0.0, 0.0 }, 1.0);
	CHECK(skeleton.is_complete);
	REQUIRE(skeleton.faces.size() == 1);
	CHECK(area_of_edge(skeleton, 0) == doctest::Approx(20.0));
	REQUIRE(skeleton.fronts.size() == 1);
	CHECK(area(skeleton.fronts[0].points) == doctest::Approx(40.0));
}

TEST_CASE("two collinear sides with different setbacks meet in a step") {
	const Loops2 shape = { { { 0, 0 }, { 5, 0 }, { 10, 0 }, { 10, 6 }, { 0, 6 } } };
	const StraightSkeleton skeleton = straight_skeleton(shape, std::vector{ 1.0, 3.0, 0.0, 0.0, 0.0 }, 1.0);
	CHECK(skeleton.is_complete);
	CHECK(area_of_edge(skeleton, 0) == doctest::Approx(5.0));
	CHECK(area_of_edge(skeleton, 1) == doctest::Approx(15.0));
	REQUIRE(skeleton.fronts.size() == 1);
	CHECK(area(skeleton.fronts[0].points) == doctest::Approx(40.0));
	CHECK(skeleton.fronts[0].points.size() == 6);
}

TEST_CASE("a setback larger than the polygon leaves nothing") {
	const Loops2 square = { { { 0, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 } } };
	const StraightSkeleton skeleton = straight_skeleton(square, {}, 5.0);
	CHECK(skeleton.is_complete);
	CHECK(skeleton.fronts.empty());
	CHECK(total_area(skeleton) == doctest::Approx(16.0));
}

TEST_CASE("a cross, where eight events fall together, is covered") {
	const Loops2 cross = { { { 2, 0 }, { 4, 0 }, { 4, 2 }, { 6, 2 }, { 6, 4 }, { 4, 4 }, { 4, 6 }, { 2, 6 }, { 2, 4 }, { 0, 4 }, { 0, 2 }, { 2, 2 } } };
	const StraightSkeleton skeleton = straight_skeleton(cross, {}, endless);
	CHECK(skeleton.is_complete);
	CHECK(skeleton.faces.size() == 12);
	CHECK(total_area(skeleton) == doctest::Approx(20.0));
	check_heights(skeleton, cross, {});
}

TEST_CASE("input that is no polygon is refused, not computed") {
	CHECK(!straight_skeleton({}, {}, 1.0).is_complete);
	CHECK(!straight_skeleton({ { { 0, 0 }, { 1, 0 } } }, {}, 1.0).is_complete);
	CHECK(!straight_skeleton({ { { 0, 0 }, { 1, 0 }, { std::nan(""), 1 } } }, {}, 1.0).is_complete);
	CHECK(!straight_skeleton({ { { 0, 0 }, { 1, 0 }, { 1, 1 } } }, std::vector{ 1.0, -1.0, 1.0 }, 1.0).is_complete);
}

TEST_CASE("faces cover any star-shaped polygon, with any speeds, until any time") {
	int failures = 0;
	for (uint64_t seed = 0; seed < 2000; ++seed) {
		Random random(seed, 77);
		const size_t count = 3 + random.index(14);
		Loop loop;
		std::vector<double> speeds;
		for (size_t i = 0; i < count; ++i) {
			const double angle = (double(i) + random.uniform(0.0, 0.8)) * 6.283185307 / double(count);
			const double radius = random.uniform(3.0, 20.0);
			loop.push_back({ radius * std::cos(angle), radius * std::sin(angle) });
			speeds.push_back(seed % 4 < 2 ? 1.0 : random.uniform(0.3, 2.0));
		}
		if (area(loop) < 1.0) {
			continue;
		}
		const double until = seed % 2 ? endless : random.uniform(0.1, 4.0);
		const StraightSkeleton skeleton = straight_skeleton({ loop }, speeds, until);
		const double covered = total_area(skeleton);
		const bool is_good = skeleton.is_complete && std::abs(covered - area(loop)) < 1e-6 * area(loop);
		if (!is_good) {
			MESSAGE("seed " << seed << ": covered " << covered << " of " << area(loop) << " complete " << skeleton.is_complete << " n " << count << " until " << until);
			++failures;
		}
	}
	CHECK(failures == 0);
}

TEST_CASE("faces cover any polygon of right angles, where many events fall together") {
	int failures = 0;
	for (uint64_t seed = 0; seed < 2000; ++seed) {
		Random random(seed, 78);
		// A histogram over a flat base: columns of whole heights.
		const size_t columns = 1 + random.index(6);
		Loop loop = { { 0, 0 }, { double(2 * columns), 0 } };
		for (size_t c = columns; c-- > 0;) {
			const double height = double(1 + random.index(5));
			loop.push_back({ double(2 * c + 2), height });
			loop.push_back({ double(2 * c), height });
		}
		Loop clean;
		for (const glm::dvec2 &p : loop) {
			if (clean.empty() || clean.back() != p) {
				clean.push_back(p);
			}
		}
		const double turn = double(seed % 5) * 0.37; // rounding differs in every direction
		for (glm::dvec2 &p : clean) {
			p = { p.x * std::cos(turn) - p.y * std::sin(turn), p.x * std::sin(turn) + p.y * std::cos(turn) };
		}
		const StraightSkeleton skeleton = straight_skeleton({ clean }, {}, endless);
		const double covered = total_area(skeleton);
		if (!skeleton.is_complete || std::abs(covered - area(clean)) > 1e-6) {
			MESSAGE("seed " << seed << ": covered " << covered << " of " << area(clean) << " complete " << skeleton.is_complete);
			++failures;
		}
	}
	CHECK(failures == 0);
}

TEST_CASE("an outline that crosses itself everywhere ends in bounded time and memory") {
	Random random(4, 4);
	Loop scribble;
	for (int i = 0; i < 300; ++i) {
		scribble.push_back({ random.uniform(0.0, 40.0), random.uniform(0.0, 40.0) });
	}
	const StraightSkeleton skeleton = straight_skeleton({ scribble }, {}, endless);
	CHECK(skeleton.faces.size() < 10'000);
}
