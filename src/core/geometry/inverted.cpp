#include "core/geometry/inverted.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace pcg {

namespace {

constexpr double most_mitre = 1000.0;

// How far a corner moves outwards while the edges move by 1.
double longest_mitre(const Loop2 &loop) {
	double longest = 1.0;
	for (size_t i = 0; i < loop.size(); ++i) {
		const glm::dvec2 a = loop[i], b = loop[(i + 1) % loop.size()], c = loop[(i + 2) % loop.size()];
		const double scale = glm::distance(a, b) * glm::distance(b, c);
		const double cosine = scale > 0.0 ? glm::dot(b - a, c - b) / scale : 1.0;
		const bool is_inner = (b - a).x * (c - b).y < (b - a).y * (c - b).x;
		longest = std::max(longest, is_inner ? 1.0 : std::sqrt(2.0 / std::max(1.0 + cosine, 1e-12)));
	}
	return longest;
}

} // namespace

bool can_grow(const Loops2 &polygon) { return longest_mitre(polygon[0]) <= most_mitre; }

bool Inverted::is_frame(const SmallVector<uint32_t, 6> &edges) const {
	return std::ranges::all_of(edges, [&](uint32_t edge) { return edge < frame_edges; });
}

SmallVector<double, 8> Inverted::speeds(double speed) const {
	SmallVector<double, 8> result(sources.size(), speed);
	std::fill_n(result.begin(), frame_edges, 0.0);
	return result;
}

Inverted invert(const Loops2 &polygon, double distance) {
	const double reach = 1.1 * longest_mitre(polygon[0]) * distance;
	glm::dvec2 low(polygon[0][0]), high(polygon[0][0]);
	for (const glm::dvec2 &point : polygon[0]) {
		low = glm::min(low, point - reach);
		high = glm::max(high, point + reach);
	}
	Inverted inverted{ { { low, { high.x, low.y }, high, { low.x, high.y } } }, SmallVector<uint32_t, 8>(Inverted::frame_edges, Inverted::no_source) };
	uint32_t first = 0;
	for (const Loop2 &loop : polygon) {
		const uint32_t count = uint32_t(loop.size());
		inverted.loops.emplace_back(loop.rbegin(), loop.rend());
		for (uint32_t i = 0; i < count; ++i) { // edge i of the reversed loop runs from point count-1-i to count-2-i
			inverted.sources.push_back(first + (2 * count - 2 - i) % count);
		}
		first += count;
	}
	return inverted;
}

} // namespace pcg
