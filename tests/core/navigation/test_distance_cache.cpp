#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <thread>
#include <vector>

#include "core/base/random.h"
#include "core/navigation/distance_cache.h"

using namespace pcg;

TEST_CASE("a stored distance is found from both ends, rounded to a centimetre") {
	DistanceCache cache(100);
	CHECK_FALSE(cache.find(BuildingId(3), BuildingId(7)).has_value());
	cache.store(BuildingId(7), BuildingId(3), 12.3456);
	CHECK(*cache.find(BuildingId(3), BuildingId(7)) == 12.35);
	CHECK(*cache.find(BuildingId(7), BuildingId(3)) == DistanceCache::round(12.3456));
	cache.clear();
	CHECK_FALSE(cache.find(BuildingId(3), BuildingId(7)).has_value());
}

TEST_CASE("no way is remembered too, and so is nothing at all") {
	DistanceCache cache(10);
	cache.store(BuildingId(0), BuildingId(1), INFINITY);
	cache.store(BuildingId(0), BuildingId(2), 0.0);
	CHECK(std::isinf(*cache.find(BuildingId(1), BuildingId(0))));
	CHECK(*cache.find(BuildingId(0), BuildingId(2)) == 0.0);
	CHECK(std::isinf(DistanceCache::round(1e9)));
	CHECK(std::isinf(DistanceCache::round(INFINITY)));
}

TEST_CASE("distances of buildings beyond the count are simply not remembered") {
	DistanceCache cache(2);
	cache.store(BuildingId(0), BuildingId(2), 5.0);
	CHECK_FALSE(cache.find(BuildingId(0), BuildingId(2)).has_value());
	cache.store(BuildingId(1), BuildingId(1), 5.0);
	CHECK_FALSE(cache.find(BuildingId(1), BuildingId(1)).has_value());
	CHECK_FALSE(DistanceCache(0).find(BuildingId(0), BuildingId(1)).has_value());
}

TEST_CASE("in cities of any size what is found was stored for the pair") {
	for (const uint32_t count : { 2u, 3u, 10'000u, 46'000u, 47'000u, 1'000'000u }) {
		CAPTURE(count);
		DistanceCache cache(count);
		const auto metres_of = [](uint32_t a, uint32_t b) { return double((uint64_t(a) * 7919 + b) % 900'000) / 100.0; };
		Random random(count);
		std::vector<std::pair<uint32_t, uint32_t>> pairs;
		for (int i = 0; i < 200'000; ++i) {
			const auto a = uint32_t(random.index(count)), b = uint32_t(random.index(count));
			pairs.emplace_back(std::min(a, b), std::max(a, b));
			cache.store(BuildingId(a), BuildingId(b), metres_of(pairs.back().first, pairs.back().second));
		}
		size_t found = 0, wrong = 0, asked = 0;
		for (const auto &[a, b] : pairs) {
			const std::optional<double> metres = cache.find(BuildingId(a), BuildingId(b));
			asked += a != b;
			found += metres.has_value();
			wrong += metres && *metres != metres_of(a, b);
			if (b > a + 1) { // what nobody stored, mostly, beside it
				const std::optional<double> other = cache.find(BuildingId(a), BuildingId(b - 1));
				wrong += other && *other != metres_of(a, b - 1);
			}
		}
		CHECK(wrong == 0);
		CHECK(found > asked * 9 / 10);
	}
}

TEST_CASE("what is too far for a word of four bytes is not remembered, but that there is no way is") {
	DistanceCache cache(10'000);
	cache.store(BuildingId(1), BuildingId(2), 41'000.0);
	CHECK(*cache.find(BuildingId(1), BuildingId(2)) == 41'000.0);
	cache.store(BuildingId(1), BuildingId(3), 42'000.0);
	CHECK_FALSE(cache.find(BuildingId(1), BuildingId(3)).has_value());
	cache.store(BuildingId(1), BuildingId(4), INFINITY);
	CHECK(std::isinf(*cache.find(BuildingId(1), BuildingId(4))));
	DistanceCache wide(1'000'000);
	wide.store(BuildingId(1), BuildingId(999'999), 160'000.0);
	CHECK(*wide.find(BuildingId(1), BuildingId(999'999)) == 160'000.0);
}

TEST_CASE("many pairs on several threads: what is found is right") {
	constexpr uint32_t count = 300;
	DistanceCache cache(count);
	std::atomic<size_t> wrong{ 0 }, found{ 0 };
	const auto work = [&](uint32_t offset) {
		for (uint32_t a = 0; a < count; ++a) {
			for (uint32_t b = 0; b < a; ++b) {
				cache.store(BuildingId(a), BuildingId((b + offset) % a), double(a * 300 + (b + offset) % a));
				const std::optional<double> metres = cache.find(BuildingId(b), BuildingId(a));
				found += metres.has_value();
				wrong += metres && *metres != double(a * 300 + b);
			}
		}
	};
	std::thread other(work, 7);
	work(0);
	other.join();
	CHECK(wrong == 0);
	CHECK(found > 40'000);
}
