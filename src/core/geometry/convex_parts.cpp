#include "core/geometry/convex_parts.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/geometry/polygon.h"
#include "core/geometry/triangulate.h"

namespace pcg {

namespace {

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

double turn(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
	const double scale = glm::distance(a, b) * glm::distance(b, c);
	return scale > 0.0 ? cross(b - a, c - b) / scale : 0.0;
}

bool is_reflex(const Loop2 &loop, size_t i) {
	const size_t count = loop.size();
	return turn(loop[(i + count - 1) % count], loop[i], loop[(i + 1) % count]) < -straight_sine;
}

// Whether the segment a-b crosses an edge of the loop or runs through one of its corners.
bool is_blocked(const Loop2 &loop, glm::dvec2 a, glm::dvec2 b) {
	const glm::dvec2 way = b - a;
	const double length = glm::length(way);
	for (size_t i = 0; i < loop.size(); ++i) {
		const glm::dvec2 c = loop[i], d = loop[(i + 1) % loop.size()];
		if (c != a && c != b) {
			const double at = glm::dot(c - a, way) / length;
			if (at > 0.0 && at < length && std::abs(cross(way, c - a)) <= 1e-9 * length * length) {
				return true;
			}
		}
		const double c_side = cross(way, c - a), d_side = cross(way, d - a);
		const double a_side = cross(d - c, a - c), b_side = cross(d - c, b - c);
		if (c != a && c != b && d != a && d != b && c_side * d_side < 0.0 && a_side * b_side < 0.0) {
			return true;
		}
	}
	return false;
}

// Whether the way from corner i to `target` leads into the polygon.
bool leads_inside(const Loop2 &loop, size_t i, glm::dvec2 target) {
	const size_t count = loop.size();
	const glm::dvec2 before = loop[(i + count - 1) % count], at = loop[i], after = loop[(i + 1) % count];
	const bool is_left_of_after = turn(at, after, target) > straight_sine || (cross(after - at, target - at) > 0.0);
	const bool is_right_of_before = cross(before - at, target - at) < 0.0;
	return is_reflex(loop, i) ? is_left_of_after || is_right_of_before : is_left_of_after && is_right_of_before;
}

// Whether a cut from corner i to `target` leaves no angle above 180 degrees on either side.
bool resolves(const Loop2 &loop, size_t i, glm::dvec2 target) {
	const size_t count = loop.size();
	const glm::dvec2 before = loop[(i + count - 1) % count], at = loop[i], after = loop[(i + 1) % count];
	return turn(before, at, target) >= -straight_sine && turn(target, at, after) >= -straight_sine;
}

struct Cut {
	size_t from = 0, to = 0;
	bool is_lasting = false; // the inner corner is none afterwards
	double length = INFINITY;
	bool is_better_than(const Cut &other) const {
		return is_lasting != other.is_lasting ? is_lasting : length < other.length * (1.0 - 1e-12);
	}
};

Cut best_cut(const Loop2 &loop, double max_length) {
	Cut best;
	const size_t count = loop.size();
	for (size_t i = 0; i < count; ++i) {
		if (!is_reflex(loop, i)) {
			continue;
		}
		for (size_t j = 0; j < count; ++j) {
			const bool is_neighbour = j == i || j == (i + 1) % count || i == (j + 1) % count;
			if (is_neighbour || loop[i] == loop[j]) {
				continue;
			}
			const Cut cut{ std::min(i, j), std::max(i, j), resolves(loop, i, loop[j]), glm::distance(loop[i], loop[j]) };
			if (cut.length < max_length && cut.is_better_than(best) && leads_inside(loop, i, loop[j]) && leads_inside(loop, j, loop[i]) &&
					!is_blocked(loop, loop[i], loop[j])) {
				best = cut;
			}
		}
	}
	return best;
}

// Joins each hole to the outline by the shortest cut that nothing is in the way of. False: one cannot be reached.
bool join_holes(Loops2 polygon, double max_length, Loop2 &loop) {
	loop = polygon[0];
	while (polygon.size() > 1) {
		size_t hole = 0, from = 0, to = 0;
		double shortest = max_length;
		for (size_t h = 1; h < polygon.size(); ++h) {
			for (size_t j = 0; j < polygon[h].size(); ++j) {
				for (size_t i = 0; i < loop.size(); ++i) {
					const glm::dvec2 a = loop[i], b = polygon[h][j];
					const auto blocks = [&](const Loop2 &other) { return is_blocked(other, a, b); };
					if (glm::distance(a, b) < shortest && a != b && leads_inside(loop, i, b) && !is_blocked(loop, a, b) &&
							std::none_of(polygon.begin() + 1, polygon.end(), blocks)) {
						shortest = glm::distance(a, b);
						hole = h;
						from = i;
						to = j;
					}
				}
			}
		}
		if (hole == 0) {
			return false;
		}
		Loop2 bridge(polygon[hole].begin() + std::ptrdiff_t(to), polygon[hole].end());
		bridge.insert(bridge.end(), polygon[hole].begin(), polygon[hole].begin() + std::ptrdiff_t(to) + 1);
		bridge.push_back(loop[from]);
		loop.insert(loop.begin() + std::ptrdiff_t(from) + 1, bridge.begin(), bridge.end());
		if (from == 0) { // begin with the first edge still
			std::ranges::rotate(loop, loop.begin() + std::ptrdiff_t(bridge.size()));
		}
		polygon.erase(polygon.begin() + std::ptrdiff_t(hole), polygon.begin() + std::ptrdiff_t(hole) + 1);
	}
	return true;
}

Polygons2 triangles_of(const Loops2 &polygon) {
	Loop2 points;
	std::vector<uint32_t> ends, indices;
	for (const Loop2 &loop : polygon) {
		points.insert(points.end(), loop.begin(), loop.end());
		ends.push_back(uint32_t(points.size()));
	}
	triangulate(points, ends, indices);
	Polygons2 parts;
	for (size_t i = 0; i + 2 < indices.size(); i += 3) {
		parts.push_back({ { points[indices[i]], points[indices[i + 1]], points[indices[i + 2]] } });
	}
	return parts;
}

} // namespace

Polygons2 convex_parts(const Loops2 &polygon, double max_length) {
	size_t count = 0;
	for (const Loop2 &loop : polygon) {
		count += loop.size();
	}
	if (count > 300) {
		return triangles_of(polygon);
	}
	Loop2 whole;
	if (count < 3 || !join_holes(polygon, max_length, whole)) {
		return { polygon };
	}
	Polygons2 parts;
	std::vector<Loop2> waiting = { whole }; // last first
	while (!waiting.empty()) {
		const Loop2 loop = std::move(waiting.back());
		waiting.pop_back();
		const Cut cut = best_cut(loop, max_length);
		if (cut.from == cut.to) {
			parts.push_back({ loop });
			continue;
		}
		const auto at = [&](size_t i) { return loop.begin() + std::ptrdiff_t(i); };
		Loop2 inner(at(cut.from), at(cut.to) + 1);
		Loop2 outer(at(0), at(cut.from) + 1);
		outer.insert(outer.end(), at(cut.to), loop.end());
		const bool has_first_edge = cut.from > 0; // the outer one
		if (!has_first_edge) {
			std::ranges::rotate(outer, outer.begin() + 1);
		}
		waiting.push_back(has_first_edge ? inner : outer);
		waiting.push_back(has_first_edge ? outer : inner);
	}
	return parts;
}

} // namespace pcg
