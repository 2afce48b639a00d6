#include "core/cga/edges.h"

#include <algorithm>

namespace pcg::cga {

std::vector<FaceEdge> face_edges(const Geometry &geometry) {
	std::vector<FaceEdge> edges;
	edges.reserve(geometry.point_count);
	for (uint32_t f = 0; f < geometry.face_count; ++f) {
		const GeometryFace &face = geometry.faces[f];
		for (uint32_t l = 0; l < face.loop_count; ++l) {
			const auto loop = geometry.loop(face.first_loop + l);
			const uint32_t first = geometry.first_point(face.first_loop + l);
			const size_t count = loop.size() == 2 ? 1 : loop.size(); // an edge does not run back
			for (size_t i = 0; i < count; ++i) {
				const size_t next = (i + 1) % loop.size();
				edges.push_back({ loop[i], loop[next], f, uint32_t(edges.size()), first + uint32_t(i), first + uint32_t(next) });
			}
		}
	}
	return edges;
}

std::vector<FaceEdge> grouped_edges(const Geometry &geometry) {
	const std::vector<FaceEdge> edges = face_edges(geometry);
	std::vector<std::pair<decltype(FaceEdge().key()), uint32_t>> keys; // with the place before sorting
	keys.reserve(edges.size());
	for (const FaceEdge &edge : edges) {
		keys.push_back({ edge.key(), uint32_t(keys.size()) });
	}
	std::ranges::sort(keys);
	std::vector<FaceEdge> grouped;
	grouped.reserve(edges.size());
	for (const auto &[key, edge] : keys) {
		grouped.push_back(edges[edge]);
	}
	return grouped;
}

} // namespace pcg::cga
