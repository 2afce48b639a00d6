#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/ids.h"

// Distances between pairs of buildings that were asked for before. Of fixed size and forgetful: a newer pair may push an older one out. Any
// number of threads may read and write at once without locks, for each entry is one 64-bit word that holds its whole key: a reader sees a
// pair's own distance or nothing. Distances are kept in whole centimetres up to 167 km; round() gives what a distance becomes, so that
// an answer is the same whether it was remembered or not.
namespace pcg {

class DistanceCache {
public:
	// At most 2 KiB a building (1 MiB for small cities) and 64 MiB in all.
	explicit DistanceCache(size_t building_count);

	// The order of the two does not matter.
	std::optional<double> find(BuildingId a, BuildingId b) const;
	void store(BuildingId a, BuildingId b, double metres);
	// Forgets everything; not while other threads use it.
	void clear();

	// To a centimetre; what is too far to be kept, and infinity, becomes infinity.
	static double round(double metres);

private:
	using Word = uint64_t; // 40 bits for the pair, 24 for the distance
	static uint64_t key_of(BuildingId a, BuildingId b);
	size_t first_slot(uint64_t key) const;

	std::vector<std::atomic<Word>> _slots;
};

} // namespace pcg
