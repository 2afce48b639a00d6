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

using PointKey = decltype(FaceEdge::key_of(glm::dvec3()));

// Of a loop: an edge without a face (two corners) does not run back, a point has none.
inline size_t edge_count(std::span<const glm::dvec3> loop) { return loop.size() <= 2 ? loop.size() - 1 : loop.size(); }

// Face by face, loop by loop. An edge without faces (two corners) is there once.
template <typename Use> void for_each_face_edge(const Geometry &geometry, Use use) {
	uint32_t order = 0;
	for (uint32_t f = 0; f < geometry.face_count; ++f) {
		const GeometryFace &face = geometry.faces[f];
		for (uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
			const uint32_t first = geometry.first_point(l), end = geometry.loop_ends[l];
			for (uint32_t i = first; i < first + edge_count(geometry.loop(l)); ++i) {
				const uint32_t next = i + 1 < end ? i + 1 : first;
				use(FaceEdge{ geometry.points[i], geometry.points[next], f, order++, i, next });
			}
		}
	}
}
std::vector<FaceEdge> face_edges(const Geometry &geometry);
// Edges with equal ends side by side, each group in its original order.
std::vector<FaceEdge> grouped_edges(const Geometry &geometry);
// Every edge, as face_edges() counts them, belongs to two faces. Every roof is asked.
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
