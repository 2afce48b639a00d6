#include "core/base/hash_index.h"

#include <doctest/doctest.h>

using namespace pcg;

TEST_CASE("an index finds by hash and by what is asked, however many there are") {
	HashIndex index;
	const auto any = [](uint32_t) { return true; };
	CHECK(index.find(7, any) == HashIndex::none);
	for (uint32_t i = 0; i < 1000; ++i) {
		CHECK(index.add(uint64_t(i) << 32) == i); // all of them in one place of any table
	}
	for (uint32_t i = 0; i < 1000; ++i) {
		CHECK(index.find(uint64_t(i) << 32, any) == i);
	}
	CHECK(index.find(uint64_t(1000) << 32, any) == HashIndex::none);
	CHECK(index.find(uint64_t(3) << 32, [](uint32_t) { return false; }) == HashIndex::none);
}

TEST_CASE("equal hashes are told apart by what is asked") {
	HashIndex index;
	index.add(5);
	index.add(5);
	CHECK(index.find(5, [](uint32_t number) { return number == 1; }) == 1);
	index.clear();
	CHECK(index.find(5, [](uint32_t) { return true; }) == HashIndex::none);
	CHECK(index.add(5) == 0);
}
