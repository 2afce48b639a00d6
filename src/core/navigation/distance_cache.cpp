#include "core/navigation/distance_cache.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace pcg {

namespace {

constexpr uint32_t most_distance_bits = 24;
constexpr uint32_t unreachable = (1u << most_distance_bits) - 1; // centimetres; in a word with fewer bits all of them are set
constexpr uint32_t least_distance_bits = 20; // 10 km; whoever walks farther in a city with narrow words is measured anew each time
constexpr uint32_t way_bits = 3;
constexpr size_t ways = 1 << way_bits; // slots that a pair may be in, beside each other in memory
constexpr uint32_t nothing = unreachable + 1; // no centimetres at all
template <typename Word> constexpr Word empty = Word(~Word(0)); // as the last pair of all without a way, which is not remembered

uint32_t to_centimetres(double metres) {
	const double centimetres = std::floor(metres * 100.0 + 0.5);
	return centimetres >= 0.0 && centimetres < double(unreachable) ? uint32_t(centimetres) : unreachable;
}

double to_metres(uint32_t centimetres) {
	return centimetres == unreachable ? std::numeric_limits<double>::infinity() : double(centimetres) / 100.0;
}

// Room for twice all pairs of a small city; for a large one as much as a building may take.
size_t slot_count(uint64_t pairs, uint64_t buildings) {
	const uint64_t most = std::bit_floor(std::clamp<uint64_t>(buildings * 64, 1 << 18, 8 << 20));
	return size_t(std::bit_ceil(std::clamp<uint64_t>(pairs * 2, 2 * ways, most)));
}

// Numbers of so many bits, in another order in which those near each other lie far apart; each comes once.
uint64_t scattered(uint64_t number, uint32_t bits) {
	const uint64_t mask = (uint64_t(1) << bits) - 1;
	const uint32_t half = (bits + 1) / 2;
	for (const uint64_t factor : { 0x9E3779B97F4A7C15, 0xD1B54A32D192ED03 }) { // any odd ones
		number = (number ^ number >> half) * factor & mask;
	}
	return number ^ number >> half;
}

} // namespace

DistanceCache::DistanceCache(size_t building_count) : _building_count(building_count) {
	const uint64_t pairs = _building_count * (_building_count - (_building_count > 0)) / 2;
	const size_t slots = slot_count(pairs, _building_count);
	_set_bits = uint32_t(std::countr_zero(slots)) - way_bits;
	_pair_bits = std::max(uint32_t(std::bit_width(pairs)), _set_bits);
	const uint32_t tag_bits = _pair_bits - _set_bits;
	const bool is_narrow = tag_bits + least_distance_bits <= 32;
	_distance_bits = is_narrow ? std::min(most_distance_bits, 32 - tag_bits) : most_distance_bits;
	_narrow = Slots<uint32_t>(is_narrow ? slots : 0);
	_wide = Slots<uint64_t>(is_narrow ? 0 : slots);
	clear();
}

double DistanceCache::round(double metres) { return to_metres(to_centimetres(metres)); }

bool DistanceCache::is_known(BuildingId a, BuildingId b) const { return a != b && std::max(index_of(a), index_of(b)) < _building_count; }

DistanceCache::Key DistanceCache::key_of(BuildingId a, BuildingId b) const {
	const auto [low, high] = std::minmax<uint64_t>({ index_of(a), index_of(b) });
	const uint64_t number = scattered(high * (high - 1) / 2 + low, _pair_bits);
	return { size_t(number & ((uint64_t(1) << _set_bits) - 1)) << way_bits, number >> _set_bits };
}

template <typename Word> uint32_t DistanceCache::find_in(const Slots<Word> &slots, Key key) const {
	for (size_t i = 0; i < ways; ++i) {
		const Word word = slots[key.first_slot + i].load(std::memory_order_relaxed);
		if (word >> _distance_bits == key.tag && word != empty<Word>) {
			return uint32_t(word & ((Word(1) << _distance_bits) - 1));
		}
	}
	return nothing;
}

std::optional<double> DistanceCache::find(BuildingId a, BuildingId b) const {
	if (!is_known(a, b)) {
		return std::nullopt;
	}
	const uint32_t code = _wide.empty() ? find_in(_narrow, key_of(a, b)) : find_in(_wide, key_of(a, b));
	if (code == nothing) {
		return std::nullopt;
	}
	return to_metres(code == (1u << _distance_bits) - 1 ? unreachable : code);
}

template <typename Word> void DistanceCache::store_in(Slots<Word> &slots, Key key, uint32_t code) const {
	// The newest comes first, older ones move up until a free slot or the pair's own old one ends that.
	auto word = Word(Word(key.tag) << _distance_bits | code);
	for (size_t i = 0; i < ways; ++i) {
		const Word older = slots[key.first_slot + i].exchange(word, std::memory_order_relaxed);
		if (older == empty<Word> || older >> _distance_bits == key.tag) {
			return;
		}
		word = older;
	}
}

void DistanceCache::store(BuildingId a, BuildingId b, double metres) {
	const uint32_t centimetres = to_centimetres(metres), most = (1u << _distance_bits) - 1;
	if (!is_known(a, b) || (centimetres >= most && centimetres != unreachable)) {
		return;
	}
	if (_wide.empty()) {
		store_in(_narrow, key_of(a, b), std::min(centimetres, most));
	} else {
		store_in(_wide, key_of(a, b), std::min(centimetres, most));
	}
}

void DistanceCache::clear() {
	for (std::atomic<uint32_t> &slot : _narrow) {
		slot.store(empty<uint32_t>, std::memory_order_relaxed);
	}
	for (std::atomic<uint64_t> &slot : _wide) {
		slot.store(empty<uint64_t>, std::memory_order_relaxed);
	}
}

} // namespace pcg
