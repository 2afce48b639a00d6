#include "core/geometry/straight_skeleton.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/geometry/wavefront.h"

namespace pcg {

namespace {

using Border = Wavefront::Border;

// The unused border that leaves `node` with the tightest turn to the left, so that a face that touches itself comes out as simple parts.
const Border *next_border(const std::vector<const Border *> &borders, std::vector<bool> &is_used, const Wavefront &front, const Border &last) {
	const auto &nodes = front.nodes();
	const glm::dvec2 arriving = nodes[last.to].position - nodes[last.from].position;
	size_t best = borders.size();
	double best_turn = -10.0;
	for (size_t i = 0; i < borders.size(); ++i) {
		if (is_used[i] || borders[i]->from != last.to) {
			continue;
		}
		const glm::dvec2 leaving = nodes[borders[i]->to].position - nodes[borders[i]->from].position;
		const double turn = std::atan2(arriving.x * leaving.y - arriving.y * leaving.x, glm::dot(arriving, leaving));
		if (turn > best_turn) {
			best_turn = turn;
			best = i;
		}
	}
	if (best == borders.size()) {
		return nullptr;
	}
	is_used[best] = true;
	return borders[best];
}

// Closes the outlines of one edge's face from its directed borders. False if they do not close.
bool trace_faces(uint32_t edge, const std::vector<const Border *> &borders, const Wavefront &front, std::vector<SkeletonFace> &faces) {
	std::vector<bool> is_used(borders.size(), false);
	bool is_closed = true;
	for (size_t first = 0; first < borders.size(); ++first) {
		if (is_used[first]) {
			continue;
		}
		is_used[first] = true;
		SkeletonFace face{ edge, {} };
		const Border *border = borders[first];
		while (border) {
			const Wavefront::Node &node = front.nodes()[border->from];
			face.outline.push_back({ node.position, node.time });
			if (border->to == borders[first]->from) {
				break;
			}
			border = next_border(borders, is_used, front, *border);
		}
		is_closed &= border != nullptr;
		if (border && face.outline.size() > 2) {
			faces.push_back(std::move(face));
		}
	}
	return is_closed;
}

bool is_valid_input(const std::vector<std::vector<glm::dvec2>> &loops, const std::vector<double> &speeds, double max_time) {
	size_t edges = 0;
	for (const auto &loop : loops) {
		edges += loop.size();
		for (const glm::dvec2 &point : loop) {
			if (!std::isfinite(point.x) || !std::isfinite(point.y)) {
				return false;
			}
		}
	}
	const bool speeds_are_valid = std::all_of(speeds.begin(), speeds.end(), [](double s) { return s >= 0.0 && std::isfinite(s); });
	return edges >= 3 && (speeds.empty() || speeds.size() == edges) && speeds_are_valid && max_time >= 0.0;
}

} // namespace

StraightSkeleton straight_skeleton(const std::vector<std::vector<glm::dvec2>> &loops, const std::vector<double> &speeds, double max_time) {
	StraightSkeleton skeleton;
	if (!is_valid_input(loops, speeds, max_time)) {
		skeleton.is_complete = false;
		return skeleton;
	}
	Wavefront front(loops, speeds);
	skeleton.is_complete = front.run(max_time);
	std::vector<std::vector<const Border *>> borders(front.edge_count());
	for (const Border &border : front.borders()) {
		borders[border.edge].push_back(&border);
	}
	for (uint32_t edge = 0; edge < front.edge_count(); ++edge) {
		skeleton.is_complete &= trace_faces(edge, borders[edge], front, skeleton.faces);
	}
	skeleton.fronts = front.fronts();
	return skeleton;
}

} // namespace pcg
