#pragma once

#include <cstddef>
#include <cstring>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

// Memory of a derivation: handed out by moving a pointer, taken back in the reverse order. A rule's shapes live until the last of its
// descendants is done, so the memory in use follows the depth of the tree, not its size.
namespace pcg::cga {

class Arena {
public:
	struct Mark {
		size_t chunk = 0;
		std::byte *next = nullptr; // nullptr: where the chunk begins
	};

	Mark mark() const { return { _current, _next }; }
	// Everything allocated since the mark is gone; the memory is kept for what comes next.
	void release(Mark mark) {
		_current = mark.chunk;
		if (!_chunks.empty()) {
			const Chunk &chunk = _chunks[_current];
			_next = mark.next != nullptr ? mark.next : chunk.memory.get();
			_end = chunk.memory.get() + chunk.size;
		}
	}

	// Uninitialized. Only for types without destructors that matter.
	template <typename T> T *allocate(size_t count) {
		static_assert(std::is_trivially_destructible_v<T>);
		static_assert(alignof(T) <= alignment);
		return static_cast<T *>(take(sizeof(T) * count));
	}
	template <typename T> T *copy(const T *source, size_t count) {
		static_assert(std::is_trivially_copyable_v<T>);
		T *target = allocate<T>(count);
		if (count > 0) {
			std::memcpy(static_cast<void *>(target), source, sizeof(T) * count);
		}
		return target;
	}
	template <typename T> T *make() { return ::new (allocate<T>(1)) T; }
	template <typename T> T *make(const T &value) { return ::new (allocate<T>(1)) T(value); }

	// Bytes kept, used or not.
	size_t capacity() const {
		size_t sum = 0;
		for (const Chunk &chunk : _chunks) {
			sum += chunk.size;
		}
		return sum;
	}

private:
	static constexpr size_t alignment = alignof(std::max_align_t);
	static constexpr size_t first_size = 64 * 1024;
	struct Chunk {
		std::unique_ptr<std::byte[]> memory;
		size_t size = 0;
	};

	void *take(size_t bytes) {
		bytes = (bytes + alignment - 1) / alignment * alignment;
		if (bytes > size_t(_end - _next)) [[unlikely]] {
			find_chunk(bytes);
		}
		void *result = _next;
		_next += bytes;
		return result;
	}
	// The next chunk with so much room, a new one if there is none.
	void find_chunk(size_t bytes);

	std::vector<Chunk> _chunks;
	size_t _current = 0;
	std::byte *_next = nullptr, *_end = nullptr; // of the current chunk
};

// For lists that a block of code needs while it runs: given back at its end.
class ArenaScope {
public:
	explicit ArenaScope(Arena &arena) : _arena(arena), _mark(arena.mark()) {}
	~ArenaScope() { _arena.release(_mark); }
	ArenaScope(const ArenaScope &) = delete;
	ArenaScope &operator=(const ArenaScope &) = delete;

private:
	Arena &_arena;
	Arena::Mark _mark;
};

} // namespace pcg::cga
