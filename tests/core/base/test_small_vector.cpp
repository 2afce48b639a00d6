#include "core/base/small_vector.h"

#include <doctest/doctest.h>

#include <numeric>
#include <string>

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

TEST_CASE("a small list holds lists and texts, moves them and gives them back") {
	using Texts = SmallVector<std::string, 2>;
	SmallVector<Texts, 1> lists = { { "a", "b" }, { "c", "a text that is too long for any small string", "d" } };
	SmallVector<Texts, 1> moved = std::move(lists);
	CHECK(lists.empty());
	REQUIRE(moved.size() == 2);
	CHECK(moved[1][2] == "d");
	moved[0].insert(moved[0].begin() + 1, moved[1].begin(), moved[1].end());
	CHECK(moved[0] == Texts{ "a", "c", "a text that is too long for any small string", "d", "b" });
	moved[0].push_back(moved[0][1]); // lies in the memory that is given back
	moved[0].push_back(moved[0][2]);
	CHECK(moved[0].back().size() > 20);
	erase_if(moved[0], [](const std::string &text) { return text.size() == 1; });
	CHECK(moved[0].size() == 2);
	moved[0].erase(moved[0].begin(), moved[0].begin() + 1);
	moved[0].resize(3, "e");
	CHECK(moved[0] == Texts{ "a text that is too long for any small string", "e", "e" });
	moved[1] = moved[0];
	moved[0] = Texts(std::vector<std::string>{ "f" });
	CHECK(moved[1].size() == 3);
	CHECK(moved[0] == Texts{ "f" });
	moved = SmallVector<Texts, 1>();
	CHECK(moved.empty());
}
