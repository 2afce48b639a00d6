#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "core/base/random.h"
#include "core/city/drawn_blocks.h"
#include "core/city/lot_overlaps.h"
#include "core/city/plan_layout.h"
#include "core/geometry/polygon.h"

using namespace pcg;

namespace {

Footprint block(Loop2 outline, const std::string &name = "block 0") {
	Footprint footprint;
	footprint.outline = std::move(outline);
	footprint.name = name;
	return footprint;
}

Footprint box(double x0, double y0, double x1, double y1, const std::string &name = "block 0") {
	return block({ { x0, y0 }, { x1, y0 }, { x1, y1 }, { x0, y1 } }, name);
}

LayoutParameters parameters() {
	LayoutParameters p;
	p.lot_front = 20.0f;
	p.street_width = 8.0f;
	p.pavement_width = 3.0f;
	p.land_use = { { "house", 1.0 }, { "school", 0.0 } };
	return p;
}

Layout make(const std::vector<Footprint> &blocks, const LayoutParameters &p = parameters(), size_t warnings = 0) {
	Diagnostics diagnostics;
	std::optional<Layout> layout = layout_of_blocks(blocks, p, diagnostics);
	CHECK(diagnostics.warning_count() == warnings);
	REQUIRE(layout.has_value());
	return std::move(*layout);
}

std::string refused(const std::vector<Footprint> &blocks, const LayoutParameters &p = parameters()) {
	Diagnostics diagnostics;
	CHECK_FALSE(layout_of_blocks(blocks, p, diagnostics).has_value());
	return diagnostics.is_empty() ? std::string() : diagnostics.list()[0].message;
}

double area(const std::vector<glm::vec3> &polygon) { return signed_area(to_plan(polygon)) / 2.0; }

// Every edge of a lot that lies on a pavement knows the width of its street, and the first is one.
bool has_fronts(const Layout &layout, const Lot &lot) {
	if (lot.street_widths.size() != lot.polygon.size() || !(lot.street_widths[0] > 0.0f)) {
		return false;
	}
	const Loop2 outline = to_plan(lot.polygon);
	for (size_t i = 0; i < outline.size(); ++i) {
		const glm::dvec2 a = outline[i], b = outline[(i + 1) % outline.size()], along = glm::normalize(b - a);
		const glm::dvec2 outside = (a + b) / 2.0 + glm::dvec2(along.y, -along.x) * 0.02;
		float width = 0.0f;
		for (const uint32_t piece : layout.block(lot.block).pavements) {
			const Ground &ground = layout.ground[piece];
			if (ground.street != no_street && contains(to_plan(ground.polygon), outside)) {
				width = layout.streets[ground.street].width;
			}
		}
		if (width != lot.street_widths[i]) {
			return false;
		}
	}
	return true;
}

// Lots and ground cover the map once, and every lot has a front.
void check_layout(const Layout &layout) {
	std::vector<Loop2> pieces;
	double sum = 0.0;
	for (const Lot &lot : layout.lots) {
		pieces.push_back(to_plan(lot.polygon));
		CHECK_FALSE(is_self_intersecting(pieces.back()));
	}
	for (const Ground &ground : layout.ground) {
		pieces.push_back(to_plan(ground.polygon));
	}
	std::vector<Loops2> polygons;
	for (const Loop2 &piece : pieces) {
		CHECK(signed_area(piece) > 0.0);
		polygons.push_back({ piece });
		sum += signed_area(piece) / 2.0;
	}
	CHECK(sum == doctest::Approx(area(layout.outline)).epsilon(1e-5));
	CHECK(find_overlaps(polygons, {}, 0.02).empty()); // coordinates are floats
	CHECK(std::ranges::all_of(layout.lots, [&](const Lot &lot) { return has_fronts(layout, lot); }));
}

// Of all sizes and shapes, within 60 m of `middle`: stars, combs, rings that are open, curves of many corners, strips.
Loop2 random_outline(glm::dvec2 middle, Random &random) {
	Loop2 outline;
	const double size = random.uniform(8.0, 60.0);
	switch (random.index(4)) {
		case 0: { // a star with inner corners
			const size_t count = 3 + random.index(10);
			for (size_t i = 0; i < count; ++i) {
				const double angle = 2.0 * std::numbers::pi * (double(i) + random.uniform(0.0, 0.7)) / double(count);
				outline.push_back(glm::dvec2(std::cos(angle), std::sin(angle)) * size * random.uniform(0.3, 1.0));
			}
			break;
		}
		case 1: { // a curve
			const double flat = random.uniform(0.3, 1.0), wave = random.uniform(0.0, 0.2), waves = double(2 + random.index(4));
			for (size_t i = 0; i < 120; ++i) {
				const double angle = 2.0 * std::numbers::pi * double(i) / 120.0, radius = size * (0.8 + wave * std::cos(waves * angle));
				outline.push_back(glm::dvec2(std::cos(angle), flat * std::sin(angle)) * radius);
			}
			break;
		}
		case 2: { // an L, U or T
			const double a = random.uniform(-0.6, -0.2) * size, b = random.uniform(0.2, 0.6) * size, c = random.uniform(-0.5, 0.9) * size;
			const double left = random.uniform(-0.6, 1.0) * size;
			outline = { { -size, -size }, { size, -size }, { size, size }, { b, size }, { b, c }, { a, c }, { a, left }, { -size, left } };
			if (left <= c) {
				outline = { { -size, -size }, { size, -size }, { size, size }, { b, size }, { b, c }, { -size, c } };
			}
			break;
		}
		default: { // a strip or box, turned
			const double depth = size * random.uniform(0.1, 1.0) * 0.7, turn = random.uniform(0.0, 3.0), width = 0.7 * size;
			const glm::dvec2 u{ std::cos(turn), std::sin(turn) }, v{ -u.y, u.x };
			outline = { u * -width - v * depth, u * width - v * depth, u * width + v * depth, u * -width + v * depth };
		}
	}
	for (glm::dvec2 &corner : outline) {
		corner += middle;
	}
	return outline;
}

} // namespace

