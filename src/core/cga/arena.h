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
		size_t used = 0;
	};

	Mark mark() const { return { _current, _chunks.empty() ? 0 : _chunks[_current].used }; }
	// Everything allocated since the mark is gone; the memory is kept for what comes next.
	void release(Mark mark) {
		for (size_t i = mark.chunk + 1; i < _chunks.size(); ++i) {
			_chunks[i].used = 0;
		}
		_current = mark.chunk;
		if (!_chunks.empty()) {
			_chunks[_current].used = mark.used;
		}
	}

	// Uninitialized. Only for types without destructors that matter.
	template <typename T> T *allocate(size_t count) {
		static_assert(std::is_trivially_destructible_v<T>);
		static_assert(alignof(T) <= alignof(std::max_align_t));
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
	static constexpr size_t first_size = 64 * 1024;
	struct Chunk {
		std::unique_ptr<std::byte[]> memory;
		size_t size = 0;
		size_t used = 0;
	};

	void *take(size_t bytes) {
		bytes = (bytes + alignof(std::max_align_t) - 1) / alignof(std::max_align_t) * alignof(std::max_align_t);
		while (_current < _chunks.size()) {
			Chunk &chunk = _chunks[_current];
			if (chunk.size - chunk.used >= bytes) {
				void *result = chunk.memory.get() + chunk.used;
				chunk.used += bytes;
				return result;
			}
			if (_current + 1 == _chunks.size()) {
				break;
			}
			++_current;
		}
		return take_new(bytes);
	}
	void *take_new(size_t bytes) {
		const size_t wanted = _chunks.empty() ? first_size : 2 * _chunks.back().size;
		const size_t size = wanted > bytes ? wanted : bytes;
		_chunks.push_back({ std::unique_ptr<std::byte[]>(new std::byte[size]), size, bytes });
		_current = _chunks.size() - 1;
		return _chunks.back().memory.get();
	}

	std::vector<Chunk> _chunks;
	size_t _current = 0;
};

} // namespace pcg::cga
