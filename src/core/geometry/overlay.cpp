#include "core/geometry/overlay.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/geometry/polygon.h"

namespace pcg {

namespace {

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

// All edges cut where they meet; between the cuts, how often each input winds more often to the left than to the right.
class Arrangement {
public:
	Arrangement(const Loops2 &first, const Loops2 &second) {
		set_tolerance(first, second);
		add(first, 0);
		add(second, 1);
		cancel_opposites();
		cut_edges();
		merge_pieces();
	}

	std::vector<Loop2> boundary(OverlayKind kind) {
		find_boundary(kind);
		return trace();
	}

private:
	struct Edge {
		uint32_t from, to;
		uint32_t group;
		int count = 1;
	};
	struct Piece {
		uint32_t from, to;
		int winding[2]; // to the left minus to the right
	};
	struct Arrow {
		uint32_t from, to;
		bool is_used = false;
	};

	void set_tolerance(const Loops2 &first, const Loops2 &second) {
		double size = 0.0;
		for (const Loops2 *loops : { &first, &second }) {
			for (const Loop2 &loop : *loops) {
				for (const glm::dvec2 &point : loop) {
					size = std::max(size, std::max(std::abs(point.x - first[0][0].x), std::abs(point.y - first[0][0].y)));
				}
			}
		}
		_tolerance = std::max(1e-12, 1e-7 * size);
	}

	void add(const Loops2 &loops, uint32_t group) {
		for (const Loop2 &loop : loops) {
			for (size_t i = 0; i < loop.size(); ++i) {
				const uint32_t from = point_at(loop[i]), to = point_at(loop[(i + 1) % loop.size()]);
				if (from != to) {
					_edges.push_back({ from, to, group });
				}
			}
		}
	}

	// Neighbours of a surface share edges that run both ways: most of a large input is gone before anything is cut.
	void cancel_opposites() {
		std::map<std::tuple<uint32_t, uint32_t, uint32_t>, int> counts;
		for (const Edge &edge : _edges) {
			counts[{ std::min(edge.from, edge.to), std::max(edge.from, edge.to), edge.group }] += edge.from < edge.to ? 1 : -1;
		}
		_edges.clear();
		for (const auto &[key, count] : counts) {
			const auto [low, high, group] = key;
			if (count != 0) {
				_edges.push_back({ low, high, group, count });
			}
		}
	}

	// The point that is there already, or a new one.
	uint32_t point_at(glm::dvec2 position) {
		const auto cell = [&](double value) { return int64_t(std::floor(value / (4.0 * _tolerance))); };
		for (int64_t dx = -1; dx <= 1; ++dx) {
			for (int64_t dy = -1; dy <= 1; ++dy) {
				const auto [begin, end] = _cells.equal_range({ cell(position.x) + dx, cell(position.y) + dy });
				for (auto at = begin; at != end; ++at) {
					if (glm::distance(_points[at->second], position) <= _tolerance) {
						return at->second;
					}
				}
			}
		}
		_points.push_back(position);
		_cells.emplace(std::pair(cell(position.x), cell(position.y)), uint32_t(_points.size() - 1));
		return uint32_t(_points.size() - 1);
	}

	void cut_edges() {
		_cuts.resize(_edges.size());
		std::vector<uint32_t> order(_edges.size());
		for (uint32_t i = 0; i < order.size(); ++i) {
			order[i] = i;
		}
		const auto low = [&](uint32_t e) { return std::min(_points[_edges[e].from].x, _points[_edges[e].to].x); };
		const auto high = [&](uint32_t e) { return std::max(_points[_edges[e].from].x, _points[_edges[e].to].x); };
		std::ranges::stable_sort(order, {}, low);
		for (size_t i = 0; i < order.size(); ++i) {
			for (size_t j = i + 1; j < order.size() && low(order[j]) <= high(order[i]) + _tolerance; ++j) {
				meet(order[i], order[j]);
			}
		}
	}

