#include <doctest/doctest.h>

#include <algorithm>
#include <numbers>

#include <glm/gtc/matrix_transform.hpp>

#include "core/city/footprint_layout.h"
#include "core/city/lot_ground.h"
#include "core/city/plan_layout.h"
#include "core/city/walkable.h"

using namespace pcg;

namespace {

Loop2 loop(double x0, double y0, double x1, double y1) { return { { x0, y0 }, { x1, y0 }, { x1, y1 }, { x0, y1 } }; }
std::vector<glm::vec3> box(double x0, double y0, double x1, double y1) { return to_ground(loop(x0, y0, x1, y1)); }

Footprint footprint(const Loop2 &outline, const std::vector<Loop2> &holes = {}) {
	Footprint result;
	result.outline = outline;
	result.holes = holes;
	return result;
}

// Lots of outlines, of which `ground` tells where their buildings leave ground.
City city_of(const std::vector<Footprint> &footprints, std::vector<std::vector<std::vector<glm::vec3>>> ground) {
	LayoutParameters parameters;
	parameters.land_use = { { "house", 1.0 } };
	Diagnostics diagnostics;
	std::optional<Layout> layout = layout_of_footprints(footprints, parameters, diagnostics);
	REQUIRE(layout.has_value());
	City city;
	city.layout = std::move(*layout);
	for (std::vector<std::vector<glm::vec3>> &pieces : ground) {
		city.lots.emplace_back().free_ground = std::move(pieces);
	}
	REQUIRE(city.lots.size() == city.layout.lots.size());
	return city;
}

// A ring of 60 by 60 m around a courtyard of 30 by 30 m with a gate of 4 m in the south. In it a hut of 10 by 10 m with 2 m of ground in the south;
// another like that far away.
City ring_and_huts() {
	const Footprint ring = footprint(loop(0, 0, 60, 60), { loop(15, 15, 45, 45) }), hut = footprint(loop(25, 25, 35, 35)), far = footprint(loop(200, 200, 210, 210));
	return city_of({ ring, hut, far }, { { box(15, 15, 45, 45), box(28, 0, 32, 15) }, { box(25, 25, 35, 27) }, { box(200, 200, 210, 202) } });
}
constexpr LotId ring_id = LotId(0), hut_id = LotId(1), far_id = LotId(2);

PlacedLot at_home(LotId lot) { return { index_of(lot) + 100, lot }; }
PlacedLot moved_by(LotId lot, float x, float y) { return { index_of(lot) + 100, lot, glm::translate(glm::mat4(1.0f), { x, 0, -y }), false }; }
PlacedLot turned(LotId lot, glm::vec3 axis) {
	const glm::vec3 middle(30, 0, -30);
	const glm::mat4 turn = glm::rotate(glm::mat4(1.0f), std::numbers::pi_v<float>, axis);
	return { index_of(lot) + 100, lot, glm::translate(glm::mat4(1.0f), middle) * turn * glm::translate(glm::mat4(1.0f), -middle), false };
}

// Where one can walk when lots stand like that.
class Walks {
public:
	Walks(City city, std::span<const PlacedLot> lots) {
		for (const auto &[key, patch] : patches_of_lots(city, lots)) {
			city.patches.push_back(patch);
		}
		_region = city_nav_region(city);
	}

	bool has(double x, double y) const {
		return std::ranges::any_of(_region.polygons, [&](const std::vector<uint32_t> &polygon) {
			std::vector<glm::vec3> corners;
			for (const uint32_t i : polygon) {
				corners.push_back(_region.vertices[i]);
			}
			return contains(to_plan(corners), { x, y });
		});
	}

private:
	NavRegion _region;
};

} // namespace

TEST_CASE("lots at home are no patches, and what stands in a courtyard is cut out of it exactly") {
	const City city = ring_and_huts();
	const std::vector<PlacedLot> lots{ at_home(ring_id), at_home(hut_id), at_home(far_id) };
	CHECK(patches_of_lots(city, lots).empty());
	double area = 0.0;
	for (const std::vector<glm::vec3> &piece : lot_ground(city, ring_id)) {
		area += signed_area(to_plan(piece)) / 2.0;
	}
	CHECK(area == doctest::Approx(30.0 * 30.0 + 4.0 * 15.0 - 10.0 * 10.0));
	const Walks ground(city, lots);
	CHECK(ground.has(20, 20));
	CHECK(ground.has(30, 5));
	CHECK(ground.has(30, 26));
	CHECK_FALSE(ground.has(30, 30));
	CHECK_FALSE(ground.has(5, 30));
}

