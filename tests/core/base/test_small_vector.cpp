#include "core/base/small_vector.h"

#include <doctest/doctest.h>

#include <numeric>

using namespace pcg;

TEST_CASE("a small list keeps its values when it outgrows its place") {
	SmallVector<int, 3> list = { 1, 2 };
	CHECK(list.size() == 2);
	for (int i = 3; i <= 10; ++i) {
		list.push_back(i);
		CHECK(list[0] == 1);
		CHECK(list[size_t(i) - 1] == i);
	}
	CHECK(std::accumulate(list.begin(), list.end(), 0) == 55);
	const SmallVector<int, 3> copy = list;
	list[9] = 0;
	CHECK(copy[9] == 10);
	CHECK(copy.size() == 10);
	CHECK(SmallVector<int, 3>().empty());
	CHECK(SmallVector<int, 3>(4, 7)[3] == 7);
}
