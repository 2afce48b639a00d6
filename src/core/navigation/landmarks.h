#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/navigation/nav_mesh.h"

// Estimates of how far it still is, from a few far-off places to which all distances are known (ALT: Goldberg and Harrelson 2005). In a city of
// blocks the straight line is a poor guess; with this one a search looks at a small part of the map only.
namespace pcg {

class Landmarks {
public:
	static constexpr size_t count = 8;
	// What it costs to walk from each landmark to a place, going from middle to middle of gaps.
	struct Costs {
		float to[count] = {};
	};

	Landmarks() = default;
	explicit Landmarks(const NavMesh &mesh);

	const Costs &of_link(uint32_t link) const { return _links[link]; }
	Costs of_point(const NavMesh &mesh, const NavPoint &point) const;
	// About the cost from one place to the other, seldom much more.
	static float estimate(const Costs &a, const Costs &b) {
		static_assert(count == 8);
		float far[4]; // side by side, as processors do it at once
		for (size_t k = 0; k < 4; ++k) {
			far[k] = std::max(std::abs(a.to[k] - b.to[k]), std::abs(a.to[k + 4] - b.to[k + 4]));
		}
		return std::max(std::max(far[0], far[1]), std::max(far[2], far[3]));
	}

private:
	void measure(const NavMesh &mesh, uint32_t from_link, size_t landmark);

	std::vector<Costs> _links;
};

} // namespace pcg
