#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "core/base/random.h"
#include "core/city/footprint_layout.h"

using namespace pcg;

namespace {

Footprint box(double x0, double y0, double x1, double y1, const std::string &name = "feature 0") {
	Footprint footprint;
	footprint.outline = { { x0, y0 }, { x1, y0 }, { x1, y1 }, { x0, y1 } };
	footprint.name = name;
	return footprint;
}

// Of the plan, doubled; positive for counter-clockwise seen from above.
double area(const std::vector<glm::vec3> &polygon) {
	double sum = 0.0;
	for (size_t i = 0; i < polygon.size(); ++i) {
		const glm::dvec3 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
		sum += (a.x * -b.z - b.x * -a.z) / 2.0;
	}
	return sum;
}

LayoutParameters parameters() {
	LayoutParameters p;
	p.street_width = 8.0f;
	p.pavement_width = 2.0f;
	p.land_use = { { "house", 1.0 }, { "school", 0.0 } };
	return p;
}

Layout make(const std::vector<Footprint> &footprints, size_t warnings = 0) {
	Diagnostics diagnostics;
	std::optional<Layout> layout = layout_of_footprints(footprints, parameters(), diagnostics);
	CHECK(diagnostics.warning_count() == warnings);
	REQUIRE(layout.has_value());
	return std::move(*layout);
}

std::string refused(const std::vector<Footprint> &footprints) {
	Diagnostics diagnostics;
	CHECK_FALSE(layout_of_footprints(footprints, parameters(), diagnostics).has_value());
	return diagnostics.is_empty() ? std::string() : diagnostics.list()[0].message;
}

} // namespace

TEST_CASE("a footprint is a lot whose front is its longest open side, with open ground around") {
	const Layout layout = make({ box(0, 0, 10, 20) });
	REQUIRE(layout.lots.size() == 1);
	CHECK(layout.lots[0].type == "house");
	CHECK(layout.lots[0].polygon == std::vector<glm::vec3>{ { 10, 0, 0 }, { 10, 0, -20 }, { 0, 0, -20 }, { 0, 0, 0 } });
	CHECK(layout.lots[0].street_widths == std::vector<float>{ 8, 8, 8, 8 });
	CHECK(layout.min == glm::vec3(-10, 0, -30)); // pavement and street beyond
	CHECK(layout.max == glm::vec3(20, 0, 10));
	double open = 0.0;
	for (const Ground &ground : layout.ground) {
		open += area(ground.polygon);
	}
	CHECK(open == doctest::Approx(30.0 * 40.0 - 200.0));
}

TEST_CASE("walls that neighbours share lie on no street; types and heights are kept") {
	Footprint school = box(10, 0, 20, 12, "feature 1");
	school.type = "school";
	school.height = 9.0f;
	Footprint church = box(20, 0, 30, 12, "feature 2");
	church.type = "church"; // for which there are no rules
	const Layout layout = make({ box(0, 0, 10, 12), school, church });
	CHECK(layout.lots[1].type == "school");
	CHECK(layout.lots[1].height == 9.0f);
	CHECK(layout.lots[1].street_widths == std::vector<float>{ 8, 0, 8, 0 });
	CHECK(layout.lots[2].type == "house");
}

TEST_CASE("many footprints and their open ground cover the map") {
	Random random(5);
	std::vector<Footprint> footprints;
	double built = 0.0;
	for (int i = 0; i < 400; ++i) { // one to a square of 30 m
		const double x = 30.0 * (i % 20), y = 30.0 * (i / 20), width = random.uniform(5, 25), depth = random.uniform(5, 25);
		footprints.push_back(box(x, y, x + width, y + depth));
		built += width * depth;
	}
	const Layout layout = make(footprints);
	double open = 0.0;
	for (const Ground &ground : layout.ground) {
		open += area(ground.polygon);
	}
	CHECK(open + built == doctest::Approx(area(layout.outline)).epsilon(1e-4));
	CHECK(std::all_of(layout.lots.begin(), layout.lots.end(), [](const Lot &lot) { return lot.street_widths[0] > 0.0f; }));
}

