#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

// Counter-based random numbers: a stream is a key, the n-th number is a hash of (key, n). Streams made from (seed, id) do not depend on
// the order of use or on the number of threads, and the whole state is two integers, easily saved. Fixed algorithm and fixed
// distributions: the same on every platform (the standard library's distributions are not).
namespace pcg {

// SplitMix64's finalizer (Steele, Lea, Flood 2014): a bijection that passes the avalanche tests.
constexpr uint64_t mix64(uint64_t x) {
	x += 0x9E3779B97F4A7C15ull;
	x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ull;
	x = (x ^ (x >> 27)) * 0x94D049BB133111EBull;
	return x ^ (x >> 31);
}

// A key for a stream of its own below `seed`; order of the arguments matters.
constexpr uint64_t derive_seed(uint64_t seed, uint64_t id) { return mix64(mix64(seed) ^ (id * 0xD6E8FEB86659FD93ull)); }

// FNV-1a; for names inside seeds, not for hash tables that face untrusted input.
constexpr uint64_t hash_text(std::string_view text) {
	uint64_t hash = 0xCBF29CE484222325ull;
	for (char c : text) {
		hash = (hash ^ uint8_t(c)) * 0x100000001B3ull;
	}
	return hash;
}

class Random {
public:
	constexpr Random() = default;
	constexpr explicit Random(uint64_t key) : _key(key) {}
	constexpr Random(uint64_t seed, uint64_t id) : _key(derive_seed(seed, id)) {}

	constexpr uint64_t next() { return mix64(_key + 0x9E3779B97F4A7C15ull * ++_counter); }
	// Uniform in [0, 1), 53 bits.
	constexpr double uniform() { return double(next() >> 11) * 0x1.0p-53; }
	// Uniform in [low, high); low if they are equal.
	constexpr double uniform(double low, double high) { return low + (high - low) * uniform(); }
	// Uniform in 0 .. count-1; 0 if count is 0. The bias is below count / 2^64.
	constexpr size_t index(size_t count) { return size_t((static_cast<unsigned __int128>(next()) * count) >> 64); }
	constexpr bool chance(double probability) { return uniform() < probability; }

	constexpr uint64_t key() const { return _key; }
	constexpr uint64_t counter() const { return _counter; }
	constexpr void restore(uint64_t key, uint64_t counter) {
		_key = key;
		_counter = counter;
	}

private:
	uint64_t _key = 0;
	uint64_t _counter = 0;
};

} // namespace pcg
