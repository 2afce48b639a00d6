#include "core/geometry/bounds_tree.h"

#include <algorithm>
#include <numeric>

#include <glm/common.hpp>

namespace pcg {

void BoundsTree::build(std::span<const Bounds3> boxes) {
	_nodes.clear();
	std::vector<uint32_t> items(boxes.size());
	std::iota(items.begin(), items.end(), 0u);
	if (!items.empty()) {
		_nodes.reserve(2 * items.size());
		add(boxes, items);
	}
}

void BoundsTree::add(std::span<const Bounds3> boxes, std::span<uint32_t> items) {
	Bounds3 box = boxes[items[0]];
	for (const uint32_t item : items) {
		box = { glm::min(box.low, boxes[item].low), glm::max(box.high, boxes[item].high) };
	}
	const size_t node = _nodes.size();
	_nodes.push_back({ box, items.size() == 1 ? items[0] : no_item, 0 });
	if (items.size() > 1) {
		const glm::dvec3 extent = box.high - box.low;
		const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
		const size_t half = items.size() / 2;
		const auto middle = [&](uint32_t item) { return std::pair(boxes[item].low[axis] + boxes[item].high[axis], item); };
		std::ranges::nth_element(items, items.begin() + std::ptrdiff_t(half), {}, middle);
		add(boxes, items.first(half));
		add(boxes, items.subspan(half));
	}
	_nodes[node].skip = uint32_t(_nodes.size());
}

} // namespace pcg
