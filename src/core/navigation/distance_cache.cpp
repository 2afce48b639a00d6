#include "core/navigation/distance_cache.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "core/base/random.h"

namespace pcg {

namespace {

constexpr uint32_t distance_bits = 24;
constexpr uint32_t unreachable = (1u << distance_bits) - 1;
constexpr uint64_t max_buildings = 1u << 20; // two fit into 40 bits
constexpr uint64_t empty = ~0ull; // the key of the last building with itself, which nobody stores
constexpr size_t ways = 8; // slots that a pair may be in: as much as a line of the processor's cache

uint32_t to_centimetres(double metres) {
	const double centimetres = std::floor(metres * 100.0 + 0.5);
	return centimetres >= 0.0 && centimetres < double(unreachable) ? uint32_t(centimetres) : unreachable;
}

double to_metres(uint32_t centimetres) {
	return centimetres == unreachable ? std::numeric_limits<double>::infinity() : double(centimetres) / 100.0;
}

// Room for twice all pairs of a small city; for a large one as much as a building may take.
size_t slot_count(size_t buildings) {
	const size_t pairs = buildings * (buildings - (buildings > 0)) / 2;
	const size_t wanted = std::min({ pairs * 2, std::max<size_t>(buildings * 128, 1 << 17), size_t(8) << 20 });
	return std::bit_ceil(std::max<size_t>(wanted, 16));
}

} // namespace

DistanceCache::DistanceCache(size_t building_count) : _slots(slot_count(building_count)) { clear(); }

double DistanceCache::round(double metres) { return to_metres(to_centimetres(metres)); }

uint64_t DistanceCache::key_of(BuildingId a, BuildingId b) {
	const auto [low, high] = std::minmax({ index_of(a), index_of(b) });
	return high < max_buildings ? uint64_t(low) << 20 | high : empty;
}

size_t DistanceCache::first_slot(uint64_t key) const { return mix64(key) & (_slots.size() - ways); }

std::optional<double> DistanceCache::find(BuildingId a, BuildingId b) const {
	const uint64_t key = key_of(a, b);
	for (size_t i = 0; i < ways && key != empty; ++i) {
		const Word word = _slots[first_slot(key) + i].load(std::memory_order_relaxed);
		if (word >> distance_bits == key) {
			return to_metres(uint32_t(word & unreachable));
		}
	}
	return std::nullopt;
}

void DistanceCache::store(BuildingId a, BuildingId b, double metres) {
	const uint64_t key = key_of(a, b);
	if (key == empty) {
		return;
	}
	// The newest comes first, older ones move up until a free slot or the pair's own old one ends that.
	std::atomic<Word> *slots = &_slots[first_slot(key)];
	Word word = key << distance_bits | to_centimetres(metres);
	for (size_t i = 0; i < ways; ++i) {
		const Word older = slots[i].exchange(word, std::memory_order_relaxed);
		if (older == empty || older >> distance_bits == key) {
			return;
		}
		word = older;
	}
}

void DistanceCache::clear() {
	for (std::atomic<Word> &slot : _slots) {
		slot.store(empty, std::memory_order_relaxed);
	}
}

} // namespace pcg
