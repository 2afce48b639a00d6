#include "core/city/street_generators.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include <glm/geometric.hpp>

#include "core/geometry/polygon.h"

namespace pcg {

namespace {

constexpr double least_angle = 50.0 * std::numbers::pi / 180.0; // between a new street and those that it meets
constexpr int tries = 16; // places for a street before the land stays whole
constexpr size_t main_blocks = 6; // land for so many blocks is divided by a main street

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

// Land that is divided by streets until it has about the size of a block. All pieces are convex; their loops hold the nodes of streets on either side.
class Grower {
public:
	explicit Grower(const LayoutParameters &p) :
			_p(p), _block(block_size(p)), _random(derive_seed(p.seed, hash_text("grown streets"))),
			_gap(2.5 * double(main_width(p)) + 2.0) {}

	StreetPlan grow() {
		begin();
		for (size_t i = 0; i < _plan.blocks.size();) {
			i += divide(uint32_t(i)) ? 0 : 1;
		}
		for (const auto &[ends, width] : _widths) {
			_plan.streets.push_back({ ends.first, ends.second, width });
		}
		return std::move(_plan);
	}

private:
	using Ends = std::pair<uint32_t, uint32_t>;
	// Where a new street meets the outline of its land: a node that is there, or a new one on the side after node `side` of the loop.
	struct Meeting {
		size_t side = 0;
		glm::dvec2 point{ 0.0 };
		bool is_node = false;
	};

	// Land with cut corners; too little land keeps its corners.
	void begin() {
		const double width = _block.x * _p.blocks_x, depth = _block.y * _p.blocks_z, side = std::min(width, depth);
		const double x = width / 2.0, y = depth / 2.0;
		if (side < 4.0 * _gap) {
			_plan.nodes = { { -x, -y }, { x, -y }, { x, y }, { -x, y } };
		} else {
			double c[8];
			for (double &cut : c) {
				cut = _random.uniform(std::max(_gap, 0.12 * side), 0.3 * side);
			}
			_plan.nodes = { { -x + c[0], -y }, { x - c[1], -y }, { x, -y + c[2] }, { x, y - c[3] }, { x - c[4], y }, { -x + c[5], y },
				{ -x, y - c[6] }, { -x, -y + c[7] } };
		}
		const uint32_t count = uint32_t(_plan.nodes.size());
		StreetPlan::Block land;
		for (uint32_t i = 0; i < count; ++i) {
			land.nodes.push_back(i);
			add_street(i, (i + 1) % count, main_width(_p));
		}
		_plan.blocks.push_back(std::move(land));
		claim(0);
	}

	void add_street(uint32_t a, uint32_t b, float width) { _widths[std::minmax(a, b)] = width; }
	void claim(uint32_t block) {
		const std::vector<uint32_t> &nodes = _plan.blocks[block].nodes;
		for (size_t i = 0; i < nodes.size(); ++i) {
			_left[{ nodes[i], nodes[(i + 1) % nodes.size()] }] = block;
		}
	}

	std::vector<glm::dvec2> outline(uint32_t block) const {
		std::vector<glm::dvec2> points;
		for (uint32_t node : _plan.blocks[block].nodes) {
			points.push_back(_plan.nodes[node]);
		}
		return points;
	}

	// False if the land is small enough, or if no street fits.
	bool divide(uint32_t block) {
		const std::vector<glm::dvec2> land = outline(block);
		const glm::dvec2 axis = long_axis(land);
		const double length = extent(land, axis), depth = extent(land, { -axis.y, axis.x });
		const double along = length / _block.x, across = depth / _block.y;
		if (along < 1.6 && across < 1.6) {
			return false;
		}
		const bool is_main = signed_area(land) / 2.0 > double(main_blocks) * _block.x * _block.y;
		glm::dvec2 middle(0.0);
		for (const glm::dvec2 &corner : land) {
			middle += corner / double(land.size());
		}
		for (int i = 0; i < tries; ++i) {
			const bool is_across = (along >= across) == (i < tries / 2);
			const glm::dvec2 cut = is_across ? glm::dvec2(-axis.y, axis.x) : axis;
			const double turn = _random.uniform(-0.3, 0.3);
			const glm::dvec2 direction{ cut.x * std::cos(turn) - cut.y * std::sin(turn), cut.x * std::sin(turn) + cut.y * std::cos(turn) };
			const double shift = _random.uniform(-0.12, 0.12) * (is_across ? length : depth);
			if (try_street(block, middle + glm::dvec2(-cut.y, cut.x) * shift, direction, is_main ? main_width(_p) : _p.street_width)) {
				return true;
			}
		}
		return false;
	}

	// Direction of the longest straight side.
	static glm::dvec2 long_axis(const std::vector<glm::dvec2> &land) {
		glm::dvec2 best(1.0, 0.0);
		double best_length = 0.0;
		for (size_t i = 0; i < land.size(); ++i) {
			glm::dvec2 side = land[(i + 1) % land.size()] - land[i];
			for (size_t j = i + 1; j < i + land.size(); ++j) {
				const glm::dvec2 next = land[(j + 1) % land.size()] - land[j % land.size()];
				if (std::abs(cross(glm::normalize(side), glm::normalize(next))) > 0.02) {
					break;
				}
				side += next;
			}
			if (glm::length(side) > best_length) {
				best_length = glm::length(side);
				best = side / best_length;
			}
		}
		return best;
	}

