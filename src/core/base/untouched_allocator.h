#pragma once

#include <memory>
#include <new>
#include <type_traits>
#include <utility>

namespace pcg {

// What a vector gets by resize() keeps whatever is in its memory, for whoever writes all of it right afterwards: several threads may, and then they
// share the cost of memory that is touched for the first time.
template <typename T> struct UntouchedAllocator : std::allocator<T> {
	static_assert(std::is_trivially_copyable_v<T>);

	template <typename Other> struct rebind {
		using other = UntouchedAllocator<Other>;
	};
	void construct(T *) noexcept {}
	template <typename... Args> void construct(T *place, Args &&...args) { ::new (static_cast<void *>(place)) T(std::forward<Args>(args)...); }
};

} // namespace pcg
