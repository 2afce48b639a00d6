#pragma once

#include <cstdint>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "core/cga/geometry.h"

// The edges of a geometry: neighbours are found by the equal ends of their edges.
namespace pcg::cga {

// One edge of one face; `from` and `to` as the face runs.
struct FaceEdge {
	glm::dvec3 from{ 0.0 }, to{ 0.0 };
	uint32_t face = 0;
	uint32_t order = 0; // among all edges
	uint32_t corner = 0, end_corner = 0; // at `from` and at `to`, in Geometry::points

	static auto key_of(glm::dvec3 p) { return std::tuple(p.x, p.y, p.z); }
	auto key() const {
		const auto a = key_of(from), b = key_of(to);
		return a < b ? std::pair(a, b) : std::pair(b, a);
	}
	bool has_ends_of(const FaceEdge &other) const { return (from == other.from && to == other.to) || (from == other.to && to == other.from); }
};

// Face by face, loop by loop. An edge without faces (two corners) is there once, points are there as edges without length.
std::vector<FaceEdge> face_edges(const Geometry &geometry);
// Edges with equal ends side by side, each group in its original order.
std::vector<FaceEdge> grouped_edges(const Geometry &geometry);
// Every edge, as face_edges() counts them, belongs to two faces. The quick way: every roof is asked, and most are small.
bool has_paired_edges(const Geometry &geometry);

template <typename Use> void for_each_edge_group(const std::vector<FaceEdge> &grouped, Use use) {
	for (size_t i = 0; i < grouped.size();) {
		size_t end = i + 1;
		while (end < grouped.size() && grouped[end].has_ends_of(grouped[i])) {
			++end;
		}
		use(std::span(grouped).subspan(i, end - i));
		i = end;
	}
}

} // namespace pcg::cga
