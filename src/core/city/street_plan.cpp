#include "core/city/street_plan.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include "core/city/street_edges.h"

namespace pcg {

namespace {

constexpr uint32_t most_cells = 3; // merged to one block
constexpr uint32_t no_block = 0xFFFFFFFF;

// Which block lies to the left of each side of a street, kept true while blocks are merged.
class Merger {
public:
	explicit Merger(StreetPlan &plan) : _plan(plan), _degrees(plan.nodes.size()) {
		for (uint32_t i = 0; i < plan.blocks.size(); ++i) {
			claim(i);
		}
		for (const StreetPlan::Street &street : plan.streets) {
			++_degrees[street.from];
			++_degrees[street.to];
		}
	}

	bool is_inner(const StreetPlan::Street &street) const {
		return left_of(street.from, street.to) != no_block && left_of(street.to, street.from) != no_block;
	}
	// False, and nothing happens, if the street has to stay.
	bool remove(const StreetPlan::Street &street) {
		const uint32_t a = left_of(street.from, street.to), b = left_of(street.to, street.from);
		if (a == b || _degrees[street.from] < 3 || _degrees[street.to] < 3 || _plan.blocks[a].cells + _plan.blocks[b].cells > most_cells ||
				count_shared(a, b) != 1) {
			return false;
		}
		std::vector<uint32_t> &merged = _plan.blocks[a].nodes, &other = _plan.blocks[b].nodes;
		// `merged` runs from .. to `from`; the other block goes on from there back to `to`.
		std::rotate(merged.begin(), std::find(merged.begin(), merged.end(), street.to), merged.end());
		std::rotate(other.begin(), std::find(other.begin(), other.end(), street.from), other.end());
		merged.insert(merged.end(), other.begin() + 1, other.end() - 1);
		_plan.blocks[a].cells += _plan.blocks[b].cells;
		other.clear();
		_left.erase({ street.from, street.to });
		_left.erase({ street.to, street.from });
		--_degrees[street.from];
		--_degrees[street.to];
		claim(a);
		return true;
	}

private:
	uint32_t left_of(uint32_t from, uint32_t to) const {
		const auto found = _left.find({ from, to });
		return found == _left.end() ? no_block : found->second;
	}
	void claim(uint32_t block) {
		const std::vector<uint32_t> &nodes = _plan.blocks[block].nodes;
		for (size_t i = 0; i < nodes.size(); ++i) {
			_left[{ nodes[i], nodes[(i + 1) % nodes.size()] }] = block;
		}
	}
	size_t count_shared(uint32_t a, uint32_t b) const {
		const std::vector<uint32_t> &nodes = _plan.blocks[a].nodes;
		size_t count = 0;
		for (size_t i = 0; i < nodes.size(); ++i) {
			count += left_of(nodes[(i + 1) % nodes.size()], nodes[i]) == b ? 1 : 0;
		}
		return count;
	}

	StreetPlan &_plan;
	std::vector<uint32_t> _degrees;
	std::map<std::pair<uint32_t, uint32_t>, uint32_t> _left;
};

} // namespace

void remove_streets(StreetPlan &plan, double share, Random random) {
	if (!(share > 0.0)) {
		return;
	}
	Merger merger(plan);
	const auto narrowest = std::min_element(plan.streets.begin(), plan.streets.end(), [](const auto &a, const auto &b) { return a.width < b.width; });
	const float width = narrowest == plan.streets.end() ? 0.0f : narrowest->width;
	std::vector<uint32_t> order;
	for (uint32_t i = 0; i < plan.streets.size(); ++i) {
		if (plan.streets[i].width == width && merger.is_inner(plan.streets[i])) {
			order.push_back(i);
		}
	}
	size_t left_to_remove = size_t(std::round(share * double(order.size())));
	for (size_t i = order.size(); i > 1; --i) {
		std::swap(order[i - 1], order[random.index(i)]);
	}
	std::vector<bool> is_removed(plan.streets.size());
	for (size_t i = 0; i < order.size() && left_to_remove > 0; ++i) {
		if (merger.remove(plan.streets[order[i]])) {
			is_removed[order[i]] = true;
			--left_to_remove;
		}
	}
	size_t kept = 0;
	for (size_t i = 0; i < plan.streets.size(); ++i) {
		if (!is_removed[i]) {
			plan.streets[kept++] = plan.streets[i];
		}
	}
	plan.streets.resize(kept);
	std::erase_if(plan.blocks, [](const StreetPlan::Block &block) { return block.nodes.empty(); });
}

void move_nodes(StreetPlan &plan, double distance, Random random) {
	if (!(distance > 0.0)) {
		return;
	}
	const std::vector<glm::dvec2> origins = plan.nodes;
	std::vector<glm::dvec2> moves(origins.size());
	for (size_t i = 0; i < moves.size(); ++i) {
		const double metres = distance * std::sqrt(random.uniform()), angle = random.uniform(0.0, 2.0 * std::numbers::pi);
		moves[i] = metres * glm::dvec2(std::cos(angle), std::sin(angle));
	}
	constexpr int tries = 12;
	for (int i = 0; i <= tries; ++i) {
		for (size_t node = 0; node < moves.size(); ++node) {
			plan.nodes[node] = origins[node] + moves[node];
		}
		const std::vector<uint32_t> bad = StreetEdges(plan).bad_nodes();
		if (bad.empty()) {
			return;
		}
		for (uint32_t node : bad) {
			moves[node] *= i + 1 < tries ? 0.5 : 0.0;
		}
	}
	plan.nodes = origins; // what is too tight even so is not for us to mend
}

} // namespace pcg
