#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

// The order in which CityEngine's runtime says things: all of one level of the shape tree before the next (CGA reference: func_getTreeKey), where the
// derivation goes into the depth first.
namespace pcg::cga {

class LevelOrder {
public:
	void clear() {
		_places.clear();
		_next = 0;
	}
	// Of the next item, or of one that is said again: what was said on the highest level counts, there what came first.
	void note(size_t item, uint32_t depth) {
		const uint64_t place = (uint64_t(depth) << 40) + std::min(_next++, (uint64_t(1) << 40) - 1);
		if (item == _places.size()) {
			_places.push_back(place);
		} else {
			_places[item] = std::min(_places[item], place);
		}
	}
	template <typename Item> void sort(std::vector<Item> &items) const {
		if (std::ranges::is_sorted(_places)) {
			return;
		}
		std::vector<size_t> order(items.size());
		std::iota(order.begin(), order.end(), size_t(0));
		std::ranges::sort(order, {}, [&](size_t item) { return _places[item]; });
		std::vector<Item> sorted;
		sorted.reserve(items.size());
		for (const size_t item : order) {
			sorted.push_back(std::move(items[item]));
		}
		items = std::move(sorted);
	}

private:
	std::vector<uint64_t> _places; // by item: its level, then when it was said
	uint64_t _next = 0;
};

} // namespace pcg::cga
