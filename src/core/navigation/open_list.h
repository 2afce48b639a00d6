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

	bool is_empty() const { return _entries.empty(); }
	void clear() { _entries.clear(); }

	void push(Entry entry) {
		size_t hole = _entries.size();
		_entries.push_back(entry);
		while (hole > 0 && entry.estimate < _entries[(hole - 1) / 4].estimate) {
			_entries[hole] = _entries[(hole - 1) / 4];
			hole = (hole - 1) / 4;
		}
		_entries[hole] = entry;
	}

	Entry pop() {
		const Entry first = _entries.front(), last = _entries.back();
		_entries.pop_back();
		const size_t count = _entries.size();
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
	std::vector<Entry> _entries;
};

} // namespace pcg
