#include <doctest/doctest.h>

#include <vector>

#include "core/base/parallel.h"

using namespace pcg;

TEST_CASE("every piece is done once on any number of threads") {
	for (unsigned threads : { 0u, 1u, 2u, 7u }) {
		std::vector<int> done(1000, 0);
		WorkOptions options;
		options.threads = threads;
		CHECK(parallel_for(done.size(), options, [&](size_t i) { ++done[i]; }));
		CHECK(done == std::vector<int>(1000, 1));
	}
	CHECK(parallel_for(0, {}, [](size_t) { FAIL("there is nothing to do"); }));
}

TEST_CASE("progress grows and ends at the total") {
	size_t last = 0;
	bool has_grown = true;
	WorkOptions options;
	options.threads = 3;
	options.progress = [&](size_t done, size_t total) {
		has_grown = has_grown && done > last && total == 500;
		last = done;
	};
	CHECK(parallel_for(500, options, [](size_t) {}));
	CHECK(last == 500);
	CHECK(has_grown);
}

TEST_CASE("a set cancel flag stops the work early and says so") {
	std::atomic<bool> cancel{ false };
	std::atomic<int> done{ 0 };
	WorkOptions options;
	options.threads = 2;
	options.cancel = &cancel;
	CHECK_FALSE(parallel_for(10000, options, [&](size_t) {
		if (++done == 10) {
			cancel = true;
		}
	}));
	CHECK(done < 20);
}
