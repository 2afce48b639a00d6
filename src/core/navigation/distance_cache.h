#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/ids.h"

// Distances between pairs of buildings that were asked for before. Of fixed size and forgetful: a newer pair may push an older one out. Any
// number of threads may read and write at once without locks, for each entry is one word that tells its whole pair: a reader sees a pair's own distance or
// nothing. Distances are kept in whole centimetres up to 167 km; round() gives what a distance becomes, so that an answer is the same whether it was
// remembered or not.
namespace pcg {

class DistanceCache {
public:
	// Room for twice all pairs of up to 500 buildings; of more, 2^18 pairs or 32 to 64 a building, whichever is more, up to 64 MiB. A pair takes four bytes; in
	// cities of more than 46,000 buildings, where too few bits would be left for the distance, eight. Four hold distances up to 10 km at least, 41 km among
	// 10,000 buildings; longer ones are not remembered.
	explicit DistanceCache(size_t building_count);

	// The order of the two does not matter. Buildings beyond the count have no distances.
	std::optional<double> find(BuildingId a, BuildingId b) const;
	void store(BuildingId a, BuildingId b, double metres);
	// Forgets everything; not while other threads use it.
	void clear();

	// To a centimetre; what is too far to be kept, and infinity, becomes infinity.
	static double round(double metres);

private:
	// A place for a few pairs, and what tells a pair from all others that have the same place.
	struct Key {
		size_t first_slot;
		uint64_t tag;
	};
	template <typename Word> using Slots = std::vector<std::atomic<Word>>;

	bool is_known(BuildingId a, BuildingId b) const;
	Key key_of(BuildingId a, BuildingId b) const;
	template <typename Word> uint32_t find_in(const Slots<Word> &slots, Key key) const;
	template <typename Word> void store_in(Slots<Word> &slots, Key key, uint32_t code) const;

	uint64_t _building_count;
	uint32_t _pair_bits, _set_bits; // of a pair's number, and those of them that tell its place
	uint32_t _distance_bits; // of a word; the tag lies above them
	Slots<uint32_t> _narrow; // one of the two is empty
	Slots<uint64_t> _wide;
};

} // namespace pcg
