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

TEST_CASE("what a patch keeps stays as it is, also side by side") {
	std::vector<WalkablePiece> ground{ { box(0, 0, 10, 10), 2.0f } };
	const std::vector<GroundPatch> patches{ { box(1, 1, 9, 9), {}, { box(2, 2, 4, 4), box(4, 2, 6, 4), box(7, 7, 8, 8) } } };
	apply_patches(ground, patches, 1.5f);
	CHECK(area(ground) == doctest::Approx(100.0 - 64.0 + 4.0 + 4.0 + 1.0));
}
