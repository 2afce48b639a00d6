#include "core/sim/event_queue.h"

#include <algorithm>

namespace pcg {

namespace {
constexpr size_t children = 4;
}

void DueHeap::push(Due due) {
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

Due DueHeap::pop() {
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

bool DueHeap::pop_until(SimTime until, Due &due) {
	if (is_empty() || top().time > until) {
		return false;
	}
	due = pop();
	return true;
}

void EventQueue::push(Due due) {
	const int64_t bucket = bucket_of(due.time);
	if (bucket <= _bucket) {
		_near.push(due);
		return;
	}
	if (bucket - _bucket >= bucket_count) {
		_far.push(due);
		return;
	}
	uint32_t &page = page_of(bucket);
	if (page == none || _all_pages[page].count == Page::size) {
		page = take_page(page);
	}
	Page &open = _all_pages[page];
	open.entries[open.count++] = due;
	++_waiting;
}

uint32_t EventQueue::take_page(uint32_t next) {
	uint32_t page = _free;
	if (page == none) {
		page = uint32_t(_all_pages.size());
		_all_pages.emplace_back();
	} else {
		_free = _all_pages[page].next;
	}
	_all_pages[page].next = next;
	_all_pages[page].count = 0;
	return page;
}

// Everything of this bucket comes near, and everything far that the calendar reaches now gets its place.
void EventQueue::turn_to(int64_t bucket) {
	_bucket = bucket;
	while (!_far.is_empty() && bucket_of(_far.top().time) - _bucket < bucket_count) {
		push(_far.pop());
	}
	uint32_t page = page_of(bucket);
	page_of(bucket) = none;
	while (page != none) {
		Page &full = _all_pages[page];
		for (uint32_t i = 0; i < full.count; ++i) {
			_near.push(full.entries[i]);
		}
		_waiting -= full.count;
		const uint32_t next = full.next;
		full.next = _free;
		_free = page;
		page = next;
	}
}

bool EventQueue::pop_until(SimTime until, Due &due) {
	const int64_t last = bucket_of(until);
	while (_near.is_empty() && _bucket < last) {
		const bool is_far = _waiting == 0; // nothing on the way there
		const int64_t next = is_far ? (_far.is_empty() ? last : bucket_of(_far.top().time)) : _bucket + 1;
		turn_to(std::min(next, last));
	}
	return _near.pop_until(until, due);
}

void EventQueue::clear(SimTime now) {
	_bucket = bucket_of(now);
	_near.clear();
	_far.clear();
	std::fill(_pages.begin(), _pages.end(), none);
	_all_pages.clear();
	_free = none;
	_waiting = 0;
}

} // namespace pcg