	void meet(uint32_t a, uint32_t b) {
		const bool is_first_cut = cut_at_ends(a, b); // both are cut, whatever comes of the first
		const bool was_cut = cut_at_ends(b, a) || is_first_cut;
		const glm::dvec2 start = _points[_edges[a].from], along = _points[_edges[a].to] - start;
		const glm::dvec2 other_start = _points[_edges[b].from], other_along = _points[_edges[b].to] - other_start;
		const double sine = cross(along, other_along);
		if (was_cut || std::abs(sine) <= 1e-14 * glm::length(along) * glm::length(other_along)) {
			return;
		}
		const double at = cross(other_start - start, other_along) / sine, other_at = cross(other_start - start, along) / sine;
		if (at > 0.0 && at < 1.0 && other_at > 0.0 && other_at < 1.0) {
			const uint32_t point = point_at(start + along * at);
			_cuts[a].push_back(point);
			_cuts[b].push_back(point);
		}
	}

	// Cuts `edge` where an end of `other` lies on it. True also if they share an end.
	bool cut_at_ends(uint32_t edge, uint32_t other) {
		bool is_met = false;
		const Edge &e = _edges[edge];
		for (const uint32_t end : { _edges[other].from, _edges[other].to }) {
			if (end == e.from || end == e.to) {
				is_met = true;
				continue;
			}
			const glm::dvec2 along = _points[e.to] - _points[e.from], way = _points[end] - _points[e.from];
			const double length = glm::length(along), at = glm::dot(way, along) / length;
			if (at > 0.0 && at < length && std::abs(cross(along, way)) <= _tolerance * length) {
				_cuts[edge].push_back(end);
				is_met = true;
			}
		}
		return is_met;
	}

	void merge_pieces() {
		std::map<std::pair<uint32_t, uint32_t>, Piece> merged;
		for (uint32_t e = 0; e < _edges.size(); ++e) {
			const Edge &edge = _edges[e];
			std::vector<uint32_t> &chain = _cuts[e];
			const glm::dvec2 start = _points[edge.from], along = _points[edge.to] - start;
			std::ranges::stable_sort(chain, {}, [&](uint32_t p) { return glm::dot(_points[p] - start, along); });
			chain.push_back(edge.to);
			uint32_t at = edge.from;
			for (const uint32_t next : chain) {
				if (next != at) {
					Piece &piece = merged.try_emplace(std::minmax(at, next), Piece{ std::min(at, next), std::max(at, next), { 0, 0 } }).first->second;
					piece.winding[edge.group] += at < next ? edge.count : -edge.count;
					at = next;
				}
			}
		}
		for (const auto &[key, piece] : merged) {
			if (piece.winding[0] != 0 || piece.winding[1] != 0) {
				_pieces.push_back(piece);
			}
		}
	}

	// Turned by an odd angle, so that the rays below run along no edge that people draw.
	static glm::dvec2 turned(glm::dvec2 p) {
		constexpr double cosine = 0.7410911, sine = 0.6714043;
		return { p.x * cosine - p.y * sine, p.x * sine + p.y * cosine };
	}

	void find_boundary(OverlayKind kind) {
		std::vector<glm::dvec2> points;
		for (const glm::dvec2 &point : _points) {
			points.push_back(turned(point));
		}
		for (const Piece &piece : _pieces) {
			const glm::dvec2 a = points[piece.from], b = points[piece.to], middle = 0.5 * (a + b);
			int right[2] = { 0, 0 }; // winding to the side of the ray
			for (const Piece &other : _pieces) {
				const glm::dvec2 c = points[other.from], d = points[other.to];
				if (&other == &piece || (c.y <= middle.y) == (d.y <= middle.y) ||
						c.x + (d.x - c.x) * (middle.y - c.y) / (d.y - c.y) <= middle.x) {
					continue;
				}
				const int sign = d.y > c.y ? 1 : -1;
				right[0] += sign * other.winding[0];
				right[1] += sign * other.winding[1];
			}
			const bool is_upward = b.y > a.y; // then the ray leaves to the right of the piece
			const int sign = is_upward ? 1 : -1;
			const bool ray_side = is_inside(kind, right[0], right[1]);
			const bool far_side = is_inside(kind, right[0] + sign * piece.winding[0], right[1] + sign * piece.winding[1]);
			if (ray_side != far_side) {
				const bool is_forward = far_side == is_upward; // the inside lies to the left
				_arrows.push_back(is_forward ? Arrow{ piece.from, piece.to } : Arrow{ piece.to, piece.from });
			}
		}
	}

