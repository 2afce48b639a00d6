#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcg {

// The corners at which a search may go on, the one with the least estimate first. A heap with four children a node: half as deep as with two, and
// the four lie beside each other in memory.
class OpenList {
public:
	struct Entry {
		float estimate;
		uint32_t node;
	};

	bool is_empty() const { return _count == 0; }
	void clear() { _count = 0; }

	void push(Entry entry) {
		if (_count == _entries.size()) {
			grow();
		}
		size_t hole = _count++;
		while (hole > 0 && entry.estimate < _entries[(hole - 1) / 4].estimate) {
			_entries[hole] = _entries[(hole - 1) / 4];
			hole = (hole - 1) / 4;
		}
		_entries[hole] = entry;
	}

	Entry pop() {
		const size_t count = --_count;
		const Entry first = _entries[0], last = _entries[count];
		size_t hole = 0;
		for (size_t child = 1; child < count; child = 4 * hole + 1) {
			const size_t end = child + 4 < count ? child + 4 : count;
			size_t least = child;
			for (++child; child < end; ++child) {
				least = _entries[child].estimate < _entries[least].estimate ? child : least;
			}
			if (last.estimate <= _entries[least].estimate) {
				break;
			}
			_entries[hole] = _entries[least];
			hole = least;
		}
		if (count > 0) {
			_entries[hole] = last;
		}
		return first;
	}

private:
	void grow() { _entries.resize(2 * _entries.size() + 64); }

	std::vector<Entry> _entries; // the first `_count` count
	size_t _count = 0;
};

} // namespace pcg
