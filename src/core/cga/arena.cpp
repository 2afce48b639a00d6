#include "core/cga/arena.h"

#include <algorithm>

namespace pcg::cga {

void Arena::find_chunk(size_t bytes) {
	const size_t first = _next == nullptr ? 0 : _current + 1;
	const auto found = std::find_if(_chunks.begin() + std::ptrdiff_t(std::min(first, _chunks.size())), _chunks.end(),
			[&](const Chunk &chunk) { return chunk.size >= bytes; });
	_current = size_t(found - _chunks.begin());
	if (found == _chunks.end()) {
		const size_t size = std::max(_chunks.empty() ? first_size : 2 * _chunks.back().size, bytes);
		_chunks.push_back({ std::unique_ptr<std::byte[]>(new std::byte[size]), size });
	}
	_next = _chunks[_current].memory.get();
	_end = _next + _chunks[_current].size;
}

} // namespace pcg::cga
