#include <doctest/doctest.h>

#include <algorithm>

#include "core/base/random.h"
#include "core/city/layout.h"
#include "core/city/lot_overlaps.h"
#include "core/city/plan_layout.h"

using namespace pcg;

namespace {

Loop2 loop(double x, double y, double width, double depth) { return { { x, y }, { x + width, y }, { x + width, y + depth }, { x, y + depth } }; }
Loops2 box(double x, double y, double width, double depth) { return Loops2{ loop(x, y, width, depth) }; }

} // namespace

TEST_CASE("outlines that share more than the tolerance are found, and neighbours are not") {
	const std::vector<Loops2> outlines{ box(0, 0, 10, 10), box(10, 0, 10, 10), box(5, 5, 10, 10), box(100, 0, 5, 5), box(101, 1, 2, 2), box(9.95, -10, 10, 10.05) };
	const std::vector<OutlineOverlap> found = find_overlaps(outlines);
	REQUIRE(found.size() == 3);
	CHECK(found[0].a == 0);
	CHECK(found[0].b == 2);
	CHECK(found[0].area == doctest::Approx(25.0));
	CHECK(found[1].a == 1);
	CHECK(found[1].b == 2);
	CHECK(found[1].area == doctest::Approx(25.0));
	CHECK(found[2].a == 3); // within
	CHECK(found[2].area == doctest::Approx(4.0));
	CHECK(find_overlaps(outlines, {}, 0.4).size() == 4); // 9.95 m by 5 cm, too
	const std::vector<OutlineOverlap> moved = find_overlaps(outlines, { false, true, false, false, false, false });
	REQUIRE(moved.size() == 1);
	CHECK(moved[0].b == 2);
	CHECK(find_overlaps({}).empty());
}

TEST_CASE("what stands in a courtyard shares no ground with the ring, what reaches over its edge does") {
	Loop2 court = loop(10, 10, 10, 10);
	std::reverse(court.begin(), court.end());
	const Loops2 ring{ loop(0, 0, 30, 30), court };
	CHECK(find_overlaps(std::vector<Loops2>{ ring, box(12, 12, 5, 5), box(10, 10, 10, 10) }).size() == 1); // these two
	const std::vector<OutlineOverlap> found = find_overlaps(std::vector<Loops2>{ ring, box(15, 15, 10, 5) });
	REQUIRE(found.size() == 1);
	CHECK(found[0].area == doctest::Approx(25.0));
	CHECK(shared_area(ring, box(-5, -5, 40, 40)) == doctest::Approx(800.0));
}

TEST_CASE("boxes of lots may overlap where lots do not") {
	const std::vector<Loops2> triangles{ Loops2{ Loop2{ { 0, 0 }, { 10, 0 }, { 0, 10 } } }, Loops2{ Loop2{ { 10, 0 }, { 10, 10 }, { 0, 10 } } } };
	CHECK(find_overlaps(triangles).empty());
}

TEST_CASE("what is found agrees with every pair for itself") {
	for (uint64_t seed = 1; seed <= 100; ++seed) {
		Random random(seed);
		std::vector<Loops2> outlines;
		for (int i = 0; i < 30; ++i) {
			outlines.push_back(box(random.uniform(0, 60), random.uniform(0, 60), random.uniform(2, 12), random.uniform(2, 12)));
		}
		size_t expected = 0;
		for (size_t i = 0; i < outlines.size(); ++i) {
			for (size_t j = i + 1; j < outlines.size(); ++j) {
				const glm::dvec2 low{ std::max(outlines[i][0][0].x, outlines[j][0][0].x), std::max(outlines[i][0][0].y, outlines[j][0][0].y) };
				const glm::dvec2 high{ std::min(outlines[i][0][2].x, outlines[j][0][2].x), std::min(outlines[i][0][2].y, outlines[j][0][2].y) };
				expected += high.x > low.x && high.y > low.y && (high.x - low.x) * (high.y - low.y) > 1.0 ? 1 : 0;
			}
		}
		CHECK(find_overlaps(outlines).size() == expected);
	}
}

TEST_CASE("no lots of a layout overlap") {
	for (LayoutKind kind : { LayoutKind::Grid, LayoutKind::Radial, LayoutKind::Grown }) {
		LayoutParameters parameters = layout_for_lots(200);
		parameters.kind = kind;
		Diagnostics diagnostics;
		std::vector<Loops2> outlines;
		const std::optional<Layout> layout = make_layout(parameters, diagnostics);
		REQUIRE(layout);
		for (const Lot &lot : layout->lots) {
			outlines.push_back({ to_plan(lot.polygon) });
		}
		CHECK(find_overlaps(outlines, {}, 0.1).empty());
	}
}
