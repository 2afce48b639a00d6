#include "core/cga/edges.h"

#include <algorithm>
#include <bit>

#include "core/base/random.h"
#include "core/base/small_vector.h"

namespace pcg::cga {

namespace {

struct HashedEdge {
	uint64_t hash; // of both ends
	const glm::dvec3 *from, *to;

	bool has_ends_of(const HashedEdge &other) const { return (*from == *other.from && *to == *other.to) || (*from == *other.to && *to == *other.from); }
};

uint64_t hash_of(glm::dvec3 point) {
	uint64_t hash = 0;
	for (int axis = 0; axis < 3; ++axis) {
		hash = mix64(hash ^ std::bit_cast<uint64_t>(point[axis] + 0.0)); // without the sign of zero
	}
	return hash;
}

size_t edge_count(std::span<const glm::dvec3> loop) { return loop.size() <= 2 ? loop.size() - 1 : loop.size(); } // an edge does not run back

} // namespace

std::vector<FaceEdge> face_edges(const Geometry &geometry) {
	std::vector<FaceEdge> edges;
	edges.reserve(geometry.point_count);
	for (uint32_t f = 0; f < geometry.face_count; ++f) {
		const GeometryFace &face = geometry.faces[f];
		for (uint32_t l = 0; l < face.loop_count; ++l) {
			const auto loop = geometry.loop(face.first_loop + l);
			const uint32_t first = geometry.first_point(face.first_loop + l);
			for (size_t i = 0; i < edge_count(loop); ++i) {
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

bool has_paired_edges(const Geometry &geometry) {
	SmallVector<HashedEdge, 32> edges;
	for (uint32_t l = 0; l < geometry.loop_count; ++l) {
		const auto loop = geometry.loop(l);
		const uint64_t first = hash_of(loop[0]);
		uint64_t from = first;
		for (size_t i = 0; i < edge_count(loop); ++i) {
			const bool is_last = i + 1 == loop.size();
			const uint64_t to = is_last ? first : hash_of(loop[i + 1]);
			edges.push_back({ from + to, &loop[i], &loop[is_last ? 0 : i + 1] });
			from = to;
		}
	}
	std::ranges::sort(edges, {}, &HashedEdge::hash);
	for (size_t i = 0; i < edges.size(); i += 2) {
		const bool is_pair = i + 1 < edges.size() && edges[i].has_ends_of(edges[i + 1]);
		if (!is_pair || (i + 2 < edges.size() && edges[i + 2].hash == edges[i].hash)) {
			return false;
		}
	}
	return edges.size() > 0;
}

} // namespace pcg::cga
