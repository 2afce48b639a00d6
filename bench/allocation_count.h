#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>

#include <malloc.h>

// Counts what a program takes from the heap. For one source file of a program: it replaces `new` and `delete` in all of it.
namespace pcg::bench {

struct Heap {
	uint64_t allocations = 0; // since the start
	size_t bytes = 0; // now
	size_t most_bytes = 0; // the largest `bytes` since it was last set
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
	heap.bytes += malloc_usable_size(memory);
	heap.most_bytes = heap.bytes > heap.most_bytes ? heap.bytes : heap.most_bytes;
	return memory;
}
[[gnu::noinline]] void operator delete(void *memory) noexcept { // in line, compilers take malloc and free for a mismatch
	pcg::bench::heap.bytes -= memory != nullptr ? malloc_usable_size(memory) : 0;
	std::free(memory);
}
void operator delete(void *memory, size_t) noexcept {
	operator delete(memory);
}
