#include "core/geometry/straight_skeleton.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include <glm/geometric.hpp>

#include "core/geometry/wavefront.h"

namespace pcg {

namespace {

using Border = Wavefront::Border;

struct FaceBorder {
	const Border *border = nullptr;
	bool is_used = false;
};

// How far the way turns to the left from one border to the next.
double turn_between(const Wavefront &front, const Border &last, const Border &next) {
	const glm::dvec2 arriving = front.in_face(last.face, last.to) - front.in_face(last.face, last.from);
	const glm::dvec2 leaving = front.in_face(next.face, next.to) - front.in_face(next.face, next.from);
	return std::atan2(arriving.x * leaving.y - arriving.y * leaving.x, glm::dot(arriving, leaving));
}

// The unused border that leaves `node` with the tightest turn to the left, so that a face that touches itself comes out as simple parts.
const Border *next_border(std::span<FaceBorder> borders, const Wavefront &front, const Border &last) {
	FaceBorder *best = nullptr;
	for (FaceBorder &candidate : borders) {
		if (!candidate.is_used && candidate.border->from == last.to &&
				(best == nullptr || turn_between(front, last, *candidate.border) > turn_between(front, last, *best->border))) {
			best = &candidate;
		}
	}
	if (best == nullptr) {
		return nullptr;
	}
	best->is_used = true;
	return best->border;
}

// Closes the outlines of one face from its directed borders. False if they do not close.
bool trace_faces(uint32_t number, std::span<FaceBorder> borders, const Wavefront &front, SmallVector<SkeletonFace, 4> &faces) {
	bool is_closed = true;
	for (FaceBorder &first : borders) {
		if (first.is_used) {
			continue;
		}
		first.is_used = true;
		SkeletonFace face{ number, {} };
		face.outline.reserve(borders.size());
		const Border *border = first.border;
		while (border) {
			const Wavefront::Node &node = front.nodes()[border->from];
			face.outline.push_back({ node.position, node.time });
			if (border->to == first.border->from) {
				break;
			}
			border = next_border(borders, front, *border);
		}
		is_closed &= border != nullptr;
		if (border && face.outline.size() > 2) {
			faces.push_back(std::move(face));
		}
	}
	return is_closed;
}

// The borders face by face, those of one face in their order; `ends` says where those of each face end.
SmallVector<FaceBorder, 32> borders_by_face(const Wavefront &front, SmallVector<uint32_t, 8> &ends) {
	ends.assign(front.face_count() + 1, 0);
	for (const Border &border : front.borders()) {
		++ends[border.face + 1];
	}
	std::partial_sum(ends.begin(), ends.end(), ends.begin());
	SmallVector<FaceBorder, 32> result(front.borders().size());
	for (const Border &border : front.borders()) {
		result[ends[border.face]++].border = &border;
	}
	ends.pop_back();
	return result;
}

StraightSkeleton traced(Wavefront &front, bool is_complete) {
	StraightSkeleton skeleton;
	skeleton.is_complete = is_complete;
	SmallVector<uint32_t, 8> ends;
	SmallVector<FaceBorder, 32> borders = borders_by_face(front, ends);
	skeleton.faces.reserve(front.face_count());
	uint32_t first = 0;
	for (uint32_t face = 0; face < front.face_count(); first = ends[face++]) {
		skeleton.is_complete &= trace_faces(face, std::span(borders).subspan(first, ends[face] - first), front, skeleton.faces);
	}
	skeleton.fronts = std::move(front.fronts());
	return skeleton;
}

bool is_valid_input(const Loops2 &loops, std::span<const double> speeds, double max_time) {
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

StraightSkeleton straight_skeleton(const Loops2 &loops, std::span<const double> speeds, double max_time) {
	StraightSkeleton skeleton;
	if (!is_valid_input(loops, speeds, max_time)) {
		skeleton.is_complete = false;
		return skeleton;
	}
	Wavefront front(loops, speeds);
	const bool is_complete = front.run(max_time);
	if (is_complete) {
		front.finish();
	}
	return traced(front, is_complete);
}

StraightSkeleton late_skeleton(const Loops2 &loops, std::span<const LateEdge> edges, double max_time) {
	SmallVector<double, 8> speeds(edges.size(), 0.0), times = { max_time };
	const bool edges_are_valid = std::ranges::all_of(edges, [](const LateEdge &edge) { return edge.start >= 0.0 && edge.speed > 0.0; });
	if (!edges_are_valid || !is_valid_input(loops, speeds, max_time)) {
		return { {}, {}, false };
	}
	for (const LateEdge &edge : edges) {
		if (edge.start < max_time) {
			times.push_back(edge.start);
		}
	}
	std::ranges::sort(times);
	times.erase(std::ranges::unique(times).begin(), times.end());
	Wavefront front(loops, speeds, true);
	for (const double time : times) {
		if (!front.run(time)) {
			return traced(front, false);
		}
		for (size_t i = 0; i < edges.size(); ++i) {
			speeds[i] = edges[i].start <= time && time < max_time ? edges[i].speed : speeds[i];
		}
		front.set_speeds(speeds);
	}
	front.finish();
	return traced(front, true);
}

} // namespace pcg