	static bool is_inside(OverlayKind kind, int first, int second) {
		switch (kind) {
			case OverlayKind::Union:
				return first > 0 || second > 0;
			case OverlayKind::Difference:
				return first > 0 && second <= 0;
			default:
				return first > 0 && second > 0;
		}
	}

	std::vector<Loop2> trace() {
		std::ranges::stable_sort(_arrows, {}, &Arrow::from);
		std::vector<Loop2> loops;
		for (Arrow &first : _arrows) {
			Loop2 loop;
			for (Arrow *arrow = &first; arrow != nullptr && !arrow->is_used; arrow = next_of(*arrow)) {
				arrow->is_used = true;
				loop.push_back(_points[arrow->from]);
			}
			if (loop.size() >= 3) {
				loops.push_back(std::move(loop));
			}
		}
		return loops;
	}

	// The way on that turns most to the left, so that loops which touch in a point stay apart.
	Arrow *next_of(const Arrow &arrow) {
		const auto begin = std::ranges::lower_bound(_arrows, arrow.to, {}, &Arrow::from);
		const glm::dvec2 arriving = _points[arrow.to] - _points[arrow.from];
		Arrow *best = nullptr;
		double most = -10.0;
		for (auto at = begin; at != _arrows.end() && at->from == arrow.to; ++at) {
			const glm::dvec2 leaving = _points[at->to] - _points[at->from];
			const double turn = at->to == arrow.from ? -9.0 : std::atan2(cross(arriving, leaving), glm::dot(arriving, leaving));
			if (!at->is_used && turn > most) {
				most = turn;
				best = &*at;
			}
		}
		return best;
	}

	double _tolerance = 0.0;
	std::vector<glm::dvec2> _points;
	std::multimap<std::pair<int64_t, int64_t>, uint32_t> _cells;
	std::vector<Edge> _edges;
	std::vector<std::vector<uint32_t>> _cuts; // of each edge
	std::vector<Piece> _pieces;
	std::vector<Arrow> _arrows;
};

} // namespace

Polygons2 overlay(const Loops2 &first, const Loops2 &second, OverlayKind kind) {
	if (first.empty() || first[0].empty()) {
		return kind == OverlayKind::Union && !second.empty() ? overlay(second, {}, kind) : Polygons2();
	}
	std::vector<Loop2> loops = Arrangement(first, second).boundary(kind);
	std::ranges::stable_sort(loops, std::greater(), [](const Loop2 &loop) { return signed_area(loop); });
	return group_loops(loops);
}

Polygons2 group_loops(const Loops2 &loops) {
	Polygons2 polygons;
	for (const Loop2 &loop : loops) {
		if (signed_area(loop) > 0.0) {
			polygons.push_back({ loop });
		}
	}
	for (const Loop2 &loop : loops) {
		if (signed_area(loop) >= 0.0) {
			continue;
		}
		const glm::dvec2 probe = 0.5 * (loop[0] + loop[1]);
		Loops2 *owner = nullptr;
		for (Loops2 &polygon : polygons) {
			const bool is_around = contains(polygon[0], probe) && signed_area(polygon[0]) > -signed_area(loop);
			if (is_around && (owner == nullptr || signed_area(polygon[0]) < signed_area((*owner)[0]))) {
				owner = &polygon;
			}
		}
		if (owner != nullptr) {
			owner->push_back(loop);
		}
	}
	return polygons;
}

Loop2 without_straight_points(const Loop2 &loop, double tolerance) {
	Loop2 kept;
	for (size_t i = 0; i < loop.size(); ++i) {
		const glm::dvec2 before = kept.empty() ? loop.back() : kept.back(), after = loop[(i + 1) % loop.size()];
		const double length = glm::distance(before, after);
		if (length == 0.0 || std::abs(cross(after - before, loop[i] - before)) > tolerance * length) {
			kept.push_back(loop[i]);
		}
	}
	return kept.size() >= 3 ? kept : loop;
}

} // namespace pcg
