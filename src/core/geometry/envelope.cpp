#include "core/geometry/envelope.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/polygon.h"
#include "core/geometry/straight_skeleton.h"

namespace pcg {

namespace {

LateEdge late_edge(const EnvelopeSide &side) {
	constexpr double least_angle = 0.1;
	if (side.angle >= 90.0) {
		return { INFINITY, 1.0 };
	}
	return { std::max(0.0, side.base_height), 1.0 / std::tan(std::max(side.angle, least_angle) * 0.017453292519943295) };
}

EnvelopeFace bottom_of(const Loops2 &polygon) {
	EnvelopeFace bottom;
	for (const Loop2 &loop : polygon) {
		auto &points = bottom.loops.emplace_back();
		for (const glm::dvec2 &point : loop) {
			points.push_back({ point, 0.0 });
		}
		std::ranges::reverse(points);
		std::rotate(points.begin(), points.end() - 2, points.end()); // the first edge stays the first
	}
	return bottom;
}

Loop2 plan_of(const std::vector<glm::dvec3> &loop) {
	Loop2 plan;
	for (const glm::dvec3 &point : loop) {
		plan.push_back(point);
	}
	return plan;
}

// A slope that went around a hole which stands still has a hole: to the slope of its edge that lies around it.
bool add_as_hole(const EnvelopeFace &hole, std::vector<EnvelopeFace> &faces) {
	if (hole.kind != EnvelopeFace::Kind::Slope || signed_area(plan_of(hole.loops[0])) >= 0.0) {
		return false;
	}
	for (EnvelopeFace &face : faces) {
		if (face.kind == hole.kind && face.edge == hole.edge && contains(plan_of(face.loops[0]), hole.loops[0][0])) {
			face.loops.push_back(hole.loops[0]);
			return true;
		}
	}
	return false;
}

EnvelopeFace side_of(const SkeletonFace &swept, uint32_t edges) {
	const bool is_slope = swept.edge >= edges && swept.edge < 2 * edges;
	EnvelopeFace face{ is_slope ? EnvelopeFace::Kind::Slope : EnvelopeFace::Kind::Wall, is_slope ? swept.edge - edges : swept.edge, { {} } };
	for (const SkeletonVertex &vertex : swept.outline) {
		face.loops[0].push_back({ vertex.position, vertex.time });
	}
	return face;
}

EnvelopeFace top_of(const Loops2 &polygon, double height) {
	EnvelopeFace top{ EnvelopeFace::Kind::Top, 0, {} };
	for (const Loop2 &loop : polygon) {
		auto &points = top.loops.emplace_back();
		for (const glm::dvec2 &point : loop) {
			points.push_back({ point, height });
		}
	}
	return top;
}

} // namespace

Envelope make_envelope(const Loops2 &polygon, const std::vector<EnvelopeSide> &sides, double max_height) {
	const bool is_crossing = std::ranges::any_of(polygon, [](const Loop2 &loop) { return is_self_intersecting(loop); });
	if (is_crossing || !(max_height > 0.0)) {
		return { {}, false };
	}
	std::vector<LateEdge> edges;
	std::ranges::transform(sides, std::back_inserter(edges), late_edge);
	const StraightSkeleton skeleton = late_skeleton(polygon, edges, max_height);
	Envelope envelope{ { bottom_of(polygon) }, skeleton.is_complete };
	for (const SkeletonFace &swept : skeleton.faces) {
		EnvelopeFace side = side_of(swept, uint32_t(sides.size()));
		if (!add_as_hole(side, envelope.faces)) {
			envelope.faces.push_back(std::move(side));
		}
	}
	std::ranges::stable_sort(envelope.faces, {}, &EnvelopeFace::kind); // steps belong to the walls
	Loops2 fronts;
	for (const SkeletonFront &front : skeleton.fronts) {
		fronts.push_back(front.points);
	}
	for (const Loops2 &loops : group_loops(fronts)) {
		envelope.faces.push_back(top_of(loops, max_height));
	}
	return envelope;
}

} // namespace pcg
