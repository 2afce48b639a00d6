#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/base/random.h"
#include "core/city/layout.h"

using namespace pcg;

namespace {

struct Bounds {
	float x0, z0, x1, z1;
};

Bounds bounds_of(const std::vector<glm::vec3> &polygon) {
	Bounds b{ INFINITY, INFINITY, -INFINITY, -INFINITY };
	for (const glm::vec3 &corner : polygon) {
		b = { std::fmin(b.x0, corner.x), std::fmin(b.z0, corner.z), std::fmax(b.x1, corner.x), std::fmax(b.z1, corner.z) };
	}
	return b;
}

// Positive for counter-clockwise seen from above: -z is up on the map.
double signed_area(const std::vector<glm::vec3> &polygon) {
	double sum = 0.0;
	for (size_t i = 0; i < polygon.size(); ++i) {
		const glm::vec3 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
		sum += double(a.x) * -b.z - double(b.x) * -a.z;
	}
	return sum / 2.0;
}

bool overlap(const Bounds &a, const Bounds &b) {
	const float slack = 0.01f;
	return a.x0 < b.x1 - slack && b.x0 < a.x1 - slack && a.z0 < b.z1 - slack && b.z0 < a.z1 - slack;
}

std::vector<std::vector<glm::vec3>> all_polygons(const Layout &layout) {
	std::vector<std::vector<glm::vec3>> polygons;
	for (const Lot &lot : layout.lots) {
		polygons.push_back(lot.polygon);
	}
	for (const Ground &ground : layout.ground) {
		polygons.push_back(ground.polygon);
	}
	return polygons;
}

bool lies_on_pavement(const Layout &layout, BlockId block, glm::vec3 point) {
	return std::any_of(layout.ground.begin(), layout.ground.end(), [&](const Ground &ground) {
		const Bounds b = bounds_of(ground.polygon);
		return ground.kind == GroundKind::Pavement && ground.block == block && point.x > b.x0 && point.x < b.x1 && point.z > b.z0 &&
				point.z < b.z1;
	});
}

LayoutParameters random_parameters(uint64_t seed) {
	Random random(seed);
	LayoutParameters p;
	p.blocks_x = 1 + uint32_t(random.index(4));
	p.blocks_z = 1 + uint32_t(random.index(4));
	p.lots_along = 1 + uint32_t(random.index(6));
	p.lots_deep = 1 + uint32_t(random.index(2));
	p.lot_front = float(random.uniform(5.0, 60.0));
	p.lot_aspect = float(random.uniform(0.25, 4.0));
	p.street_width = float(random.uniform(2.0, 20.0));
	p.pavement_width = float(random.uniform(0.5, 6.0));
	p.seed = seed;
	return p;
}

Layout make(const LayoutParameters &parameters) {
	Diagnostics diagnostics;
	std::optional<Layout> layout = make_layout(parameters, diagnostics);
	REQUIRE(layout.has_value());
	CHECK(diagnostics.error_count() == 0);
	return std::move(*layout);
}

} // namespace

TEST_CASE("one block of two rows lies where its measures say") {
	LayoutParameters p;
	p.blocks_x = p.blocks_z = 1;
	p.lots_along = 2;
	p.lot_front = 20.0f;
	p.lot_aspect = 1.5f;
	p.street_width = 8.0f;
	p.pavement_width = 3.0f;
	const Layout layout = make(p);
	// 2 x 20 + 2 x 3 + 2 x 8 wide, 2 x 30 + 6 + 16 deep, the middle at the origin.
	CHECK(layout.max == glm::vec3(31, 0, 41));
	CHECK(layout.min == glm::vec3(-31, 0, -41));
	REQUIRE(layout.lots.size() == 4);
	// The south-western lot looks south, the one behind it north.
	CHECK(layout.lots[0].polygon == std::vector<glm::vec3>{ { -20, 0, 30 }, { 0, 0, 30 }, { 0, 0, 0 }, { -20, 0, 0 } });
	CHECK(layout.lots[0].street_widths == std::vector<float>{ 8, 0, 0, 8 });
	CHECK(layout.lots[2].polygon == std::vector<glm::vec3>{ { 0, 0, -30 }, { -20, 0, -30 }, { -20, 0, 0 }, { 0, 0, 0 } });
	CHECK(layout.lots[2].street_widths == std::vector<float>{ 8, 8, 0, 0 });
	CHECK(layout.blocks[0].cell_min == layout.min);
	CHECK(layout.blocks[0].cell_max == layout.max);
}

TEST_CASE("lots and public ground cover the city without gaps or overlaps, whatever the measures") {
	for (uint64_t seed = 0; seed < 60; ++seed) {
		CAPTURE(seed);
		const Layout layout = make(random_parameters(seed));
		const std::vector<std::vector<glm::vec3>> polygons = all_polygons(layout);
		double sum = 0.0;
		bool is_disjoint = true;
		for (size_t i = 0; i < polygons.size(); ++i) {
			sum += signed_area(polygons[i]);
			CHECK(signed_area(polygons[i]) > 0.0);
			for (size_t j = 0; j < i; ++j) {
				is_disjoint = is_disjoint && !overlap(bounds_of(polygons[i]), bounds_of(polygons[j]));
			}
		}
		CHECK(is_disjoint);
		const glm::vec3 size = layout.max - layout.min;
		CHECK(sum == doctest::Approx(double(size.x) * size.z).epsilon(1e-4));
	}
}

