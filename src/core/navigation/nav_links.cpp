#include "core/navigation/nav_links.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcg {

namespace {

// Edges that lie side by side differ by at most about 8 degrees.
constexpr float opposite = -0.99f;

void add_both(std::vector<NavGap> &links, uint32_t a, uint32_t b, glm::vec3 left_from_a, glm::vec3 right_from_a) {
	links.push_back({ a, b, left_from_a, right_from_a });
	links.push_back({ b, a, right_from_a, left_from_a });
}

// Joins edges with the same two vertices, and says which edges are left.
std::vector<uint32_t> join_shared(std::span<const NavEdge> edges, std::vector<NavGap> &links) {
	struct Named {
		uint32_t low, high, edge;
	};
	std::vector<Named> named;
	named.reserve(edges.size());
	for (uint32_t i = 0; i < edges.size(); ++i) {
		const auto [low, high] = std::minmax(edges[i].from_name, edges[i].to_name);
		named.push_back({ low, high, i });
	}
	std::sort(named.begin(), named.end(), [](const Named &a, const Named &b) {
		return a.low != b.low ? a.low < b.low : (a.high != b.high ? a.high < b.high : a.edge < b.edge);
	});
	std::vector<uint32_t> left_over;
	for (size_t i = 0; i < named.size();) {
		const bool is_pair = i + 1 < named.size() && named[i].low == named[i + 1].low && named[i].high == named[i + 1].high;
		const NavEdge &edge = edges[named[i].edge];
		if (is_pair && edges[named[i + 1].edge].polygon != edge.polygon) {
			// Who leaves over an edge with the polygon on its left has the edge's end on the left hand.
			add_both(links, edge.polygon, edges[named[i + 1].edge].polygon, edge.to, edge.from);
			i += 2;
		} else {
			left_over.push_back(named[i].edge);
			++i;
		}
	}
	return left_over;
}

// A link where two edges run side by side, if they do.
bool join_side_by_side(const NavEdge &a, const NavEdge &b, const NavMeshOptions &options, std::vector<NavGap> &links) {
	const float ax = a.to.x - a.from.x, az = a.to.z - a.from.z, bx = b.to.x - b.from.x, bz = b.to.z - b.from.z;
	const float length_a = std::hypot(ax, az), length_b = std::hypot(bx, bz);
	if (a.polygon == b.polygon || length_a < options.min_gap || length_b < options.min_gap ||
			(ax * bx + az * bz) / (length_a * length_b) > opposite) {
		return false;
	}
	const auto along_a = [&](glm::vec3 p) { return ((p.x - a.from.x) * ax + (p.z - a.from.z) * az) / length_a; };
	const float low = std::fmax(0.0f, along_a(b.to)), high = std::fmin(length_a, along_a(b.from));
	if (high - low < options.min_gap) {
		return false;
	}
	const auto on_b = [&](glm::vec3 p) {
		const float t = ((p.x - b.from.x) * bx + (p.z - b.from.z) * bz) / (length_b * length_b);
		return b.from + (b.to - b.from) * std::fmin(1.0f, std::fmax(0.0f, t));
	};
	glm::vec3 ends[2];
	for (int i = 0; i < 2; ++i) {
		const glm::vec3 p = a.from + (a.to - a.from) * ((i == 0 ? low : high) / length_a), q = on_b(p);
		if (std::hypot(p.x - q.x, p.z - q.z) > options.margin || std::abs(p.y - q.y) > options.step) {
			return false;
		}
		ends[i] = (p + q) / 2.0f;
	}
	add_both(links, a.polygon, b.polygon, ends[1], ends[0]);
	return true;
}

// Pairs of edges that share a cell of a grid, each pair once.
class NearbyPairs {
public:
	NearbyPairs(std::span<const NavEdge> edges, const std::vector<uint32_t> &chosen, float margin) : _margin(margin) {
		double sum = 0.0;
		for (uint32_t edge : chosen) {
			sum += std::hypot(edges[edge].to.x - edges[edge].from.x, edges[edge].to.z - edges[edge].from.z);
		}
		// About as large as the edges, so that each lies in few cells.
		_cell = std::fmax(4.0f * margin + 0.1f, chosen.empty() ? 1.0f : float(sum / double(chosen.size())));
		for (uint32_t edge : chosen) {
			enter(edge, edges[edge]);
		}
		std::sort(_entries.begin(), _entries.end());
		collect();
	}

	size_t count() const { return _pairs.size(); }
	std::pair<uint32_t, uint32_t> pair(size_t index) const { return { uint32_t(_pairs[index] >> 32), uint32_t(_pairs[index]) }; }

private:
	struct Entry {
		uint64_t cell;
		uint32_t edge;

		bool operator<(const Entry &other) const { return cell != other.cell ? cell < other.cell : edge < other.edge; }
	};

	static uint64_t both(uint32_t a, uint32_t b) { return uint64_t(a) << 32 | b; } // as one number they are sorted much faster
	int32_t cell_of(float coordinate) const { return int32_t(std::floor(coordinate / _cell)); }

	// Goes along the edge column by column, so that a long slanting edge enters the cells near it only.
	void enter(uint32_t edge, const NavEdge &e) {
		const float x0 = std::fmin(e.from.x, e.to.x) - _margin, x1 = std::fmax(e.from.x, e.to.x) + _margin;
		const float slope = e.to.x != e.from.x ? (e.to.z - e.from.z) / (e.to.x - e.from.x) : 0.0f;
		const float z_low = std::fmin(e.from.z, e.to.z), z_high = std::fmax(e.from.z, e.to.z);
		for (int32_t column = cell_of(x0); column <= cell_of(x1); ++column) {
			const float west = float(column) * _cell - _margin, east = float(column + 1) * _cell + _margin;
			float z0 = z_low, z1 = z_high;
			if (std::abs(e.to.x - e.from.x) > _cell) {
				const float za = e.from.z + (west - e.from.x) * slope, zb = e.from.z + (east - e.from.x) * slope;
				z0 = std::fmax(z_low, std::fmin(za, zb));
				z1 = std::fmin(z_high, std::fmax(za, zb));
			}
			for (int32_t row = cell_of(z0 - _margin); row <= cell_of(z1 + _margin); ++row) {
				_entries.push_back({ both(uint32_t(column), uint32_t(row)), edge });
			}
		}
	}

	void collect() {
		for (size_t first = 0, end = 0; first < _entries.size(); first = end) {
			while (end < _entries.size() && _entries[end].cell == _entries[first].cell) {
				++end;
			}
			for (size_t i = first; i < end; ++i) {
				for (size_t j = i + 1; j < end; ++j) {
					_pairs.push_back(both(_entries[i].edge, _entries[j].edge));
				}
			}
		}
		std::sort(_pairs.begin(), _pairs.end());
		_pairs.erase(std::unique(_pairs.begin(), _pairs.end()), _pairs.end());
	}

	float _margin;
	float _cell = 1.0f;
	std::vector<Entry> _entries;
	std::vector<uint64_t> _pairs;
};

} // namespace

std::vector<NavGap> find_links(std::span<const NavEdge> edges, const NavMeshOptions &options) {
	std::vector<NavGap> links;
	const std::vector<uint32_t> left_over = join_shared(edges, links);
	const NearbyPairs pairs(edges, left_over, options.margin);
	for (size_t i = 0; i < pairs.count(); ++i) {
		const auto [a, b] = pairs.pair(i);
		join_side_by_side(edges[a], edges[b], options, links);
	}
	return links;
}

} // namespace pcg
