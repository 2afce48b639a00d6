#include <doctest/doctest.h>

#include "core/base/shrink.h"

TEST_CASE("a list keeps what it holds and no room beside it") {
	std::vector<int> list = { 1, 2, 3 };
	list.reserve(100);
	pcg::shrink(list);
	CHECK(list == std::vector<int>{ 1, 2, 3 });
	CHECK(list.capacity() == 3);
}