	static double extent(const std::vector<glm::dvec2> &land, glm::dvec2 axis) {
		double low = INFINITY, high = -INFINITY;
		for (const glm::dvec2 &corner : land) {
			low = std::min(low, glm::dot(corner, axis));
			high = std::max(high, glm::dot(corner, axis));
		}
		return high - low;
	}

	// In the order in which the line leaves and enters the land.
	std::vector<Meeting> meetings(const std::vector<glm::dvec2> &land, glm::dvec2 origin, glm::dvec2 direction) const {
		std::vector<Meeting> found;
		for (size_t i = 0; i < land.size(); ++i) {
			const size_t next = (i + 1) % land.size();
			const double from = cross(direction, land[i] - origin), to = cross(direction, land[next] - origin);
			if ((from >= 0.0) == (to >= 0.0)) {
				continue;
			}
			const glm::dvec2 point = land[i] + (land[next] - land[i]) * (from / (from - to));
			if (glm::distance(point, land[i]) < _gap) {
				found.push_back({ i, land[i], true });
			} else if (glm::distance(point, land[next]) < _gap) {
				found.push_back({ next, land[next], true });
			} else {
				found.push_back({ i, point, false });
			}
		}
		return found;
	}

	// Between the new street and the two sides of its land; what lies behind them is not nearer than a straight line.
	static bool is_open(const std::vector<glm::dvec2> &land, const Meeting &at, glm::dvec2 towards) {
		const size_t count = land.size();
		const glm::dvec2 street = glm::normalize(towards - at.point), before = land[at.is_node ? (at.side + count - 1) % count : at.side],
						 after = land[(at.side + 1) % count];
		return std::acos(glm::dot(street, glm::normalize(before - at.point))) >= least_angle &&
				std::acos(glm::dot(street, glm::normalize(after - at.point))) >= least_angle;
	}

	bool try_street(uint32_t block, glm::dvec2 origin, glm::dvec2 direction, float width) {
		const std::vector<glm::dvec2> land = outline(block);
		const std::vector<Meeting> ends = meetings(land, origin, direction);
		if (ends.size() != 2 || glm::distance(ends[0].point, ends[1].point) < _gap || !is_open(land, ends[0], ends[1].point) ||
				!is_open(land, ends[1], ends[0].point)) {
			return false;
		}
		const uint32_t from = node_of(block, ends[0]), to = node_of(block, ends[1]);
		add_street(from, to, width);
		std::vector<uint32_t> nodes = _plan.blocks[block].nodes; // with the new nodes
		std::rotate(nodes.begin(), std::find(nodes.begin(), nodes.end(), from), nodes.end());
		const auto middle = std::find(nodes.begin(), nodes.end(), to);
		StreetPlan::Block rest;
		rest.nodes.assign(middle, nodes.end());
		rest.nodes.push_back(from);
		_plan.blocks[block].nodes.assign(nodes.begin(), middle + 1);
		_plan.blocks.push_back(std::move(rest));
		claim(block);
		claim(uint32_t(_plan.blocks.size() - 1));
		return true;
	}

	// A new node goes into the loops on both sides of the street that it lies on.
	uint32_t node_of(uint32_t block, const Meeting &meeting) {
		const std::vector<uint32_t> &nodes = _plan.blocks[block].nodes;
		const auto at = [&](size_t i) { return nodes[i % nodes.size()]; };
		if (meeting.is_node) {
			return *std::min_element(nodes.begin(), nodes.end(), [&](uint32_t a, uint32_t b) {
				return glm::distance(_plan.nodes[a], meeting.point) < glm::distance(_plan.nodes[b], meeting.point);
			});
		}
		size_t side = meeting.side;
		while (!is_between(at(side), at(side + 1), meeting.point)) { // the other end's node may have moved it by one
			++side;
		}
		const uint32_t a = at(side), b = at(side + 1), node = uint32_t(_plan.nodes.size());
		_plan.nodes.push_back(meeting.point);
		const float width = _widths[std::minmax(a, b)];
		_widths.erase(std::minmax(a, b));
		add_street(a, node, width);
		add_street(node, b, width);
		insert(block, a, node);
		if (const auto other = _left.find({ b, a }); other != _left.end()) {
			insert(other->second, b, node);
		}
		return node;
	}

	bool is_between(uint32_t a, uint32_t b, glm::dvec2 point) const {
		const glm::dvec2 from = _plan.nodes[a], along = _plan.nodes[b] - from;
		const double t = glm::dot(point - from, along) / glm::dot(along, along);
		return t > 0.0 && t < 1.0 && glm::distance(from + along * t, point) < 1e-6 * (1.0 + glm::length(along));
	}

	void insert(uint32_t block, uint32_t after, uint32_t node) {
		std::vector<uint32_t> &nodes = _plan.blocks[block].nodes;
		nodes.insert(std::find(nodes.begin(), nodes.end(), after) + 1, node);
		claim(block);
	}

	const LayoutParameters &_p;
	glm::dvec2 _block;
	Random _random;
	double _gap; // metres between two junctions at least
	StreetPlan _plan;
	std::map<Ends, float> _widths; // of streets, by their nodes in ascending order
	std::map<Ends, uint32_t> _left; // the block to the left of each side of a street
};

} // namespace

StreetPlan grown_streets(const LayoutParameters &parameters) { return Grower(parameters).grow(); }

} // namespace pcg