TEST_CASE("a ring that is turned stands around what stays in its courtyard") {
	for (const glm::vec3 axis : { glm::vec3(0, 1, 0), glm::vec3(1, 0, 0) }) { // around, and upside down
		const Walks ground(ring_and_huts(), std::vector<PlacedLot>{ turned(ring_id, axis), at_home(hut_id), at_home(far_id) });
		CHECK(ground.has(30, 26)); // before the hut
		CHECK_FALSE(ground.has(30, 30)); // in it
		CHECK(ground.has(20, 20));
		CHECK(ground.has(30, 55)); // the gate
		CHECK_FALSE(ground.has(30, 5));
		CHECK_FALSE(ground.has(5, 30));
	}
}

TEST_CASE("a courtyard without what stood in it is ground, at home and elsewhere; a closed one is none") {
	const City city = ring_and_huts();
	CHECK(Walks(city, std::vector<PlacedLot>{ at_home(ring_id) }).has(30, 30));
	const Walks moved(city, std::vector<PlacedLot>{ moved_by(ring_id, 100, 0), at_home(far_id) });
	CHECK(moved.has(130, 30));
	CHECK(moved.has(30, 30)); // a lawn
	City closed = city;
	closed.lots[index_of(ring_id)].free_ground.clear();
	CHECK_FALSE(Walks(closed, std::vector<PlacedLot>{ at_home(ring_id) }).has(30, 30));
	CHECK_FALSE(Walks(closed, std::vector<PlacedLot>{ moved_by(ring_id, 100, 0) }).has(130, 30));
}

TEST_CASE("what stood in a courtyard stays when the ring goes, and what stands where a ring comes is in its courtyard") {
	const City city = ring_and_huts();
	for (const std::vector<PlacedLot> &lots : { std::vector<PlacedLot>{ at_home(hut_id), at_home(far_id) },
				 std::vector<PlacedLot>{ moved_by(ring_id, 175, 175), at_home(hut_id), at_home(far_id) } }) {
		const Walks ground(city, lots);
		CHECK(ground.has(5, 30)); // where the ring stood
		CHECK(ground.has(30, 26));
		CHECK_FALSE(ground.has(30, 30));
		CHECK(ground.has(205, 201));
		CHECK_FALSE(ground.has(205, 205));
		CHECK(ground.has(195, 195));
	}
	// The other way round: a lot is moved into the courtyard, beside the hut, whichever is the first.
	const Walks visited(city, std::vector<PlacedLot>{ moved_by(far_id, -183, -183), at_home(ring_id), at_home(hut_id) });
	CHECK(visited.has(22, 18));
	CHECK_FALSE(visited.has(22, 22));
	CHECK(visited.has(42, 42));
}

TEST_CASE("rings within rings keep what stands in them when the outermost goes") {
	const Footprint outer = footprint(loop(0, 0, 80, 80), { loop(10, 10, 70, 70) }), inner = footprint(loop(20, 20, 60, 60), { loop(30, 30, 50, 50) });
	const Footprint hut = footprint(loop(35, 35, 45, 45));
	const City city = city_of({ hut, inner, outer }, { { box(35, 35, 45, 37) }, { box(30, 30, 50, 50), box(38, 20, 42, 30) }, { box(10, 10, 70, 70), box(38, 0, 42, 10) } });
	for (const PlacedLot &gone : { moved_by(LotId(2), 200, 0), moved_by(LotId(2), 1, 1) }) {
		const Walks ground(city, std::vector<PlacedLot>{ at_home(LotId(0)), at_home(LotId(1)), gone });
		CHECK(ground.has(40, 36)); // before the hut
		CHECK_FALSE(ground.has(40, 41));
		CHECK(ground.has(32, 32)); // in the inner courtyard
		CHECK_FALSE(ground.has(25, 40)); // the inner ring
		CHECK(ground.has(15, 40)); // in the outer courtyard
		CHECK(ground.has(240, 40) == (gone.motion[3].x > 100.0f)); // all of it moves along
	}
}

TEST_CASE("of lots that were drawn over each other the one that is left stands where both stood") {
	const City city = city_of({ footprint(loop(0, 0, 20, 20)), footprint(loop(15, 0, 35, 20)) }, { {}, {} });
	const Walks ground(city, std::vector<PlacedLot>{ at_home(LotId(1)) });
	CHECK(ground.has(10, 10));
	CHECK_FALSE(ground.has(17, 10));
	CHECK_FALSE(ground.has(30, 10));
}
