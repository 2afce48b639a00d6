#include <doctest/doctest.h>

#include "core/city/ground_patch.h"
#include "core/city/plan_layout.h"

using namespace pcg;

namespace {

std::vector<glm::vec3> box(float x0, float y0, float x1, float y1) { return { { x0, 0, -y0 }, { x1, 0, -y0 }, { x1, 0, -y1 }, { x0, 0, -y1 } }; }

double area(const std::vector<WalkablePiece> &ground) {
	double sum = 0.0;
	for (const WalkablePiece &piece : ground) {
		CHECK(is_convex(to_plan(piece.polygon)));
		sum += signed_area(to_plan(piece.polygon)) / 2.0;
	}
	return sum;
}

} // namespace

TEST_CASE("a patch takes what lies within its outline and puts its pieces there") {
	std::vector<WalkablePiece> ground{ { box(0, 0, 10, 10), 2.0f } };
	const std::vector<GroundPatch> patches{ { box(5, 5, 15, 15), { box(6, 6, 8, 8) } } };
	apply_patches(ground, patches, 1.5f);
	CHECK(area(ground) == doctest::Approx(75.0 + 4.0));
	CHECK(ground.front().cost == 2.0f);
	CHECK(ground.back().cost == 1.5f);
}

TEST_CASE("convex pieces are cut along outlines of any shape") {
	const std::vector<glm::vec3> corner{ { 2, 0, -2 }, { 6, 0, -2 }, { 6, 0, -4 }, { 4, 0, -4 }, { 4, 0, -6 }, { 2, 0, -6 } }; // an L of 12 square metres
	const std::vector<std::vector<glm::vec3>> pieces{ box(0, 0, 10, 3), box(0, 3, 10, 10), box(20, 0, 30, 10) };
	const auto area_of = [](const std::vector<std::vector<glm::vec3>> &polygons) {
		std::vector<WalkablePiece> ground;
		for (const std::vector<glm::vec3> &polygon : polygons) {
			ground.push_back({ polygon });
		}
		return area(ground);
	};
	CHECK(area_of(pieces_within(pieces, corner)) == doctest::Approx(12.0));
	CHECK(area_of(pieces_without(pieces, std::vector{ corner, box(7, 7, 9, 9), box(7, 1, 9, 2) })) == doctest::Approx(200.0 - 12.0 - 4.0 - 2.0));
	CHECK(pieces_within(pieces, box(40, 40, 50, 50)).empty());
}
