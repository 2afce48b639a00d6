#include "core/cga/split_layout.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

using namespace pcg;
using namespace pcg::cga;

namespace {

SplitSize fixed(double value) { return { value, SizeKind::Absolute, 0 }; }
SplitSize flexible(double value) { return { value, SizeKind::Flexible, 0 }; }
SplitSize relative(double value) { return { value, SizeKind::Relative, 0 }; }

struct Group {
	std::vector<SplitSize> sizes;
	bool is_repeated = false;
};

SplitLayout lay_out(const std::vector<Group> &groups, double length, uint32_t most, Arena &arena) {
	std::vector<SplitGroup> views;
	for (const Group &group : groups) {
		views.push_back({ group.sizes, group.is_repeated });
	}
	return lay_out_split(views, length, most, arena);
}

std::vector<double> lengths(const std::vector<Group> &groups, double length, uint32_t most = 1000) {
	Arena arena;
	std::vector<double> result;
	for (const SplitPart &part : lay_out(groups, length, most, arena).parts) {
		result.push_back(std::round((part.to - part.from) * 1e6) / 1e6);
	}
	return result;
}

} // namespace

TEST_CASE("parts follow each other without gaps, and a flexible end reaches the end exactly") {
	Arena arena;
	const auto layout = lay_out({ { { fixed(0.1), flexible(1), fixed(0.2), flexible(2) }, false } }, 0.7, 100, arena);
	REQUIRE(layout.parts.size() == 4);
	for (size_t i = 1; i < layout.parts.size(); ++i) {
		CHECK(layout.parts[i].from == layout.parts[i - 1].to);
	}
	CHECK(layout.parts.back().to == 0.7);
}

TEST_CASE("flexible parts vanish where the fixed ones fill the length") {
	CHECK(lengths({ { { fixed(6), flexible(1), fixed(6) }, false } }, 10) == std::vector<double>{ 6, 4 });
}

TEST_CASE("relative sizes are shares of the whole length, also inside of a repeat") {
	CHECK(lengths({ { { relative(0.5) }, true } }, 10) == std::vector<double>{ 5, 5 });
	CHECK(lengths({ { { relative(0.3) }, true } }, 10) == std::vector<double>{ 3, 3, 3, 1 });
}

TEST_CASE("a repeat takes the count with the smallest stretch") {
	CHECK(lengths({ { { flexible(4) }, true } }, 10) == std::vector<double>{ 3.333333, 3.333333, 3.333333 }); // 0.83 beats 1.25
	CHECK(lengths({ { { flexible(4) }, true } }, 9) == std::vector<double>{ 4.5, 4.5 }); // 1.125 beats 0.75
	CHECK(lengths({ { { flexible(20) }, true } }, 9) == std::vector<double>{ 9 }); // at least once
}

TEST_CASE("a repeat that does not fit beside the others is left out") {
	CHECK(lengths({ { { fixed(2) }, false }, { { fixed(3), flexible(1) }, true }, { { flexible(1) }, false } }, 4) == std::vector<double>{ 2, 2 });
}

TEST_CASE("only fixed parts in a repeat: whole patterns beside flexible ones") {
	CHECK(lengths({ { { flexible(1) }, false }, { { fixed(3) }, true }, { { flexible(1) }, false } }, 10) == std::vector<double>{ 0.5, 3, 3, 3, 0.5 });
}

TEST_CASE("several repeats share the length evenly") {
	// { ~2 }* | { ~3 }* | ~2 over 17 m: one each is 7 m; 2 + 1 -> 9, 2 + 2 -> 12, 3 + 2 -> 14, 3 + 3 -> 17 m: stretch 1.
	CHECK(lengths({ { { flexible(2) }, true }, { { flexible(3) }, true }, { { flexible(2) }, false } }, 17) == std::vector<double>{ 2, 2, 2, 3, 3, 3, 2 });
}

TEST_CASE("useless sizes make no part, and no endless work") {
	CHECK(lengths({ { { fixed(NAN), fixed(-3), fixed(INFINITY), flexible(0) }, false } }, 10).empty());
	CHECK(lengths({ { { fixed(0), flexible(0) }, true } }, 10).empty());
	CHECK(lengths({ { { flexible(1) }, true } }, 0).empty());
	CHECK(lengths({ { { flexible(1) }, true } }, NAN).empty());
	Arena arena;
	const auto layout = lay_out({ { { fixed(1e-3) }, true } }, 1e6, 1000, arena);
	CHECK(layout.is_clamped);
	CHECK(layout.parts.size() == 1000);
	const auto weights = lay_out({ { { flexible(1e-3) }, true } }, 1e6, 1000, arena);
	CHECK(weights.is_clamped);
	CHECK(weights.parts.size() == 1000);
}