TEST_CASE("a block that was drawn is divided as those of other layouts are") {
	// 4 x 20 + 2 x 3 m wide, 2 x 20 + 6 deep.
	const Layout layout = make({ box(0, 0, 86, 46) });
	check_layout(layout);
	REQUIRE(layout.lots.size() == 8);
	for (const Lot &lot : layout.lots) {
		CHECK(area(lot.polygon) == doctest::Approx(400.0));
	}
	CHECK(std::ranges::count_if(layout.lots, [](const Lot &lot) { return std::ranges::count(lot.street_widths, 8.0f) == 2; }) == 4); // at corners
	CHECK(layout.blocks[0].outline == std::vector<glm::vec3>{ { 0, 0, 0 }, { 86, 0, 0 }, { 86, 0, -46 }, { 0, 0, -46 } });
	CHECK(layout.min == glm::vec3(-8, 0, -54));
	CHECK(layout.max == glm::vec3(94, 0, 8));
	CHECK(layout.lots[0].type == "house");
}

TEST_CASE("lots have their block's type and height, and streets are as wide as what lies between two blocks") {
	Footprint school = box(96, 0, 182, 46, "block 1");
	school.type = "school";
	school.height = 9.0f;
	const Layout layout = make({ box(0, 0, 86, 46), school });
	check_layout(layout);
	REQUIRE(layout.lots.size() == 16);
	for (const Lot &lot : layout.lots) {
		const bool is_school = index_of(lot.block) == 1;
		CHECK(lot.type == (is_school ? "school" : "house"));
		CHECK(lot.height == (is_school ? 9.0f : 0.0f));
		const bool is_between = std::ranges::any_of(lot.polygon, [](glm::vec3 corner) { return corner.x == 83.0f || corner.x == 99.0f; });
		CHECK(std::ranges::count(lot.street_widths, 10.0f) == (is_between ? 1 : 0));
	}
}

