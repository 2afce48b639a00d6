#include "core/geometry/solid.h"

#include <doctest/doctest.h>

#include <glm/vec2.hpp>

#include "core/geometry/bounds_tree.h"

using namespace pcg;

namespace {

void add_quad(Solid &solid, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::dvec3 d) {
	const glm::dvec3 points[] = { a, b, c, d };
	const uint32_t ends[] = { 4 };
	solid.add_polygon(points, ends);
}

Solid box(glm::dvec3 low, glm::dvec3 high) {
	Solid solid;
	solid.is_closed = true;
	const auto at = [&](int x, int y, int z) { return glm::dvec3(x ? high.x : low.x, y ? high.y : low.y, z ? high.z : low.z); };
	add_quad(solid, at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1));
	add_quad(solid, at(0, 1, 1), at(1, 1, 1), at(1, 1, 0), at(0, 1, 0));
	add_quad(solid, at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1));
	add_quad(solid, at(1, 0, 0), at(0, 0, 0), at(0, 1, 0), at(1, 1, 0));
	add_quad(solid, at(1, 0, 1), at(1, 0, 0), at(1, 1, 0), at(1, 1, 1));
	add_quad(solid, at(0, 0, 0), at(0, 0, 1), at(0, 1, 1), at(0, 1, 0));
	return solid;
}

Solid plate(glm::dvec3 low, glm::dvec3 high) { // flat in y, facing up
	Solid solid;
	add_quad(solid, { low.x, low.y, high.z }, { high.x, low.y, high.z }, { high.x, low.y, low.z }, { low.x, low.y, low.z });
	return solid;
}

bool is(const SolidRelation &relation, bool inside, bool overlaps, bool touches) {
	return relation.is_inside == inside && relation.overlaps == overlaps && relation.touches == touches;
}

} // namespace

TEST_CASE("bodies lie in, across, against or apart from a box") {
	const Solid cube = box({ 0, 0, 0 }, { 4, 4, 4 });
	CHECK(is(relate(box({ 1, 1, 1 }, { 2, 2, 2 }), cube), true, true, true));
	CHECK(is(relate(box({ 3, 1, 1 }, { 5, 2, 2 }), cube), false, true, true));
	CHECK(is(relate(box({ 4, 1, 1 }, { 5, 2, 2 }), cube), false, false, true)); // wall to wall
	CHECK(is(relate(box({ 4, 4, 1 }, { 5, 5, 2 }), cube), false, false, false)); // edge to edge only
	CHECK(is(relate(box({ 4, 4, 4 }, { 5, 5, 5 }), cube), false, false, false)); // corner to corner
	CHECK(is(relate(box({ 6, 1, 1 }, { 7, 2, 2 }), cube), false, false, false));
	CHECK(is(relate(box({ -1, -1, -1 }, { 5, 5, 5 }), cube), false, true, true)); // around it
	CHECK(is(relate(cube, cube), true, true, true));
	CHECK(is(relate(box({ 0, 0, 0 }, { 4, 4, 2 }), cube), true, true, true)); // half of it
	CHECK(is(relate(box({ -1, 1, 1 }, { 5, 2, 2 }), cube), false, true, true)); // through it, no corner of either in the other
	CHECK(is(relate(box({ 1, 1, -1 }, { 3, 3, 5 }), cube), false, true, true));
}

TEST_CASE("less than the tolerance apart is contact, less than the tolerance deep is no overlap") {
	const Solid cube = box({ 0, 0, 0 }, { 4, 4, 4 });
	const double little = 0.4 * solid_tolerance;
	CHECK(is(relate(box({ 4 + little, 1, 1 }, { 5, 2, 2 }), cube), false, false, true));
	CHECK(is(relate(box({ 4 - little, 1, 1 }, { 5, 2, 2 }), cube), false, false, true));
	CHECK(is(relate(box({ 4 + 1e-2, 1, 1 }, { 5, 2, 2 }), cube), false, false, false));
	CHECK(is(relate(box({ 4 - 1e-2, 1, 1 }, { 5, 2, 2 }), cube), false, true, true));
}