TEST_CASE("footprints that overlap are warned of by name, and what cannot be built is refused") {
	const Layout layout = make({ box(0, 0, 10, 10), box(5, 5, 15, 15, "feature 1") }, 1);
	REQUIRE(layout.overlaps.size() == 1);
	CHECK(layout.overlaps[0].b == LotId(1));
	CHECK(layout.overlaps[0].area == doctest::Approx(25.0));
	CHECK(refused({}).find("no footprints") != std::string::npos);
	CHECK(refused({ box(0, 0, 0.5, 0.5) }) == "feature 0: its outline has less than 1 square metre");
	CHECK(refused({ box(0, 0, 1e6, 10) }).find("50 km") != std::string::npos);
	CHECK(refused({ box(0, 0, 10, 10), box(20'000, 15'000, 20'010, 15'010) }).find("20 by 15 km") != std::string::npos);
	Footprint bow = box(0, 0, 10, 10);
	bow.outline = { { 0, 0 }, { 20, 0 }, { 20, 20 }, { 10, -5 } };
	CHECK(refused({ bow }).find("crosses itself") != std::string::npos);
	const std::vector<Footprint> ring = { box(10, 10, 20, 20, "feature 7"), box(0, 0, 30, 10), box(0, 20, 30, 30), box(0, 10, 10, 20), box(20, 10, 30, 20) };
	CHECK(refused(ring).find("feature 7: it is walled in") != std::string::npos);
}

TEST_CASE("heights that are none are told by name and ignored, corners that are nowhere are refused") {
	constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
	for (const float height : { nan, inf, -inf, -1.0f, 1e30f, 2000.5f }) {
		Footprint tower = box(0, 0, 10, 10, "the tower");
		tower.height = height;
		Diagnostics diagnostics;
		const std::optional<Layout> layout = layout_of_footprints({ tower, box(20, 0, 30, 10) }, parameters(), diagnostics);
		REQUIRE(layout.has_value());
		CHECK(layout->lots[0].height == 0.0f);
		REQUIRE(diagnostics.list().size() == 1);
		CHECK(diagnostics.list()[0].severity == Severity::Warning);
		CHECK(diagnostics.list()[0].message == "the tower: its height is none from 0 to 2000 m and is ignored");
	}
	Footprint tall = box(0, 0, 10, 10);
	tall.height = tallest_footprint;
	CHECK(make({ tall }).lots[0].height == 2000.0f);
	for (const double place : { double(nan), double(inf), -double(inf) }) {
		Footprint broken = box(0, 0, 10, 10, "the broken one"), holed = box(0, 0, 40, 40, "the holed one");
		broken.outline[2].y = place;
		holed.holes = { box(10, 10, 20, 20).outline };
		holed.holes[0][1].x = place;
		CHECK(refused({ broken }) == "the broken one: its outline has a corner that is nowhere: its coordinates are not finite numbers");
		CHECK(refused({ holed }) == "the holed one: a hole in it has a corner that is nowhere: its coordinates are not finite numbers");
	}
}

TEST_CASE("a hole is a courtyard of its lot, and what stands in it is a lot within") {
	Footprint ring = box(0, 0, 40, 40, "the ring");
	ring.holes = { box(10, 10, 30, 30).outline };
	const Layout layout = make({ ring, box(14, 14, 20, 20), box(22, 14, 28, 20), box(60, 0, 70, 10) });
	REQUIRE(layout.lots.size() == 4);
	REQUIRE(layout.lots[0].holes.size() == 1);
	CHECK(area(layout.lots[0].holes[0]) == doctest::Approx(400.0)); // counter-clockwise
	CHECK(layout.lots[0].around == LotId::Invalid);
	CHECK(layout.lots[1].around == LotId(0));
	CHECK(layout.lots[2].around == LotId(0));
	CHECK(layout.lots[3].around == LotId::Invalid);
	CHECK(lots_within(layout, LotId(0)) == std::vector<std::vector<glm::vec3>>{ layout.lots[1].polygon, layout.lots[2].polygon });
	CHECK(lots_within(layout, LotId(3)).empty());
	CHECK(layout.lots[1].street_widths == std::vector<float>(4, 8.0f)); // the courtyard is open ground
	double open = 0.0; // none in the courtyard: that belongs to the ring
	for (const Ground &ground : layout.ground) {
		open += area(ground.polygon);
	}
	CHECK(open + 1600.0 + 100.0 == doctest::Approx(area(layout.outline)).epsilon(1e-5));
}

