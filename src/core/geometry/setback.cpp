#include "core/geometry/setback.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/geometry/inverted.h"
#include "core/geometry/overlay.h"
#include "core/geometry/polygon.h"
#include "core/geometry/straight_skeleton.h"

namespace pcg {

double area_of(const Loops2 &polygon) {
	double area = 0.0;
	for (const Loop2 &loop : polygon) {
		area += 0.5 * signed_area(loop);
	}
	return area;
}

namespace {

size_t edge_count(const Loops2 &polygon) {
	size_t count = 0;
	for (const Loop2 &loop : polygon) {
		count += loop.size();
	}
	return count;
}

bool is_crossing(const Loops2 &polygon) {
	return std::ranges::any_of(polygon, [](const Loop2 &loop) { return is_self_intersecting(loop); });
}

Setback unmoved(const Loops2 &polygon, bool is_complete) {
	return { {}, { polygon }, is_complete };
}

// A loop with the edge that each of its sides came from.
struct SourcedLoop {
	Loop2 points;
	SmallVector<uint32_t, 6> edges;
	uint32_t first_edge() const { return *std::ranges::min_element(edges); }
};

SourcedLoop begun_at_lowest_edge(SourcedLoop loop) {
	const auto at = std::ranges::min_element(loop.edges) - loop.edges.begin();
	std::ranges::rotate(loop.points, loop.points.begin() + at);
	std::ranges::rotate(loop.edges, loop.edges.begin() + at);
	return loop;
}

Polygons2 polygons_of(SmallVector<SourcedLoop, 1> loops) {
	for (SourcedLoop &loop : loops) {
		loop = begun_at_lowest_edge(std::move(loop));
	}
	if (loops.size() > 1) {
		std::ranges::stable_sort(loops, {}, [](const SourcedLoop &loop) { return loop.edges[0]; });
	}
	Loops2 points;
	for (SourcedLoop &loop : loops) {
		points.push_back(std::move(loop.points));
	}
	return group_loops(points);
}

Loop2 flat(const SkeletonFace &face) {
	Loop2 points;
	for (const SkeletonVertex &vertex : face.outline) {
		points.push_back(vertex.position);
	}
	return points;
}

SmallVector<SetbackStrip, 4> strips_of(const StraightSkeleton &skeleton) {
	SmallVector<SetbackStrip, 4> strips;
	for (size_t i = 0; i < skeleton.faces.size();) {
		const uint32_t edge = skeleton.faces[i].edge;
		Loops2 loops;
		for (; i < skeleton.faces.size() && skeleton.faces[i].edge == edge; ++i) {
			loops.push_back(flat(skeleton.faces[i]));
		}
		for (Loops2 &polygon : group_loops(loops)) {
			strips.push_back({ edge, std::move(polygon) });
		}
	}
	return strips;
}

// Where they do not, events fell together in a way that the skeleton could not follow.
bool adds_up(std::span<const SetbackStrip> strips, const StraightSkeleton &skeleton, double area) {
	double sum = 0.0;
	for (const SetbackStrip &strip : strips) {
		sum += area_of(strip.polygon);
	}
	for (const SkeletonFront &front : skeleton.fronts) {
		sum += 0.5 * signed_area(front.points);
	}
	return skeleton.is_complete && std::abs(sum - area) <= 1e-6 * area;
}

// Where the corners of a triangle or of a convex quadrangle are after one unit of time. False: a side vanishes on the way or almost, or the outline
// is another. The arithmetic is the skeleton's, to the last bit, which finds the same in some hundred steps.
bool move_corners(const Loop2 &loop, std::span<const double> speeds, Loop2 &moved) {
	struct Side {
		glm::dvec2 direction, normal;
	};
	glm::dvec2 low = loop[0], high = loop[0];
	for (const glm::dvec2 &point : loop) {
		low = glm::min(low, point);
		high = glm::max(high, point);
	}
	const double least = 1e-4 * glm::length(high - low); // of lengths and distances: far from all that the skeleton takes for nothing
	SmallVector<Side, 4> sides;
	const size_t count = loop.size();
	for (size_t i = 0; i < count; ++i) {
		const glm::dvec2 way = loop[i + 1 < count ? i + 1 : 0] - loop[i];
		const double length = glm::length(way);
		if (!(length > least) || !(speeds[i] == 0.0 || speeds[i] > least)) {
			return false;
		}
		sides.push_back({ way / length, glm::dvec2(-way.y, way.x) / length });
	}
	for (size_t i = 0; i < count; ++i) {
		const size_t last = i > 0 ? i - 1 : count - 1;
		const Side &before = sides[last], &after = sides[i];
		const double sine = before.direction.x * after.direction.y - before.direction.y * after.direction.x;
		const double cosine = glm::dot(before.direction, after.direction), speed = speeds[last];
		if (!(sine > 0.01)) { // straight on, or to the right
			return false;
		}
		const double along = (speeds[i] - speed * cosine) / -sine;
		const glm::dvec2 velocity =
				speed == speeds[i] ? speed * (before.normal + after.normal) / (1.0 + cosine) : speed * before.normal + along * before.direction;
		moved.push_back(loop[i] + velocity);
	}
	for (size_t i = 0; i < count; ++i) {
		if (!(glm::dot(moved[i + 1 < count ? i + 1 : 0] - moved[i], sides[i].direction) > least)) {
			return false;
		}
	}
	return true;
}

// Most setbacks: of a convex outline that keeps its sides. False: this is another.
bool set_back_plain(const Loops2 &polygon, std::span<const double> distances, Setback &result) {
	const size_t count = polygon[0].size();
	Loop2 moved;
	if (polygon.size() != 1 || count < 3 || count > 4 || !move_corners(polygon[0], distances, moved)) {
		return false;
	}
	for (size_t i = 0; i < count; ++i) {
		const size_t next = i + 1 < count ? i + 1 : 0;
		if (distances[i] > 0.0) {
			SetbackStrip &strip = result.strips.emplace_back();
			strip.edge = uint32_t(i);
			Loop2 &loop = strip.polygon.emplace_back();
			for (const glm::dvec2 &point : { polygon[0][i], polygon[0][next], moved[next], moved[i] }) {
				loop.push_back(point);
			}
		}
	}
	result.rest.emplace_back().push_back(std::move(moved));
	result.is_plain = true;
	return true;
}

// The strips of a plain setback if they lie side by side: along their edges and back, or around a hole. Empty: they do not.
Loops2 chained_strips(const Setback &setback) {
	const auto strip = [&](size_t i) -> const Loop2 & { return setback.strips[i % setback.strips.size()].polygon[0]; };
	const size_t count = setback.strips.size();
	const auto is_neighbor = [&](size_t i) { return strip(i)[1] == strip(i + 1)[0]; };
	size_t first = 0; // of the chain
	size_t gaps = 0;
	for (size_t i = 0; i < count; ++i) {
		if (count == 1 || !is_neighbor(i)) {
			first = (i + 1) % count;
			++gaps;
		}
	}
	if (gaps > 1) {
		return {};
	}
	Loop2 outline, back;
	for (size_t i = first; i < first + count; ++i) {
		outline.push_back(strip(i)[0]);
		back.push_back(strip(i)[3]);
	}
	if (gaps == 1) {
		outline.push_back(strip(first + count - 1)[1]);
		back.push_back(strip(first + count - 1)[2]);
		outline.insert(outline.end(), back.rbegin(), back.rend());
		std::ranges::rotate(outline, std::ranges::find(outline, strip(0)[0]));
		return { outline };
	}
	std::ranges::reverse(back);
	std::ranges::rotate(back, back.end() - 2);
	return { outline, back };
}

// Of any outline, by its skeleton.
Setback set_back_any(const Loops2 &polygon, std::span<const double> distances) {
	if (is_crossing(polygon)) {
		return unmoved(polygon, false);
	}
	StraightSkeleton skeleton = straight_skeleton(polygon, distances, 1.0);
	Setback result;
	result.strips = strips_of(skeleton);
	if (!adds_up(result.strips, skeleton, area_of(polygon))) {
		return unmoved(polygon, false);
	}
	SmallVector<SourcedLoop, 1> loops;
	for (SkeletonFront &front : skeleton.fronts) {
		loops.push_back({ std::move(front.points), std::move(front.edges) });
	}
	result.rest = polygons_of(std::move(loops));
	return result;
}

SourcedLoop turned_back(const SkeletonFront &front, std::span<const uint32_t> sources) {
	SourcedLoop loop;
	const size_t count = front.points.size();
	for (size_t i = 0; i < count; ++i) {
		loop.points.push_back(front.points[count - 1 - i]);
		loop.edges.push_back(sources[front.edges[(2 * count - 2 - i) % count]]);
	}
	return loop;
}

} // namespace

// One result in one place: moving one moves all of its points.
Setback set_back(const Loops2 &polygon, std::span<const double> distances) {
	Setback result;
	const bool is_moving = std::ranges::any_of(distances, [](double d) { return d > 0.0; });
	if (!is_moving || distances.size() != edge_count(polygon)) {
		result.rest = { polygon };
	} else if (!set_back_plain(polygon, distances, result)) {
		result = set_back_any(polygon, distances);
	}
	return result;
}

Polygons2 joined_strips(const Setback &setback) {
	if (setback.is_plain) {
		if (Loops2 chain = chained_strips(setback); !chain.empty()) {
			Polygons2 joined;
			joined.push_back(std::move(chain));
			return joined;
		}
	}
	Loops2 strips;
	for (const SetbackStrip &strip : setback.strips) {
		strips.insert(strips.end(), strip.polygon.begin(), strip.polygon.end());
	}
	return overlay(strips, {}, OverlayKind::Union);
}

Setback grow(const Loops2 &polygon, double distance) {
	if (!(distance > 0.0) || polygon.empty() || polygon[0].empty()) {
		return unmoved(polygon, true);
	}
	if (is_crossing(polygon) || !can_grow(polygon)) {
		return unmoved(polygon, false);
	}
	const Inverted inverted = invert(polygon, distance);
	const StraightSkeleton skeleton = straight_skeleton(inverted.loops, inverted.speeds(distance), 1.0);
	Setback result;
	result.strips = strips_of(skeleton);
	if (!adds_up(result.strips, skeleton, area_of(inverted.loops))) {
		return unmoved(polygon, false);
	}
	for (SetbackStrip &strip : result.strips) { // begins with its edge reversed: as a clockwise one with the edge as it runs
		strip.edge = inverted.sources[strip.edge];
		for (Loop2 &loop : strip.polygon) {
			std::reverse(loop.begin(), loop.end());
			std::rotate(loop.begin(), loop.end() - 2, loop.end());
		}
	}
	std::ranges::stable_sort(result.strips, {}, &SetbackStrip::edge);
	SmallVector<SourcedLoop, 1> loops;
	for (const SkeletonFront &front : skeleton.fronts) {
		if (!inverted.is_frame(front.edges)) {
			loops.push_back(turned_back(front, inverted.sources));
		}
	}
	result.rest = polygons_of(std::move(loops));
	return result;
}

} // namespace pcg
