#include <doctest/doctest.h>

#include "core/base/random.h"

using namespace pcg;

TEST_CASE("a stream can be saved in the middle and goes on with the same numbers") {
	Random a(7, 3);
	a.next();
	Random b;
	b.restore(a.key(), a.counter());
	CHECK(a.next() == b.next());
}

TEST_CASE("mix64 is SplitMix64: the first output for state 0 is the published one") {
	CHECK(mix64(0) == 0xE220A8397B1DCDAFull);
}

TEST_CASE("uniform numbers fill their range evenly") {
	Random random(1, 2);
	int buckets[10] = {};
	for (int i = 0; i < 100'000; ++i) {
		const double u = random.uniform();
		REQUIRE(u >= 0.0);
		REQUIRE(u < 1.0);
		++buckets[int(u * 10)];
	}
	// Chi-squared with 9 degrees of freedom: above 27.9 with probability 0.001.
	double chi = 0.0;
	for (int n : buckets) {
		chi += (n - 10'000.0) * (n - 10'000.0) / 10'000.0;
	}
	CHECK(chi < 27.9);
}

TEST_CASE("index stays below its count and is 0 for an empty range") {
	Random random(5);
	CHECK(random.index(0) == 0);
	for (int i = 0; i < 1000; ++i) {
		REQUIRE(random.index(3) < 3);
	}
}
