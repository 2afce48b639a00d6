#pragma once

#include <cstdint>
#include <vector>

#include "core/base/ids.h"
#include "core/base/sim_time.h"

namespace pcg {

// Due moments in order of time, then person: a total order, so that runs repeat to the bit. A heap of 16-byte entries with four children
// a node (fewer cache misses than two). Old entries are not searched for: whoever pops one asks whether it still holds.
class EventQueue {
public:
	struct Due {
		SimTime time;
		PersonId person = PersonId::Invalid;

		friend bool operator<(const Due &a, const Due &b) {
			return a.time != b.time ? a.time < b.time : index_of(a.person) < index_of(b.person);
		}
	};

	bool is_empty() const { return _heap.empty(); }
	size_t size() const { return _heap.size(); }
	const Due &top() const { return _heap.front(); }
	void push(Due due);
	Due pop();
	void clear() { _heap.clear(); }
	void reserve(size_t count) { _heap.reserve(count); }

private:
	std::vector<Due> _heap;
};

} // namespace pcg
