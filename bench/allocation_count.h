#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>

#include <malloc.h>

// Counts what a program takes from the heap, on all its threads. For one source file of a program: it replaces `new` and `delete` in all of it.
namespace pcg::bench {

struct Heap {
	std::atomic<uint64_t> allocations = 0; // since the start
	std::atomic<size_t> bytes = 0; // now
	std::atomic<size_t> most_bytes = 0; // the largest `bytes` since it was last set
};
inline Heap heap;

} // namespace pcg::bench

void *operator new(size_t size) {
	void *memory = std::malloc(size > 0 ? size : 1);
	if (memory == nullptr) {
		std::abort();
	}
	pcg::bench::Heap &heap = pcg::bench::heap;
	++heap.allocations;
	const size_t bytes = heap.bytes += malloc_usable_size(memory);
	size_t most = heap.most_bytes;
	while (most < bytes && !heap.most_bytes.compare_exchange_weak(most, bytes)) {
	}
	return memory;
}
[[gnu::noinline]] void operator delete(void *memory) noexcept { // in line, compilers take malloc and free for a mismatch
	pcg::bench::heap.bytes -= memory != nullptr ? malloc_usable_size(memory) : 0;
	std::free(memory);
}
void operator delete(void *memory, size_t) noexcept {
	operator delete(memory);
}
