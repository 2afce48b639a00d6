#include <doctest/doctest.h>

#include <algorithm>

#include "core/base/random.h"
#include "core/navigation/open_list.h"

using namespace pcg;

TEST_CASE("an open list gives its entries back from the least estimate on, whatever was pushed between") {
	OpenList list;
	Random random(1);
	std::vector<float> expected;
	for (uint32_t i = 0; i < 2000; ++i) {
		const float estimate = float(random.uniform(0.0, 50.0));
		list.push({ estimate, i });
		expected.push_back(estimate);
		if (i % 3 == 2) {
			const auto least = std::min_element(expected.begin(), expected.end());
			CHECK(list.pop().estimate == *least);
			expected.erase(least);
		}
	}
	std::sort(expected.begin(), expected.end());
	for (const float estimate : expected) {
		REQUIRE_FALSE(list.is_empty());
		CHECK(list.pop().estimate == estimate);
	}
	CHECK(list.is_empty());
}
