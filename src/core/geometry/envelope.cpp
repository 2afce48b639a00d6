#include "core/geometry/envelope.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/geometry/polygon.h"
#include "core/geometry/straight_skeleton.h"

namespace pcg {

namespace {

using Loop3 = std::vector<glm::dvec3>;
using Key = std::tuple<double, double, double>;

Key key_of(glm::dvec3 p) { return { p.x, p.y, p.z }; }

constexpr uint32_t no_edge = UINT32_MAX;

// Edges of faces, directed, of which those that run both ways are gone; traced to loops again.
class OpenEdges {
public:
	void add(const Loop3 &loop, bool is_reversed) {
		for (size_t i = 0; i < loop.size(); ++i) {
			const glm::dvec3 a = loop[i], b = loop[(i + 1) % loop.size()];
			is_reversed ? add(b, a) : add(a, b);
		}
	}
	void add(glm::dvec3 from, glm::dvec3 to) {
		if (from == to) {
			return;
		}
		const auto [begin, end] = _edges.equal_range(key_of(to));
		for (auto at = begin; at != end; ++at) {
			if (at->second.second == from) {
				_edges.erase(at);
				return;
			}
		}
		_edges.emplace(key_of(from), std::pair(from, to));
	}
	const std::multimap<Key, std::pair<glm::dvec3, glm::dvec3>> &edges() const { return _edges; }

	// The next loop from any edge on; empty: there are none left. `is_open`: it did not close.
	Loop3 take_loop(bool &is_open) {
		Loop3 loop;
		for (auto at = _edges.begin(); at != _edges.end(); at = _edges.find(key_of(loop.back()))) {
			const glm::dvec3 to = at->second.second;
			if (loop.empty()) {
				loop.push_back(at->second.first);
			}
			_edges.erase(at);
			if (to == loop[0]) {
				return loop;
			}
			loop.push_back(to);
		}
		is_open |= !loop.empty();
		return loop;
	}

private:
	std::multimap<Key, std::pair<glm::dvec3, glm::dvec3>> _edges;
};

class Builder {
public:
	Builder(const Loops2 &polygon, const std::vector<EnvelopeSide> &sides, double max_height) : _polygon(polygon), _sides(sides), _max(max_height) {
		for (const Loop2 &loop : polygon) {
			for (size_t i = 0; i < loop.size(); ++i) {
				_lines.push_back({ loop[i], loop[(i + 1) % loop.size()] });
			}
		}
		_slopes.resize(_lines.size());
	}

	Envelope run() {
		add_bottom();
		rise();
		add_walls_and_slopes();
		for (EnvelopeFace &top : _tops) {
			_result.faces.push_back(std::move(top));
		}
		return std::move(_result);
	}

private:
	struct Line {
		glm::dvec2 from, to;
	};
	struct Front {
		Loops2 loops;
		std::vector<uint32_t> sources; // of all edges
	};

	double speed(uint32_t source, double height) const {
		if (source == no_edge || height < _sides[source].base_height - 1e-9 || _sides[source].angle >= 90.0) {
			return 0.0;
		}
		return 1.0 / std::tan(std::max(_sides[source].angle, 0.1) * 0.017453292519943295);
	}

	void add_bottom() {
		EnvelopeFace bottom;
		for (const Loop2 &loop : _polygon) {
			bottom.loops.emplace_back();
			for (const glm::dvec2 &point : loop) {
				bottom.loops.back().push_back({ point, 0.0 });
			}
			std::reverse(bottom.loops.back().begin() + 1, bottom.loops.back().end());
			_border.add(bottom.loops.back(), true);
		}
		_result.faces.push_back(std::move(bottom));
	}

	// From one height at which a plane begins to the next.
	void rise() {
		std::vector<double> heights = { _max };
		for (const EnvelopeSide &side : _sides) {
			if (side.base_height > 0.0 && side.base_height < _max && side.angle < 90.0) {
				heights.push_back(side.base_height);
			}
		}
		std::ranges::sort(heights);
		Front front{ _polygon, {} };
		for (uint32_t i = 0; i < _lines.size(); ++i) {
			front.sources.push_back(i);
		}
		double height = 0.0;
		for (const double next : heights) {
			if (next - height > 1e-9 && !front.loops.empty()) {
				front = risen(front, height, next);
				height = next;
			}
		}
		add_tops(front);
	}

