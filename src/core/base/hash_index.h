#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/shrink.h"

namespace pcg {

// Finds things of a list, numbered 0, 1, 2 .. in order of adding, by a hash of what they are. Open addressing: adding needs no memory of its own
// except now and then. The hash decides only where is looked, so results do not depend on its order.
class HashIndex {
public:
	static constexpr uint32_t none = UINT32_MAX;

	HashIndex() { clear(); }

	// Memory that many entries needed is given back.
	void clear() {
		_hashes.clear();
		_places.assign(first_size, 0);
		shrink(_places);
	}
	// The number added under this hash for which `is_it(number)` holds, or none.
	template <typename Test> uint32_t find(uint64_t hash, Test is_it) const {
		for (size_t at = hash & (_places.size() - 1); _places[at] != 0; at = (at + 1) & (_places.size() - 1)) {
			const uint32_t number = _places[at] - 1;
			if (_hashes[number] == hash && is_it(number)) {
				return number;
			}
		}
		return none;
	}
	// The next number.
	uint32_t add(uint64_t hash) {
		_hashes.push_back(hash);
		if (2 * _hashes.size() > _places.size()) {
			_places.assign(2 * _places.size(), 0);
			for (uint32_t number = 0; number + 1 < _hashes.size(); ++number) {
				put(number);
			}
		}
		put(uint32_t(_hashes.size()) - 1);
		return uint32_t(_hashes.size()) - 1;
	}

private:
	static constexpr size_t first_size = 64; // a power of two, as all sizes

	void put(uint32_t number) {
		size_t at = _hashes[number] & (_places.size() - 1);
		while (_places[at] != 0) {
			at = (at + 1) & (_places.size() - 1);
		}
		_places[at] = number + 1;
	}

	std::vector<uint64_t> _hashes; // by number
	std::vector<uint32_t> _places; // number + 1; 0: free
};

} // namespace pcg
