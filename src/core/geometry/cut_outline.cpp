#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/geometry/polygon.h"
#include "core/geometry/roof_planes.h"

namespace pcg {

namespace {

using Loop = Loop2;

constexpr double tiny = 1e-9;

// A run of corners on the positive side, from the cut to the cut.
struct Chain {
	Loop points;
	bool is_used = false;
};

struct Crossing {
	double at;
	size_t chain;
	bool is_enter;
};

class OutlineCutter {
public:
	OutlineCutter(glm::dvec2 normal, double offset) : _normal(normal), _offset(offset) {}

	std::vector<RoofOutline> run(const RoofOutline &outline) {
		for (size_t l = 0; l < outline.size(); ++l) {
			collect(outline[l], l == 0);
		}
		std::ranges::sort(_crossings, [](const Crossing &a, const Crossing &b) { return a.at != b.at ? a.at < b.at : !a.is_enter && b.is_enter; });
		link();
		for (size_t i = 0; i < _chains.size(); ++i) {
			if (!_chains[i].is_used) {
				_pieces.push_back({ around(i) });
			}
		}
		add_holes();
		return std::move(_pieces);
	}

private:
	double distance(glm::dvec2 p) const { return glm::dot(_normal, p) - _offset; }
	double along(glm::dvec2 p) const { return _normal.y * p.x - _normal.x * p.y; } // with the kept side to the left

	glm::dvec2 cut_point(glm::dvec2 a, glm::dvec2 b) const {
		const double da = distance(a), db = distance(b);
		return std::abs(da) <= tiny ? a : std::abs(db) <= tiny ? b : a + (b - a) * (da / (da - db));
	}

	void collect(const Loop &loop, bool is_outline) {
		const size_t count = loop.size();
		const auto is_kept = [&](size_t i) { return distance(loop[i % count]) > tiny; };
		size_t start = 0;
		while (start < count && (is_kept(start) || !is_kept(start + 1))) {
			++start;
		}
		if (start == count) { // it does not come in anywhere
			if (is_kept(0)) {
				is_outline ? _pieces.push_back({ loop }) : _holes.push_back(loop);
			}
			return;
		}
		for (size_t i = start; i < start + count; ++i) {
			const glm::dvec2 a = loop[i % count], b = loop[(i + 1) % count];
			if (!is_kept(i) && is_kept(i + 1)) {
				_chains.push_back({ { cut_point(a, b) }, false });
				_crossings.push_back({ along(_chains.back().points[0]), _chains.size() - 1, true });
			}
			if (is_kept(i + 1)) {
				_chains.back().points.push_back(b);
			}
			if (is_kept(i) && !is_kept(i + 1)) {
				_chains.back().points.push_back(cut_point(a, b));
				_crossings.push_back({ along(_chains.back().points.back()), _chains.size() - 1, false });
			}
		}
	}

	// Where a chain leaves, the cut leads to the next one that comes in.
	void link() {
		_next.resize(_chains.size());
		for (size_t i = 0; i < _next.size(); ++i) {
			_next[i] = i;
		}
		for (size_t i = 0; i + 1 < _crossings.size(); ++i) {
			if (!_crossings[i].is_enter && _crossings[i + 1].is_enter) {
				_next[_crossings[i].chain] = _crossings[i + 1].chain;
			}
		}
	}

	Loop around(size_t first) {
		Loop loop;
		for (size_t at = first; !_chains[at].is_used; at = _next[at]) {
			_chains[at].is_used = true;
			for (const glm::dvec2 point : _chains[at].points) {
				if (loop.empty() || loop.back() != point) {
					loop.push_back(point);
				}
			}
		}
		if (loop.size() > 1 && loop.front() == loop.back()) {
			loop.pop_back();
		}
		return loop;
	}

	void add_holes() {
		for (const Loop &hole : _holes) {
			const auto piece = std::ranges::find_if(_pieces, [&](const RoofOutline &p) { return contains(p[0], hole[0]); });
			if (piece != _pieces.end()) {
				piece->push_back(hole);
			}
		}
	}

	glm::dvec2 _normal;
	double _offset;
	std::vector<Chain> _chains;
	std::vector<Crossing> _crossings;
	std::vector<size_t> _next;
	std::vector<Loop> _holes; // that the cut does not meet
	std::vector<RoofOutline> _pieces;
};

} // namespace

std::vector<RoofOutline> cut_outline(const RoofOutline &outline, glm::dvec2 normal, double offset) { return OutlineCutter(normal, offset).run(outline); }

} // namespace pcg
