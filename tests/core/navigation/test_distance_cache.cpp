#include <doctest/doctest.h>

#include <cmath>
#include <thread>

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

TEST_CASE("ids beyond what a word can hold are simply not remembered") {
	DistanceCache cache(2);
	cache.store(BuildingId(0), BuildingId(1u << 20), 5.0);
	CHECK_FALSE(cache.find(BuildingId(0), BuildingId(1u << 20)).has_value());
	CHECK_FALSE(DistanceCache(0).find(BuildingId(0), BuildingId(1)).has_value());
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