TEST_CASE("a block's height that is none is told and ignored") {
	Footprint tower = box(0, 0, 86, 46, "the tower");
	tower.height = INFINITY;
	Diagnostics diagnostics;
	const std::optional<Layout> layout = layout_of_blocks({ tower }, parameters(), diagnostics);
	REQUIRE(layout.has_value());
	CHECK(layout->lots[0].height == 0.0f);
	REQUIRE(diagnostics.list().size() == 1);
	CHECK(diagnostics.list()[0].message == "the tower: its height is none from 0 to 2000 m and is ignored");
}

TEST_CASE("curves have few corners, so that their lots have fronts") {
	Loop2 circle;
	for (size_t i = 0; i < 200; ++i) {
		const double angle = 2.0 * std::numbers::pi * double(i) / 200.0;
		circle.push_back({ 50.0 * std::cos(angle), 50.0 * std::sin(angle) });
	}
	const Layout layout = make({ block(circle) });
	check_layout(layout);
	CHECK(layout.lots.size() >= 6); // of 400 square metres; the circle of 47 m has 6,940
	CHECK(layout.blocks[0].outline.size() <= 24);
}

TEST_CASE("a thousand maps of random blocks: lots and ground cover each once, and every lot has a front") {
	size_t lots = 0, paved = 0;
	std::vector<uint64_t> seeds{ 1536, 7294, 8135, 9558, 19023, 20468 }; // in these a cut along a side would leave a needle between lot and street
	for (uint64_t seed = 0; seed < 1000; ++seed) {
		seeds.push_back(seed);
	}
	for (const uint64_t seed : seeds) {
		CAPTURE(seed);
		Random random(seed);
		std::vector<Footprint> blocks;
		const size_t count = 1 + random.index(4);
		for (size_t i = 0; i < count; ++i) {
			blocks.push_back(block(random_outline({ 125.0 * double(i % 2), 125.0 * double(i / 2) }, random), "block " + std::to_string(i)));
		}
		LayoutParameters p = parameters();
		p.lot_front = float(random.uniform(8.0, 30.0));
		p.lot_aspect = float(random.uniform(0.5, 2.0));
		p.pavement_width = float(random.uniform(0.5, 5.0));
		p.jitter = float(random.uniform(0.0, 0.25));
		p.seed = seed;
		Diagnostics diagnostics;
		const std::optional<Layout> layout = layout_of_blocks(blocks, p, diagnostics);
		if (!layout) {
			CHECK(diagnostics.list()[0].id == "no-room");
			continue;
		}
		check_layout(*layout);
		lots += layout->lots.size();
		paved += size_t(std::ranges::count_if(layout->blocks, [](const CityBlock &one) { return one.lots.empty(); }));
	}
	CHECK(lots > 10'000);
	CHECK(paved > 0);
}

TEST_CASE("a yard in a block is open ground with a passage to the street, and no lot lies over it") {
	Footprint ring = box(0, 0, 106, 86);
	ring.holes = { box(43, 33, 63, 53).outline };
	const Layout layout = make({ ring });
	check_layout(layout);
	CHECK(layout.lots.size() >= 10);
	double lots = 0.0, yard = 0.0;
	for (const Lot &lot : layout.lots) {
		lots += area(lot.polygon);
	}
	for (const Ground &ground : layout.ground) {
		yard += ground.street == no_street && ground.kind == GroundKind::Pavement ? area(ground.polygon) : 0.0;
	}
	CHECK(yard == doctest::Approx(20.0 * 20.0 + 3.0 * 30.0)); // as wide as the pavement, from the yard to where that begins
	CHECK(lots + yard == doctest::Approx(100.0 * 80.0));
}

TEST_CASE("a block in the yard of another has its own pavement, and the yard is around it") {
	Footprint ring = box(0, 0, 200, 200), school = box(70, 70, 130, 130, "block 1");
	ring.holes = { box(60, 60, 140, 140).outline };
	school.type = "school";
	const Layout layout = make({ ring, school });
	check_layout(layout);
	for (const LotId lot : layout.blocks[1].lots) {
		CHECK(layout.lot(lot).type == "school");
		CHECK(layout.lot(lot).street_widths[0] == doctest::Approx(10.0)); // as far as the yard's side
	}
	CHECK(layout.blocks[1].lots.size() >= 4);
}

TEST_CASE("five hundred blocks with random yards: lots and ground cover each once, and every lot has a front") {
	size_t lots = 0, yards = 0;
	for (uint64_t seed = 0; seed < 500; ++seed) {
		CAPTURE(seed);
		Random random(seed);
		std::vector<Footprint> blocks{ block(random_outline({ 0, 0 }, random)) };
		for (size_t i = 0; i < 1 + random.index(2); ++i) {
			Loop2 hole = random_outline({ 0, 0 }, random);
			const double size = random.uniform(0.1, 0.6);
			const glm::dvec2 middle{ random.uniform(-25.0, 25.0), random.uniform(-25.0, 25.0) };
			for (glm::dvec2 &corner : hole) {
				corner = middle + corner * size;
			}
			blocks[0].holes.push_back(std::move(hole));
		}
		LayoutParameters p = parameters();
		p.lot_front = float(random.uniform(6.0, 20.0));
		p.pavement_width = float(random.uniform(0.5, 4.0));
		p.seed = seed;
		Diagnostics diagnostics;
		const std::optional<Layout> layout = layout_of_blocks(blocks, p, diagnostics);
		if (!layout) {
			const std::string message = diagnostics.list()[0].message;
			CHECK((message.find("a hole in it") != std::string::npos || message.find("no block has room") != std::string::npos));
			continue;
		}
		check_layout(*layout);
		for (const Loop2 &hole : blocks[0].holes) {
			for (const Lot &lot : layout->lots) {
				CHECK(shared_area({ hole }, { to_plan(lot.polygon) }) < 0.05 * double(p.lot_front) * double(p.lot_front)); // yards get fewer corners, too
			}
		}
		lots += layout->lots.size();
		yards += blocks[0].holes.size();
	}
	CHECK(lots > 1000);
	CHECK(yards > 100);
}

TEST_CASE("blocks without room are told by name, and what makes no city is refused") {
	make({ box(0, 0, 86, 46), box(100, 0, 106, 66, "the verge") }, parameters(), 1);
	CHECK(refused({ box(0, 0, 6, 66, "the verge") }) == "no block has room for a lot: the verge");
	CHECK(refused({}).find("no footprints") != std::string::npos);
	CHECK(refused({ block({ { 0, 0 }, { 20, 0 }, { 20, 20 }, { 10, -5 } }, "bow") }).find("bow: its outline crosses itself") != std::string::npos);
	LayoutParameters p = parameters();
	p.lot_front = 0.0f;
	CHECK(refused({ box(0, 0, 86, 46) }, p).find("front of a lot") != std::string::npos);
	p.lot_front = 5.0f;
	p.lot_aspect = 0.25f;
	CHECK(refused({ box(0, 0, 14'000, 14'000) }, p).find("more than 2000000 lots") != std::string::npos);
}

TEST_CASE("blocks that were drawn over each other are warned of, and so are their lots") {
	const Layout layout = make({ box(0, 0, 86, 46), box(76, 0, 162, 46, "block 1") }, parameters(), 1);
	CHECK(layout.overlaps.size() == 2); // of each row one pair, 4 m deep
	for (const LotOverlap &overlap : layout.overlaps) {
		CHECK(overlap.area == doctest::Approx(4.0 * 20.0));
	}
}
