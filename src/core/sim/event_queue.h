#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/ids.h"
#include "core/base/sim_time.h"

// Due moments in order of time, then person: a total order, so that runs repeat to the bit. Old entries are not searched for: whoever pops one
// asks whether it still holds.
namespace pcg {

struct Due {
	SimTime time;
	PersonId person = PersonId::Invalid;

	friend bool operator<(const Due &a, const Due &b) { return a.time != b.time ? a.time < b.time : index_of(a.person) < index_of(b.person); }
};

// A heap with four children a node (fewer cache misses than two): for few entries, or those of a short time.
class DueHeap {
public:
	bool is_empty() const { return _heap.empty(); }
	const Due &top() const { return _heap.front(); }
	void push(Due due);
	Due pop();
	// The first one, if it is due by then.
	bool pop_until(SimTime until, Due &due);
	void clear() { _heap.clear(); }

private:
	std::vector<Due> _heap;
};

// A calendar: a bucket for each second of the next hours, where entries wait unsorted, and a heap for the bucket whose time has come. A million
// entries cost about as much as a thousand do, each. What is later than the calendar reaches waits in a heap of its own.
class EventQueue {
public:
	EventQueue() : _pages(bucket_count, none) {}

	void push(Due due);
	// The first one, if it is due by then. The calendar goes on to `until`: what is pushed for before costs more.
	bool pop_until(SimTime until, Due &due);
	// Forgets everything, and begins at that time.
	void clear(SimTime now);

private:
	static constexpr uint32_t none = 0xFFFFFFFF;
	static constexpr int bucket_shift = 10; // 1,024 ms
	static constexpr int64_t bucket_count = 1 << 16; // 18.6 hours
	// Entries of one bucket lie together.
	struct Page {
		static constexpr uint32_t size = 15;
		uint32_t next = none; // of the same bucket, which is full; or the next one that is free
		uint32_t count = 0;
		Due entries[size];
	};

	static int64_t bucket_of(SimTime time) { return time.ms >> bucket_shift; }
	uint32_t &page_of(int64_t bucket) { return _pages[size_t(bucket & (bucket_count - 1))]; }
	uint32_t take_page(uint32_t next);
	void turn_to(int64_t bucket);

	int64_t _bucket = 0; // whose time has come: this and those before are in _near
	DueHeap _near, _far;
	std::vector<uint32_t> _pages; // by bucket, index in _all_pages
	std::vector<Page> _all_pages;
	uint32_t _free = none;
	size_t _waiting = 0; // entries in buckets
};

} // namespace pcg
