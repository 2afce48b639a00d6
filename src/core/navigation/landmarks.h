#pragma once

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
	// About the cost from one place to the other, seldom much more; negative for places close to each other.
	static float estimate(const Costs &a, const Costs &b);

private:
	void measure(const NavMesh &mesh, uint32_t from_link, size_t landmark);

	std::vector<Costs> _links;
};

} // namespace pcg