TEST_CASE("surfaces without a volume lie in, on, across or off a box") {
	const Solid cube = box({ 0, 0, 0 }, { 4, 4, 4 });
	CHECK(is(relate(plate({ 1, 2, 1 }, { 3, 2, 3 }), cube), true, true, true));
	CHECK(is(relate(plate({ 1, 4, 1 }, { 3, 4, 3 }), cube), true, false, true)); // on the roof
	CHECK(is(relate(plate({ -9, 4, -9 }, { 9, 4, 9 }), cube), false, false, true)); // a large one on the roof
	CHECK(is(relate(plate({ -9, 2, -9 }, { 9, 2, 9 }), cube), false, true, true)); // a large one through the middle
	CHECK(is(relate(plate({ 4, 4, 0 }, { 8, 4, 4 }), cube), false, false, false)); // beside the roof
	CHECK(is(relate(plate({ 1, 5, 1 }, { 3, 5, 3 }), cube), false, false, false));
}

TEST_CASE("the hollow of a concave body is outside") {
	// A U open to +z: two arms 1 m wide and a back.
	Solid u;
	u.is_closed = true;
	const glm::dvec2 outline[] = { { 0, 0 }, { 4, 0 }, { 4, 4 }, { 3, 4 }, { 3, 1 }, { 1, 1 }, { 1, 4 }, { 0, 4 } }; // x, z; clockwise from above
	std::vector<glm::dvec3> top, bottom;
	for (const glm::dvec2 &p : outline) {
		bottom.push_back({ p.x, 0, p.y });
		top.insert(top.begin(), { p.x, 4, p.y });
	}
	const uint32_t ends[] = { 8 };
	u.add_polygon(bottom, ends);
	u.add_polygon(top, ends);
	for (size_t i = 0; i < 8; ++i) {
		const glm::dvec2 a = outline[i], b = outline[(i + 1) % 8];
		add_quad(u, { b.x, 0, b.y }, { a.x, 0, a.y }, { a.x, 4, a.y }, { b.x, 4, b.y });
	}
	CHECK(place_in(u, { 2, 2, 2 }) == PointPlace::Outside);
	CHECK(place_in(u, { 2, 2, 0.5 }) == PointPlace::Inside);
	CHECK(place_in(u, { 1, 2, 2 }) == PointPlace::Surface);
	CHECK(is(relate(box({ 1.5, 1, 1.5 }, { 2.5, 2, 3 }), u), false, false, false));
	CHECK(is(relate(box({ 1, 1, 1.5 }, { 2.5, 2, 3 }), u), false, false, true)); // against an arm
	CHECK(is(relate(box({ 0.5, 1, 1.5 }, { 3.5, 2, 3 }), u), false, true, true)); // from arm to arm
}

TEST_CASE("points lie in, on or off a body") {
	const Solid cube = box({ 0, 0, 0 }, { 4, 4, 4 });
	const glm::dvec3 in[] = { { 1, 1, 1 } }, on[] = { { 4, 2, 2 } }, both[] = { { 1, 1, 1 }, { 9, 9, 9 } };
	CHECK(is(relate_points(in, cube), true, true, true));
	CHECK(is(relate_points(on, cube), true, false, false));
	CHECK(is(relate_points(both, cube), false, true, true));
	CHECK(is(relate(Solid(), cube), false, false, false));
}

TEST_CASE("a tree of boxes finds what looking at each would find") {
	std::vector<Bounds3> boxes;
	for (int i = 0; i < 500; ++i) {
		const glm::dvec3 low(i * 37 % 101, i * 53 % 89, i * 71 % 97);
		boxes.push_back({ low, low + glm::dvec3(1 + i % 7, 1 + i % 5, 1 + i % 3) });
	}
	BoundsTree tree;
	tree.build(boxes);
	for (int i = 0; i < 50; ++i) {
		const Bounds3 asked = { glm::dvec3(i, i, i), glm::dvec3(i + 9, i + 4, i + 14) };
		std::vector<bool> found(boxes.size(), false);
		CHECK_FALSE(tree.any(asked.low, asked.high, [&](uint32_t index) {
			CHECK_FALSE(found[index]);
			found[index] = true;
			return false;
		}));
		for (size_t b = 0; b < boxes.size(); ++b) {
			CHECK(found[b] == boxes[b].meets(asked));
		}
	}
	CHECK(tree.any({ 0, 0, 0 }, { 200, 200, 200 }, [](uint32_t) { return true; })); // ends at the first
	BoundsTree empty;
	empty.build({});
	CHECK_FALSE(empty.any({ 0, 0, 0 }, { 1, 1, 1 }, [](uint32_t) { return true; }));
}
