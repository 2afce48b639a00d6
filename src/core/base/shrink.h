#pragma once

#include <vector>

namespace pcg {

// Gives back the memory that a list has not filled. Its own shrink_to_fit() does nothing in GNU's library where exceptions are off, as in the core.
template <typename T> void shrink(std::vector<T> &list) {
	if (list.capacity() > list.size()) {
		list = std::vector<T>(list.begin(), list.end());
	}
}

} // namespace pcg
