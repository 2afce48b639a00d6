#include "core/sim/event_queue.h"

#include <algorithm>

namespace pcg {

namespace {
constexpr size_t children = 4;
}

void EventQueue::push(Due due) {
	size_t i = _heap.size();
	_heap.push_back(due);
	while (i > 0) {
		const size_t parent = (i - 1) / children;
		if (!(due < _heap[parent])) {
			break;
		}
		_heap[i] = _heap[parent];
		i = parent;
	}
	_heap[i] = due;
}

EventQueue::Due EventQueue::pop() {
	const Due result = _heap.front();
	const Due last = _heap.back();
	_heap.pop_back();
	const size_t count = _heap.size();
	size_t i = 0;
	while (i * children + 1 < count) {
		const size_t first = i * children + 1;
		const size_t end = std::min(first + children, count);
		const size_t least = size_t(std::min_element(_heap.begin() + long(first), _heap.begin() + long(end)) - _heap.begin());
		if (!(_heap[least] < last)) {
			break;
		}
		_heap[i] = _heap[least];
		i = least;
	}
	if (count > 0) {
		_heap[i] = last;
	}
	return result;
}

} // namespace pcg