	Front risen(const Front &front, double height, double next) {
		std::vector<double> speeds;
		for (const uint32_t source : front.sources) {
			speeds.push_back(speed(source, height));
		}
		if (std::ranges::all_of(speeds, [](double s) { return s == 0.0; })) {
			return front;
		}
		const StraightSkeleton skeleton = straight_skeleton(front.loops, speeds, next - height);
		_result.is_closed &= skeleton.is_complete;
		for (const SkeletonFace &face : skeleton.faces) {
			Loop3 loop;
			for (const SkeletonVertex &vertex : face.outline) {
				loop.push_back({ vertex.position, vertex.time >= next - height ? next : height + vertex.time });
			}
			if (front.sources[face.edge] != no_edge) {
				_slopes[front.sources[face.edge]].add(loop, false);
			}
		}
		Front result;
		for (const SkeletonFront &loop : skeleton.fronts) {
			result.loops.push_back(loop.points);
			for (const uint32_t edge : loop.edges) {
				result.sources.push_back(edge < front.sources.size() ? front.sources[edge] : no_edge);
				_result.is_closed &= edge < front.sources.size();
			}
		}
		return result;
	}

	void add_tops(const Front &front) {
		for (const Loops2 &polygon : group_loops(front.loops)) {
			EnvelopeFace top{ EnvelopeFace::Kind::Top, 0, {} };
			for (const Loop2 &loop : polygon) {
				top.loops.emplace_back();
				for (const glm::dvec2 &point : loop) {
					top.loops.back().push_back({ point, _max });
				}
				_border.add(top.loops.back(), true);
			}
			_tops.push_back(std::move(top));
		}
	}

	void add_walls_and_slopes() {
		std::vector<EnvelopeFace> slopes;
		for (uint32_t e = 0; e < _slopes.size(); ++e) {
			bool is_open = false;
			for (Loop3 loop = _slopes[e].take_loop(is_open); !loop.empty() && !is_open; loop = _slopes[e].take_loop(is_open)) {
				_border.add(loop, true);
				slopes.push_back({ EnvelopeFace::Kind::Slope, e, { begun_lowest(loop, e) } });
			}
			_result.is_closed &= !is_open;
		}
		share_border();
		for (uint32_t e = 0; e < _lines.size(); ++e) {
			add_wall(e);
		}
		_result.faces.insert(_result.faces.end(), slopes.begin(), slopes.end());
	}

	// From its eave on, the lowest side that runs along its edge.
	Loop3 begun_lowest(Loop3 loop, uint32_t edge) const {
		const glm::dvec2 along = glm::normalize(_lines[edge].to - _lines[edge].from);
		size_t best = 0;
		double least = INFINITY;
		for (size_t i = 0; i < loop.size(); ++i) {
			const glm::dvec3 way = loop[(i + 1) % loop.size()] - loop[i];
			const double score = loop[i].z + std::abs(way.z) - 1e-3 * glm::dot(along, glm::dvec2(way)) / (glm::length(way) + 1e-300);
			if (score < least) {
				least = score;
				best = i;
			}
		}
		std::ranges::rotate(loop, loop.begin() + std::ptrdiff_t(best));
		return loop;
	}

	// How far from the edge in its line; infinite off the line.
	double distance_in_line(glm::dvec3 point, uint32_t edge) const {
		const Line &line = _lines[edge];
		const glm::dvec2 along = line.to - line.from, way = glm::dvec2(point) - line.from;
		const double length = glm::length(along), at = glm::dot(way, along) / length;
		const bool is_off = std::abs(along.x * way.y - along.y * way.x) > 1e-6 * (1.0 + length) * length;
		return is_off ? INFINITY : std::max({ 0.0, -at, at - length });
	}

	// Sides where bottom, slopes and tops end go to the edge that they stand above. At an inner corner a wall grows beyond its edge, where the
	// plane of its neighbour recedes.
	void share_border() {
		_walls.resize(_lines.size());
		for (const auto &[key, side] : _border.edges()) {
			uint32_t nearest = no_edge;
			double least = INFINITY;
			for (uint32_t e = 0; e < _lines.size(); ++e) {
				const double distance = distance_in_line(side.first, e) + distance_in_line(side.second, e);
				if (distance < least) {
					least = distance;
					nearest = e;
				}
			}
			_result.is_closed &= nearest != no_edge;
			if (nearest != no_edge) {
				_walls[nearest].push_back(side);
			}
		}
	}

	// Joined by upright lines.
	void add_wall(uint32_t edge) {
		std::vector<std::pair<glm::dvec3, glm::dvec3>> &sides = _walls[edge];
		const glm::dvec3 start(_lines[edge].from, 0.0), end(_lines[edge].to, 0.0);
		Loop3 loop = { start, end };
		std::erase_if(sides, [&](const auto &side) { return side.first == start && side.second == end; });
		while (!sides.empty()) {
			const auto distance = [&](const auto &side) {
				return glm::distance(glm::dvec2(side.first), glm::dvec2(loop.back())) + 1e-6 * std::abs(side.first.z - loop.back().z);
			};
			const auto next = std::ranges::min_element(sides, {}, distance);
			for (const glm::dvec3 point : { next->first, next->second }) {
				if (point != loop.back() && point != loop[0]) {
					loop.push_back(point);
				}
			}
			sides.erase(next);
		}
		if (loop.size() >= 3) {
			_result.faces.push_back({ EnvelopeFace::Kind::Wall, edge, { loop } });
		}
	}

