#include <doctest/doctest.h>

#include <algorithm>

#include <glm/geometric.hpp>

#include "core/base/random.h"
#include "core/navigation/packed_walks.h"

using namespace pcg;

namespace {

// Corners 3 m apart on a line, each with walks to some others on ground of one of the costs.
struct Line {
	std::vector<glm::vec3> points;
	CornerWalks walks;

	explicit Line(uint32_t count) : walks(count) {
		for (uint32_t i = 0; i < count; ++i) {
			points.push_back({ 3.0f * float(i % 1000), 0.0f, 3.0f * float(i / 1000) });
		}
	}
	void add(uint32_t from, uint32_t to, float ground) { walks[from].push_back({ to, ground * glm::distance(points[from], points[to]) }); }
};

bool is_same(std::vector<SeenCorner> a, std::vector<SeenCorner> b) {
	const auto by_corner = [](const SeenCorner &x, const SeenCorner &y) { return x.corner < y.corner; };
	std::sort(a.begin(), a.end(), by_corner);
	std::sort(b.begin(), b.end(), by_corner);
	return std::ranges::equal(a, b, [](const SeenCorner &x, const SeenCorner &y) { return x.corner == y.corner && x.cost == y.cost; });
}

} // namespace

TEST_CASE("packed walks are what they were, near and far, few and many, on several kinds of ground") {
	const std::vector<float> grounds = { 1.0f, 1.25f, 3.5f };
	Line line(100'000);
	Random random(1);
	for (const uint32_t from : { 0u, 1u, 40'000u, 65'536u, 99'999u }) {
		for (uint32_t i = 1; i < 200; ++i) {
			const auto to = uint32_t(i % 2 == 0 ? (from + i) % 100'000 : (from + i * 491) % 100'000);
			line.add(from, to, grounds[random.index(3)]);
		}
	}
	line.add(50'000, 50'000 + 32'767, 1.0f); // the farthest that are near, and beyond
	line.add(50'000, 50'000 + 32'768, 1.0f);
	line.add(50'000, 50'000 - 32'768, 1.0f);
	line.add(50'000, 50'000 - 32'769, 1.0f);
	const PackedWalks packed(line.points, grounds, line.walks);
	size_t different = 0;
	for (uint32_t corner = 0; corner < 100'000; ++corner) {
		different += !is_same(packed.of(line.points, corner), line.walks[corner]);
	}
	CHECK(different == 0);
}

TEST_CASE("of more grounds than can be told apart the nearest of some counts") {
	std::vector<float> grounds;
	for (size_t i = 0; i < 5 * PackedWalks::most_grounds; ++i) {
		grounds.push_back(1.0f + float(i) / 100.0f);
	}
	Line line(2);
	line.add(0, 1, grounds[0]);
	line.add(1, 0, grounds[1234]);
	const PackedWalks packed(line.points, grounds, line.walks);
	CHECK(packed.of(line.points, 0)[0].cost == line.walks[0][0].cost); // the cheapest stays
	CHECK(packed.of(line.points, 1)[0].cost / 3.0f == doctest::Approx(grounds[1234]).epsilon(0.05));
	CHECK(packed.of(line.points, 1)[0].cost != line.walks[1][0].cost);
}

TEST_CASE("a corner may have no walks") {
	Line line(1);
	CHECK(PackedWalks(line.points, std::vector<float>{ 1.0f }, line.walks).of(line.points, 0).empty());
}
