#include "core/geometry/triangulate.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "core/geometry/polygon.h"

namespace pcg {

namespace {

class EarCutter {
public:
	EarCutter(std::span<const glm::dvec2> points, std::vector<uint32_t> &triangles) : _points(points), _triangles(triangles) {}

	void run(std::span<const uint32_t> loop_ends) {
		_ring = ordered_loop(0, loop_ends[0], true);
		std::vector<std::vector<uint32_t>> holes;
		for (size_t i = 1; i < loop_ends.size(); ++i) {
			if (loop_ends[i] - loop_ends[i - 1] >= 3) {
				holes.push_back(ordered_loop(loop_ends[i - 1], loop_ends[i], false));
				const auto right_most = std::ranges::max_element(holes.back(), {}, [&](uint32_t p) { return _points[p].x; });
				std::ranges::rotate(holes.back(), right_most);
			}
		}
		// From right to left: each hole sees the outline or a hole that is already part of it.
		std::ranges::stable_sort(holes, std::greater{}, [&](const auto &hole) { return _points[hole.front()].x; });
		for (const auto &hole : holes) {
			bridge(hole);
		}
		cut_ears();
	}

private:
	std::vector<uint32_t> ordered_loop(uint32_t first, uint32_t end, bool is_outline) const {
		std::vector<uint32_t> loop;
		for (uint32_t i = first; i < end; ++i) {
			loop.push_back(i);
		}
		if ((signed_area(_points.subspan(first, end - first)) > 0.0) != is_outline) {
			std::ranges::reverse(loop);
		}
		return loop;
	}

	// Twice the area of the triangle; positive if counter-clockwise.
	double turn(uint32_t a, uint32_t b, uint32_t c) const { return turn(_points[a], _points[b], _points[c]); }
	static double turn(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
		return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
	}

	// Joins the hole to the ring by a double edge between two points that see each other (Eberly, "Triangulation by Ear Clipping", section 4).
	void bridge(const std::vector<uint32_t> &hole) {
		const size_t at = visible_from(_points[hole.front()]);
		std::vector<uint32_t> inserted(hole);
		inserted.push_back(hole.front());
		inserted.push_back(_ring[at]);
		_ring.insert(_ring.begin() + std::ptrdiff_t(at) + 1, inserted.begin(), inserted.end());
	}

	size_t visible_from(glm::dvec2 point) const {
		double nearest = std::numeric_limits<double>::infinity();
		size_t best = 0;
		for (size_t i = 0; i < _ring.size(); ++i) {
			const glm::dvec2 a = _points[_ring[i]];
			const glm::dvec2 b = _points[_ring[(i + 1) % _ring.size()]];
			if (a.y > point.y || b.y < point.y || a.y == b.y) { // the ring's interior lies left of edges that run upwards
				continue;
			}
			const double x = a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x);
			if (x >= point.x && x < nearest) {
				nearest = x;
				best = a.x > b.x ? i : (i + 1) % _ring.size();
			}
		}
		return std::isfinite(nearest) ? nothing_between(point, { nearest, point.y }, best) : best;
	}

	// The reflex point inside the triangle (point, hit, candidate) that lies closest to the ray, or the candidate.
	size_t nothing_between(glm::dvec2 point, glm::dvec2 hit, size_t candidate) const {
		const glm::dvec2 corner = _points[_ring[candidate]];
		size_t best = candidate;
		double best_slope = std::numeric_limits<double>::infinity();
		double best_distance = std::numeric_limits<double>::infinity();
		for (size_t i = 0; i < _ring.size(); ++i) {
			const glm::dvec2 p = _points[_ring[i]];
			if (p == corner || !is_reflex(i) || !is_in_triangle(p, point, hit, corner)) {
				continue;
			}
			const double slope = std::abs(p.y - point.y) / std::max(p.x - point.x, 1e-300);
			const double distance = glm::distance(p, point);
			if (slope < best_slope || (slope == best_slope && distance < best_distance)) {
				best = i;
				best_slope = slope;
				best_distance = distance;
			}
		}
		return best;
	}

	bool is_reflex(size_t i) const {
		const size_t count = _ring.size();
		return turn(_ring[(i + count - 1) % count], _ring[i], _ring[(i + 1) % count]) <= 0.0;
	}

	static bool is_in_triangle(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
		const double ab = turn(a, b, p);
		const double bc = turn(b, c, p);
		const double ca = turn(c, a, p);
		return (ab >= 0.0 && bc >= 0.0 && ca >= 0.0) || (ab <= 0.0 && bc <= 0.0 && ca <= 0.0);
	}

	bool is_ear(size_t i) const {
		const size_t count = _ring.size();
		const size_t before = (i + count - 1) % count;
		const size_t after = (i + 1) % count;
		const glm::dvec2 a = _points[_ring[before]], b = _points[_ring[i]], c = _points[_ring[after]];
		if (turn(a, b, c) <= 0.0) {
			return false;
		}
		for (size_t k = 0; k < count; ++k) {
			const glm::dvec2 p = _points[_ring[k]];
			if (k == before || k == i || k == after || p == a || p == b || p == c) {
				continue;
			}
			if (is_in_triangle(p, a, b, c) && is_reflex(k)) {
				return false;
			}
		}
		return true;
	}

	void cut_ears() {
		size_t at = 0;
		size_t tries = 0;
		while (_ring.size() > 3) {
			at = at % _ring.size();
			const bool gives_up = tries >= _ring.size(); // a self-intersecting outline has no ear: cut something, so that it ends
			if (!gives_up && !is_ear(at)) {
				++at;
				++tries;
				continue;
			}
			cut(gives_up ? flattest() : at);
			tries = 0;
		}
		if (_ring.size() == 3) {
			emit(_ring[0], _ring[1], _ring[2]);
		}
	}

	size_t flattest() const {
		size_t best = 0;
		double least = std::numeric_limits<double>::infinity();
		for (size_t i = 0; i < _ring.size(); ++i) {
			const size_t count = _ring.size();
			const double size = std::abs(turn(_ring[(i + count - 1) % count], _ring[i], _ring[(i + 1) % count]));
			if (size < least) {
				least = size;
				best = i;
			}
		}
		return best;
	}

	void cut(size_t i) {
		const size_t count = _ring.size();
		emit(_ring[(i + count - 1) % count], _ring[i], _ring[(i + 1) % count]);
		_ring.erase(_ring.begin() + std::ptrdiff_t(i));
	}

	void emit(uint32_t a, uint32_t b, uint32_t c) {
		if (turn(a, b, c) > 0.0) {
			_triangles.insert(_triangles.end(), { a, b, c });
		}
	}

	std::span<const glm::dvec2> _points;
	std::vector<uint32_t> &_triangles;
	std::vector<uint32_t> _ring;
};

} // namespace

void triangulate(std::span<const glm::dvec2> points, std::span<const uint32_t> loop_ends, std::vector<uint32_t> &triangles) {
	if (loop_ends.empty() || loop_ends[0] < 3) {
		return;
	}
	if (loop_ends.size() == 1 && is_convex(points.first(loop_ends[0]))) {
		for (uint32_t i = 1; i + 1 < loop_ends[0]; ++i) {
			triangles.insert(triangles.end(), { 0, i, i + 1 });
		}
		return;
	}
	EarCutter(points, triangles).run(loop_ends);
}

} // namespace pcg