	const Loops2 &_polygon;
	const std::vector<EnvelopeSide> &_sides;
	double _max;
	std::vector<Line> _lines; // edges of the polygon
	std::vector<OpenEdges> _slopes; // by edge
	OpenEdges _border; // where bottom, slopes and tops end
	std::vector<std::vector<std::pair<glm::dvec3, glm::dvec3>>> _walls; // of that, by edge
	std::vector<EnvelopeFace> _tops;
	Envelope _result;
};

// Points in the middle of a straight side, which stages leave behind; those in which more than two faces meet stay.
void drop_straight_points(std::vector<EnvelopeFace> &faces) {
	std::map<Key, int> uses, straight_uses;
	const auto is_straight = [](const Loop3 &loop, size_t i) {
		const glm::dvec3 a = loop[(i + loop.size() - 1) % loop.size()] - loop[i], b = loop[(i + 1) % loop.size()] - loop[i];
		return glm::length(glm::cross(a, b)) <= 1e-7 * glm::length(a) * glm::length(b) && glm::dot(a, b) < 0.0;
	};
	const auto for_each = [&](auto use) {
		for (EnvelopeFace &face : faces) {
			for (Loop3 &loop : face.loops) {
				use(loop);
			}
		}
	};
	for_each([&](const Loop3 &loop) {
		for (size_t i = 0; i < loop.size(); ++i) {
			++uses[key_of(loop[i])];
			straight_uses[key_of(loop[i])] += is_straight(loop, i) ? 1 : 0;
		}
	});
	for_each([&](Loop3 &loop) {
		Loop3 kept;
		for (const glm::dvec3 &point : loop) {
			if (point.z == 0.0 || straight_uses[key_of(point)] != uses[key_of(point)]) {
				kept.push_back(point);
			}
		}
		loop = kept.size() >= 3 ? kept : loop;
	});
}

// Faces share the points that they have in common to the last bit, those above each other their place in the plan.
void join_points(std::vector<EnvelopeFace> &faces) {
	constexpr double near = 1e-7;
	std::vector<glm::dvec3> known;
	const auto join = [&](glm::dvec3 &point) {
		for (const glm::dvec3 &other : known) {
			if (std::abs(point.x - other.x) < near && std::abs(point.y - other.y) < near) {
				point = { other.x, other.y, point.z };
				if (std::abs(point.z - other.z) < near) {
					point.z = other.z;
					return;
				}
			}
		}
		known.push_back(point);
	};
	for (EnvelopeFace &face : faces) {
		for (Loop3 &loop : face.loops) {
			std::ranges::for_each(loop, join);
			const auto again = std::ranges::unique(loop);
			loop.erase(again.begin(), again.end());
		}
	}
}

// A point in which a face ends on an upright line becomes a point of the faces beside the line.
void share_upright_points(std::vector<EnvelopeFace> &faces) {
	std::multimap<std::pair<double, double>, double> heights;
	const auto place = [](glm::dvec3 p) { return std::pair(p.x, p.y); };
	for (const EnvelopeFace &face : faces) {
		for (const glm::dvec3 &point : face.loops[0]) {
			heights.emplace(place(point), point.z);
		}
	}
	for (EnvelopeFace &face : faces) {
		Loop3 loop;
		for (size_t i = 0; i < face.loops[0].size(); ++i) {
			const glm::dvec3 from = face.loops[0][i], to = face.loops[0][(i + 1) % face.loops[0].size()];
			loop.push_back(from);
			if (place(from) != place(to)) {
				continue;
			}
			std::vector<double> between;
			const auto [begin, end] = heights.equal_range(place(from));
			std::for_each(begin, end, [&](const auto &entry) { between.push_back(entry.second); });
			std::ranges::sort(between);
			if (to.z < from.z) {
				std::ranges::reverse(between);
			}
			for (const double z : between) {
				if ((z - loop.back().z) * (to.z - from.z) > 1e-6 && (to.z - z) * (to.z - from.z) > 1e-6) {
					loop.push_back({ from.x, from.y, z });
				}
			}
		}
		face.loops[0] = std::move(loop);
	}
}

} // namespace

Envelope make_envelope(const Loops2 &polygon, const std::vector<EnvelopeSide> &sides, double max_height) {
	const bool is_crossing = std::ranges::any_of(polygon, [](const Loop2 &loop) { return is_self_intersecting(loop); });
	if (is_crossing || !(max_height > 0.0)) {
		return { {}, false };
	}
	Envelope envelope = Builder(polygon, sides, max_height).run();
	join_points(envelope.faces);
	drop_straight_points(envelope.faces);
	share_upright_points(envelope.faces);
	return envelope;
}

} // namespace pcg