TEST_CASE("every lot has its front and its other street edges on a pavement of its block, and no others") {
	for (uint64_t seed = 0; seed < 200; ++seed) {
		CAPTURE(seed);
		const Layout layout = make(random_parameters(seed));
		bool is_good = true;
		for (const Lot &lot : layout.lots) {
			is_good = is_good && lot.street_widths[0] > 0.0f;
			for (size_t edge = 0; edge < lot.polygon.size(); ++edge) {
				const glm::vec3 a = lot.polygon[edge], b = lot.polygon[(edge + 1) % lot.polygon.size()];
				// Outwards of a counter-clockwise edge: right of its direction.
				const glm::vec3 along = glm::normalize(b - a);
				const glm::vec3 outside = (a + b) / 2.0f + 0.1f * glm::vec3(-along.z, 0.0f, along.x);
				is_good = is_good && lies_on_pavement(layout, lot.block, outside) == (lot.street_widths[edge] > 0.0f);
			}
		}
		CHECK(is_good);
	}
}

TEST_CASE("the cells of the blocks tile the city") {
	for (uint64_t seed = 0; seed < 50; ++seed) {
		const Layout layout = make(random_parameters(seed));
		double sum = 0.0;
		for (const CityBlock &block : layout.blocks) {
			sum += double(block.cell_max.x - block.cell_min.x) * (block.cell_max.z - block.cell_min.z);
		}
		const glm::vec3 size = layout.max - layout.min;
		CHECK(sum == doctest::Approx(double(size.x) * size.z).epsilon(1e-4));
	}
}

TEST_CASE("one seed makes one city, and lots keep their seeds when the city grows") {
	LayoutParameters p;
	const Layout a = make(p), b = make(p);
	CHECK(std::equal(a.lots.begin(), a.lots.end(), b.lots.begin(),
			[](const Lot &x, const Lot &y) { return x.type == y.type && x.seed == y.seed && x.polygon == y.polygon; }));
	p.blocks_z += 1;
	CHECK(make(p).lots[17].seed == a.lots[17].seed);
	p.seed = 2;
	CHECK(make(p).lots[17].seed != a.lots[17].seed);
}

TEST_CASE("parameters out of their limits are errors that name them") {
	const auto refused = [](auto change) {
		LayoutParameters p;
		change(p);
		Diagnostics diagnostics;
		CHECK_FALSE(make_layout(p, diagnostics).has_value());
		CHECK(diagnostics.error_count() >= 1);
		return diagnostics.list().empty() ? std::string() : diagnostics.list()[0].message;
	};
	CHECK(refused([](LayoutParameters &p) { p.blocks_x = 0; }).find("number of blocks in x is 0") != std::string::npos);
	CHECK(refused([](LayoutParameters &p) { p.lots_deep = 3; }).find("from 1 to 2") != std::string::npos);
	refused([](LayoutParameters &p) { p.lots_along = 0; });
	refused([](LayoutParameters &p) { p.lot_front = NAN; });
	refused([](LayoutParameters &p) { p.lot_aspect = -1.0f; });
	refused([](LayoutParameters &p) { p.street_width = INFINITY; });
	refused([](LayoutParameters &p) { p.pavement_width = 0.0f; });
	refused([](LayoutParameters &p) { p.blocks_x = p.blocks_z = 1000, p.lots_along = 100; });
	refused([](LayoutParameters &p) { p.land_use.clear(); });
	refused([](LayoutParameters &p) { p.land_use = { { "house", -1.0 } }; });
	refused([](LayoutParameters &p) { p.land_use = { { "house", 0.0 } }; });
	refused([](LayoutParameters &p) { p.land_use = { { "", 1.0 } }; });
	refused([](LayoutParameters &p) { p = layout_for_lots(0); });
}

TEST_CASE("a wanted number of lots is met exactly when small, closely when large, and the city is squarish") {
	for (uint32_t count = 1; count <= 20; ++count) {
		CHECK(make(layout_for_lots(count)).lots.size() == count);
	}
	for (uint32_t count : { 50u, 300u, 1000u, 5000u }) {
		CAPTURE(count);
		const Layout layout = make(layout_for_lots(count));
		CHECK(std::abs(double(layout.lots.size()) - count) <= 0.05 * count);
		const glm::vec3 size = layout.max - layout.min;
		CHECK(size.x / size.z < 2.5f);
		CHECK(size.z / size.x < 2.5f);
	}
	CHECK(make(layout_for_lots(300)).lots.size() == 300);
}

TEST_CASE("a lot's name says its number and what it is") {
	LayoutParameters p = layout_for_lots(1);
	p.land_use = { { "school", 1.0 } };
	CHECK(lot_name(make(p), LotId(0)) == "lot 0 (school)");
}
