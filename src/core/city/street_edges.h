#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/city/street_plan.h"

// Where the edges of carriageways run and meet.
namespace pcg {

class StreetEdges {
public:
	// A street as it leaves a node.
	struct Arm {
		uint32_t street = 0;
		uint32_t other = 0; // the node at its far end
		double angle = 0.0; // radians, counter-clockwise from east
		double half_width = 0.0;
		glm::dvec2 direction{ 0.0 }; // unit
		glm::dvec2 corner{ 0.0 }; // where its left edge meets the right edge of the next arm counter-clockwise
		double cut = 0.0; // metres from the node to where both its edges run free of other streets
	};

	explicit StreetEdges(const StreetPlan &plan);

	std::span<const Arm> arms(uint32_t node) const { return { _arms.data() + _first[node], _first[node + 1] - _first[node] }; } // counter-clockwise
	const Arm &arm(uint32_t node, uint32_t other) const; // of a street that there is
	// How much of a street lies between its two junctions; negative where these overlap.
	double free_length(uint32_t street) const;
	// The streets' outer edge, clockwise: the country lies to its left.
	std::vector<glm::dvec2> outline() const;
	// Nodes at which streets meet too sharply, or whose streets have no free length.
	std::vector<uint32_t> bad_nodes() const;

private:
	void find_corners(uint32_t node);

	const StreetPlan &_plan;
	std::vector<uint32_t> _first; // one more than nodes
	std::vector<Arm> _arms;
};

} // namespace pcg
