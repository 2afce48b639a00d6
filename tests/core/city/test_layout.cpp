#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/base/random.h"
#include "core/city/layout.h"

using namespace pcg;

namespace {

using Polygon = std::vector<glm::vec3>;

// Positive for counter-clockwise seen from above: -z is up on the map.
double signed_area(const Polygon &polygon) {
	double sum = 0.0;
	for (size_t i = 0; i < polygon.size(); ++i) {
		const glm::dvec3 a = polygon[i] - polygon[0], b = polygon[(i + 1) % polygon.size()] - polygon[0];
		sum += a.x * -b.z - b.x * -a.z;
	}
	return sum / 2.0;
}

// How far `point` lies to the left of the edge.
double leftness(glm::vec3 a, glm::vec3 b, glm::vec3 point) {
	const glm::dvec3 along = glm::dvec3(b) - glm::dvec3(a), to = glm::dvec3(point) - glm::dvec3(a);
	return (along.x * -to.z - to.x * -along.z) / std::hypot(along.x, along.z);
}

// Coordinates are floats: the direction of a short edge is known only so well.
bool is_convex(const Polygon &polygon) {
	constexpr float rounding = 5e-5f;
	const size_t count = polygon.size();
	for (size_t i = 0; i < count; ++i) {
		const glm::vec3 a = polygon[i], b = polygon[(i + 1) % count], c = polygon[(i + 2) % count];
		if (leftness(a, b, c) < -rounding * (1.0f + glm::distance(b, c) / glm::distance(a, b))) {
			return false;
		}
	}
	return true;
}

bool contains(const Polygon &polygon, glm::vec3 point) {
	bool is_inside = false;
	for (size_t i = 0; i < polygon.size(); ++i) {
		const glm::vec3 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
		if ((a.z > point.z) != (b.z > point.z) && point.x < a.x + (b.x - a.x) * (point.z - a.z) / (b.z - a.z)) {
			is_inside = !is_inside;
		}
	}
	return is_inside;
}

// Of any polygon with a convex one (Sutherland and Hodgman).
double overlap_area(Polygon polygon, const Polygon &convex) {
	for (size_t i = 0; i < convex.size() && !polygon.empty(); ++i) {
		const glm::vec3 a = convex[i], b = convex[(i + 1) % convex.size()];
		Polygon kept;
		for (size_t j = 0; j < polygon.size(); ++j) {
			const glm::vec3 p = polygon[j], q = polygon[(j + 1) % polygon.size()];
			const double from = leftness(a, b, p), to = leftness(a, b, q);
			if (from >= 0.0) {
				kept.push_back(p);
			}
			if ((from > 0.0 && to < 0.0) || (from < 0.0 && to > 0.0)) {
				kept.push_back(glm::mix(p, q, float(from / (from - to))));
			}
		}
		polygon = kept;
	}
	return polygon.size() < 3 ? 0.0 : signed_area(polygon);
}

struct Piece {
	Polygon polygon;
	glm::vec3 min, max;
	bool is_convex;
};

std::vector<Piece> all_pieces(const Layout &layout) {
	std::vector<Piece> pieces;
	const auto add = [&](const Polygon &polygon) {
		Piece piece{ polygon, polygon[0], polygon[0], is_convex(polygon) };
		for (const glm::vec3 &corner : polygon) {
			piece.min = { std::fmin(piece.min.x, corner.x), 0, std::fmin(piece.min.z, corner.z) };
			piece.max = { std::fmax(piece.max.x, corner.x), 0, std::fmax(piece.max.z, corner.z) };
		}
		pieces.push_back(piece);
	};
	for (const Lot &lot : layout.lots) {
		add(lot.polygon);
	}
	for (const Ground &ground : layout.ground) {
		add(ground.polygon);
	}
	return pieces;
}

// The broadest strip that two pieces share, metres. Of two concave pieces nothing is known; no generator makes such neighbours.
double worst_overlap(std::vector<Piece> pieces) {
	std::sort(pieces.begin(), pieces.end(), [](const Piece &a, const Piece &b) { return a.min.x < b.min.x; });
	double worst = 0.0;
	for (size_t i = 0; i < pieces.size(); ++i) {
		for (size_t j = i + 1; j < pieces.size() && pieces[j].min.x < pieces[i].max.x; ++j) {
			const Piece &a = pieces[i].is_convex ? pieces[j] : pieces[i], &b = pieces[i].is_convex ? pieces[i] : pieces[j];
			if (a.min.z < b.max.z && b.min.z < a.max.z && b.is_convex) {
				const glm::vec3 size = glm::min(a.max, b.max) - glm::max(a.min, b.min);
				worst = std::fmax(worst, overlap_area(a.polygon, b.polygon) / double(std::fmax(size.x, size.z)));
			}
		}
	}
	return worst;
}

double total_area(const std::vector<Piece> &pieces) {
	double sum = 0.0;
	for (const Piece &piece : pieces) {
		sum += signed_area(piece.polygon);
	}
	return sum;
}

// The street of the pavement of this block at this point; -1 = there is no pavement.
float pavement_street(const Layout &layout, BlockId block, glm::vec3 point) {
	for (uint32_t i : layout.block(block).pavements) {
		const Ground &ground = layout.ground[i];
		if (contains(ground.polygon, point)) {
			return ground.street == no_street ? 0.0f : layout.streets[ground.street].width;
		}
	}
	return -1.0f;
}

// Every edge knows the street on which it lies, and the first has one.
bool has_fronts(const Layout &layout) {
	for (const Lot &lot : layout.lots) {
		if (!(lot.street_widths[0] > 0.0f) || lot.street_widths.size() != lot.polygon.size()) {
			return false;
		}
		for (size_t edge = 0; edge < lot.polygon.size(); ++edge) {
			const glm::vec3 a = lot.polygon[edge], b = lot.polygon[(edge + 1) % lot.polygon.size()];
			// Outwards of a counter-clockwise edge: right of its direction.
			const glm::vec3 along = glm::normalize(b - a);
			const float street = pavement_street(layout, lot.block, (a + b) / 2.0f + 0.02f * glm::vec3(-along.z, 0.0f, along.x));
			if (std::fmax(0.0f, street) != lot.street_widths[edge]) {
				return false;
			}
		}
	}
	return true;
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

// Of ordinary measures: a town of up to about 200 lots.
LayoutParameters random_town(LayoutKind kind, uint64_t seed) {
	Random random(seed);
	LayoutParameters p;
	p.kind = kind;
	p.blocks_x = 1 + uint32_t(random.index(5));
	p.blocks_z = 1 + uint32_t(random.index(5));
	p.rings = 1 + uint32_t(random.index(3));
	p.spokes = 5 + uint32_t(random.index(6));
	p.lots_along = 2 + uint32_t(random.index(5));
	p.lots_deep = 1 + uint32_t(random.index(2));
	p.lot_front = float(random.uniform(12.0, 30.0));
	p.lot_aspect = float(random.uniform(0.8, 2.0));
	p.street_width = float(random.uniform(5.0, 9.0));
	p.main_street_width = float(random.uniform(7.0, 14.0));
	p.pavement_width = float(random.uniform(1.5, 4.0));
	p.jitter = float(random.uniform(0.0, 0.2));
	p.removed = float(random.uniform(0.0, 0.3));
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
	// With 3 m of pavement around.
	CHECK(layout.blocks[0].outline == std::vector<glm::vec3>{ { -23, 0, 33 }, { 23, 0, 33 }, { 23, 0, -33 }, { -23, 0, -33 } });
	CHECK(layout.streets.size() == 4);
	CHECK(layout.junctions[layout.streets[0].from] == glm::vec3(-27, 0, -37));
}

// What must be true of every layout.
void check_layout(const Layout &layout) {
	const std::vector<Piece> pieces = all_pieces(layout);
	const double area = signed_area(layout.outline);
	CHECK(total_area(pieces) == doctest::Approx(area).epsilon(1e-4));
	CHECK(worst_overlap(pieces) < 0.001); // coordinates are floats
	CHECK(std::all_of(pieces.begin(), pieces.end(), [](const Piece &piece) { return signed_area(piece.polygon) > 0.0; }));
	CHECK(std::all_of(pieces.begin() + ptrdiff_t(layout.lots.size()), pieces.end(), [](const Piece &piece) { return piece.is_convex; }));
	CHECK(has_fronts(layout));
}

TEST_CASE("a thousand regular grids: lots and public ground cover the city, and every lot has its front and its other street edges") {
	for (uint64_t seed = 0; seed < 1000; ++seed) {
		CAPTURE(seed);
		check_layout(make(random_parameters(seed)));
	}
}

TEST_CASE("a thousand grids with moved junctions and without some streets cover the city, and every lot has a front") {
	for (uint64_t seed = 0; seed < 1000; ++seed) {
		CAPTURE(seed);
		LayoutParameters p = random_parameters(seed);
		p.jitter = float(Random(seed, 1).uniform(0.0, 0.25));
		p.removed = float(Random(seed, 2).uniform(0.0, 0.5));
		check_layout(make(p));
	}
}

TEST_CASE("a thousand radial layouts cover the city, and every lot has a front") {
	for (uint64_t seed = 0; seed < 1000; ++seed) {
		CAPTURE(seed);
		check_layout(make(random_town(LayoutKind::Radial, seed)));
	}
}

TEST_CASE("a thousand grown layouts cover the city, and every lot has a front") {
	for (uint64_t seed = 0; seed < 1000; ++seed) {
		CAPTURE(seed);
		check_layout(make(random_town(LayoutKind::Grown, seed)));
	}
}

TEST_CASE("the tiles cover the city") {
	for (uint64_t seed = 0; seed < 50; ++seed) {
		const Layout layout = make(random_town(seed % 2 == 0 ? LayoutKind::Radial : LayoutKind::Grid, seed));
		double sum = 0.0;
		for (const Tile &tile : layout.tiles) {
			sum += double(tile.max.x - tile.min.x) * (tile.max.z - tile.min.z);
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
	CHECK(refused([](LayoutParameters &p) { p.spokes = 4; }).find("number of spokes is 4, but must be from 5 to 64") != std::string::npos);
	CHECK(refused([](LayoutParameters &p) { p.rings = 0; }).find("number of rings is 0") != std::string::npos);
	CHECK(refused([](LayoutParameters &p) { p.jitter = 0.3f; }).find("the jitter is 0.3") != std::string::npos);
	CHECK(refused([](LayoutParameters &p) { p.removed = -0.1f; }).find("streets that is removed is -0.1") != std::string::npos);
	CHECK(refused([](LayoutParameters &p) { p.main_street_width = 1.0f; }).find("width of main streets is 1") != std::string::npos);
	const auto narrow = [](LayoutParameters &p) { p.kind = LayoutKind::Radial, p.lots_deep = 1, p.lot_front = 5.0f, p.main_street_width = 60.0f; };
	CHECK(refused(narrow).find("streets are too wide") != std::string::npos);
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

TEST_CASE("a radial city has at least the wanted lots, as far as its blocks allow") {
	LayoutParameters base;
	base.kind = LayoutKind::Radial;
	CHECK(layout_for_lots(60, base).rings == 1); // 1 + 7 blocks of about ten lots
	CHECK(block_count(layout_for_lots(60, base)) == 8);
	const Layout layout = make(layout_for_lots(300, base));
	CHECK(layout.lots.size() > 200);
	CHECK(layout.lots.size() < 450);
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
