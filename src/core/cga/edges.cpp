#include "core/cga/edges.h"

#include <algorithm>

#include "core/base/small_vector.h"

namespace pcg::cga {

namespace {

// Looking at all pairs is quicker than sorting up to there.
constexpr uint32_t few_edges = 64;

struct PlainEdge {
	double sum; // of both ends: edges with the same ends have the same, whichever way they run
	const glm::dvec3 *from, *to;

	bool has_ends_of(const PlainEdge &other) const {
		return sum == other.sum && ((*from == *other.to && *to == *other.from) || (*from == *other.from && *to == *other.to));
	}
};

double sum_of(glm::dvec3 from, glm::dvec3 to) {
	const glm::dvec3 sum = from + to;
	return sum.x + 3.0 * sum.y + 7.0 * sum.z;
}

} // namespace

std::vector<FaceEdge> face_edges(const Geometry &geometry) {
	std::vector<FaceEdge> edges;
	edges.reserve(geometry.point_count);
	for_each_face_edge(geometry, [&](const FaceEdge &edge) { edges.push_back(edge); });
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
	if (geometry.point_count > few_edges) {
		const std::vector<FaceEdge> edges = grouped_edges(geometry);
		bool are_pairs = !edges.empty();
		for_each_edge_group(edges, [&](std::span<const FaceEdge> group) { are_pairs &= group.size() == 2; });
		return are_pairs;
	}
	SmallVector<PlainEdge, 32> open; // edges that nobody was found for yet
	SmallVector<PlainEdge, 32> paired;
	for (uint32_t l = 0; l < geometry.loop_count; ++l) {
		const auto loop = geometry.loop(l);
		for (size_t i = 0; i < edge_count(loop); ++i) {
			const glm::dvec3 &from = loop[i], &to = loop[i + 1 < loop.size() ? i + 1 : 0];
			const PlainEdge edge = { sum_of(from, to), &from, &to };
			const auto is_same = [&](const PlainEdge &other) { return other.has_ends_of(edge); };
			const auto found = std::find_if(open.begin(), open.end(), is_same);
			if (found == open.end()) {
				open.push_back(edge);
				continue;
			}
			if (std::any_of(paired.begin(), paired.end(), is_same)) {
				return false;
			}
			paired.push_back(edge);
			*found = open.back();
			open.pop_back();
		}
	}
	return open.empty() && !paired.empty();
}

} // namespace pcg::cga
