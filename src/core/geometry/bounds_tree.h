#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace pcg {

struct Bounds3 {
	glm::dvec3 low{ 0.0 }, high{ 0.0 };

	bool meets(const Bounds3 &other) const {
		return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y && other.low.y <= high.y && low.z <= other.high.z &&
				other.low.z <= high.z;
	}
};

// Finds boxes that meet a box: a binary tree of boxes, halved at the median of the longest axis.
class BoundsTree {
public:
	void build(std::span<const Bounds3> boxes);

	// Calls `visit(index)` for boxes that meet it, always in the same order, until it returns true; whether it did.
	template <typename Visit> bool any(glm::dvec3 low, glm::dvec3 high, Visit visit) const {
		const Bounds3 box = { low, high };
		for (uint32_t at = 0; at < _nodes.size();) {
			const Node &node = _nodes[at];
			if (!node.box.meets(box)) {
				at = node.skip;
				continue;
			}
			if (node.item != no_item && visit(node.item)) {
				return true;
			}
			++at;
		}
		return false;
	}

private:
	static constexpr uint32_t no_item = UINT32_MAX;
	// In depth-first order: `skip` is the node behind all that lie below this one.
	struct Node {
		Bounds3 box;
		uint32_t item = no_item;
		uint32_t skip = 0;
	};

	void add(std::span<const Bounds3> boxes, std::span<uint32_t> items);

	std::vector<Node> _nodes;
};

} // namespace pcg