TEST_CASE("of rings within rings each lot knows the nearest around it") {
	Footprint outer = box(0, 0, 80, 80), inner = box(20, 20, 60, 60);
	outer.holes = { box(10, 10, 70, 70).outline };
	inner.holes = { box(30, 30, 50, 50).outline };
	const Layout layout = make({ box(35, 35, 45, 45), inner, outer });
	CHECK(layout.lots[0].around == LotId(1));
	CHECK(layout.lots[1].around == LotId(2));
	CHECK(lots_around(layout, LotId(0)) == std::vector<LotId>{ LotId(1), LotId(2) });
	CHECK(lots_around(layout, LotId(2)).empty());
	const Layout twice = make({ outer, outer }, 1);
	CHECK(twice.lots[0].around == LotId::Invalid);
	CHECK(twice.lots[1].around == LotId::Invalid);
}

TEST_CASE("holes that cannot be are refused by the name of their footprint, and overlaps count without courtyards") {
	const auto with_holes = [](const std::vector<Loop2> &holes) {
		Footprint ring = box(0, 0, 40, 40, "the ring");
		ring.holes = holes;
		return ring;
	};
	const Loop2 good = box(10, 10, 20, 20).outline;
	for (const Loop2 &bad : { box(30, 10, 50, 20).outline, box(50, 10, 60, 20).outline, box(15, 15, 25, 25).outline, box(0, 10, 5, 20).outline, box(12, 12, 14, 14).outline }) {
		CHECK(refused({ with_holes({ good, bad }) }) == "the ring: a hole in it meets its outline or another hole, or lies outside");
	}
	CHECK(refused({ with_holes({ { { 10, 10 }, { 30, 10 }, { 30, 30 }, { 20, 5 } } }) }) == "the ring: a hole in it crosses itself");
	CHECK(refused({ with_holes({ box(10, 10, 10.5, 10.5).outline }) }) == "the ring: a hole in it has less than 1 square metre");
	const Layout layout = make({ with_holes({ good }), box(15, 12, 25, 18, "over the edge") }, 1);
	REQUIRE(layout.overlaps.size() == 1);
	CHECK(layout.overlaps[0].area == doctest::Approx(30.0));
}

TEST_CASE("a courtyard between several footprints is no street: fronts look out, but for what stands in it") {
	const auto around = [](double gap) {
		return std::vector<Footprint>{ box(0, 10 + gap, 10, 30), box(0, 0, 50, 10), box(40, 10, 50, 30), box(0, 30, 50, 40), box(20, 15, 30, 25) };
	};
	const Layout closed = make(around(0));
	CHECK(closed.lots[0].polygon[0].x == 0.0f); // the western side, though that to the courtyard is as long
	CHECK(closed.lots[0].polygon[1].x == 0.0f);
	CHECK(std::ranges::count(closed.lots[0].street_widths, 8.0f) == 1);
	CHECK(std::ranges::count(closed.lots[1].street_widths, 8.0f) == 3);
	CHECK(closed.lots[4].street_widths == std::vector<float>(4, 8.0f));
	CHECK(std::ranges::count(make(around(1)).lots[0].street_widths, 8.0f) == 3); // and the side in the gap
	CHECK(std::ranges::count(make(around(0.4)).lots[0].street_widths, 8.0f) == 1); // too narrow: nobody gets through
}
