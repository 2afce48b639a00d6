#include "core/cga/clip.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <glm/geometric.hpp>

#include "core/geometry/polygon.h"

namespace pcg::cga {

namespace {

constexpr double smallest_cap = 1e-12; // twice its area: what is smaller has none

std::vector<glm::dvec2> flattened(std::span<const glm::dvec3> loop, glm::dvec3 normal) {
	std::vector<glm::dvec2> result;
	for (const glm::dvec3 &point : loop) {
		result.push_back(flatten(point, normal));
	}
	return result;
}

bool is_before(glm::dvec3 a, glm::dvec3 b) {
	return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

} // namespace

void Clipper::add_holes(const Geometry &geometry, const std::vector<glm::dvec3> &outline, glm::dvec3 normal) {
	if (_whole_holes.empty()) {
		return;
	}
	const std::vector<glm::dvec2> flat = flattened(outline, normal);
	for (const uint32_t loop : _whole_holes) {
		const auto points = geometry.loop(loop);
		if (!contains(flat, flatten(points[0], normal))) {
			continue;
		}
		_builder.add_loop(geometry, loop);
	}
}

// The cuts of all faces run around what the plane cuts out of the volume; reversed they are the outline of the cap, which looks away from the
// side that stays. A cap begins with the edge that it shares with the first of the faces around it: so a roof that stands on a cut roof knows which
// of its edges is which. Open bodies are capped as well where their cuts run in circles, such as a roof with overhangs. False if some cuts do not.
bool Clipper::add_caps(const Plane &plane) {
	if (_has_flush_edges) {
		cancel_opposite_cuts();
	}
	for (uint32_t i = 0; i < _cuts.size(); ++i) {
		std::swap(_cuts[i].from, _cuts[i].to);
		_cuts[i].number = i;
	}
	std::erase_if(_cuts, [](const Segment &cut) { return cut.from == cut.to; });
	std::ranges::stable_sort(_cuts, is_before, &Segment::from);
	_order.resize(_cuts.size());
	for (uint32_t i = 0; i < _order.size(); ++i) {
		_order[i] = i;
	}
	std::ranges::sort(_order, {}, [&](uint32_t i) { return _cuts[i].number; });
	std::vector<std::vector<glm::dvec3>> outlines, holes;
	std::vector<glm::dvec3> loop;
	double sum = 0.0;
	bool do_all_close = true;
	for (const uint32_t first : _order) {
		if (_cuts[first].is_used) {
			continue;
		}
		const bool does_close = cap_loop(first, loop);
		do_all_close &= does_close;
		const double size = does_close ? glm::dot(area_vector(loop), -plane.normal) : 0.0;
		if (std::abs(size) < smallest_cap) {
			continue;
		}
		(size > 0.0 ? outlines : holes).push_back(loop);
		sum += size;
	}
	if (sum < 0.0) { // a body that was turned inside out: so is its cap
		std::swap(outlines, holes);
	}
	emit_caps(outlines, holes, -plane.normal);
	return do_all_close;
}

void Clipper::emit_caps(const std::vector<std::vector<glm::dvec3>> &outlines, const std::vector<std::vector<glm::dvec3>> &holes, glm::dvec3 normal) {
	for (const auto &outline : outlines) {
		_builder.add_loop(outline);
		const std::vector<glm::dvec2> flat = holes.empty() ? std::vector<glm::dvec2>() : flattened(outline, normal);
		for (const auto &hole : holes) {
			if (contains(flat, flatten(hole[0], normal))) {
				_builder.add_loop(hole);
			}
		}
		_builder.end_face();
	}
}

bool Clipper::cap_loop(uint32_t first, std::vector<glm::dvec3> &loop) {
	loop = { _cuts[first].from };
	glm::dvec3 at = _cuts[first].to;
	_cuts[first].is_used = true;
	while (at != loop[0]) {
		Segment *next = next_cut(at);
		if (next == nullptr) {
			return glm::distance(at, loop[0]) <= _margin;
		}
		loop.push_back(at);
		at = next->to;
		next->is_used = true;
	}
	return true;
}

// Faces that share an edge are cut in the same place to the bit. At open edges that only lie on each other, rounding keeps the places apart.
Clipper::Segment *Clipper::next_cut(glm::dvec3 at) {
	for (auto next = std::ranges::lower_bound(_cuts, at, is_before, &Segment::from); next != _cuts.end() && next->from == at; ++next) {
		if (!next->is_used) {
			return &*next;
		}
	}
	for (auto next = std::ranges::lower_bound(_cuts, at.x - _margin, {}, [](const Segment &cut) { return cut.from.x; });
			next != _cuts.end() && next->from.x <= at.x + _margin; ++next) {
		if (!next->is_used && glm::distance(next->from, at) <= _margin) {
			return &*next;
		}
	}
	return nullptr;
}

// Two faces that both stay and share an edge in the plane need no cap between them. What is left of the cut of a square face is one piece again.
void Clipper::cancel_opposite_cuts() {
	for (size_t i = 0; i < _cuts.size(); ++i) {
		const auto opposite = std::find_if(_cuts.begin() + std::ptrdiff_t(i), _cuts.end(),
				[&](const Segment &cut) { return cut.from == _cuts[i].to && cut.to == _cuts[i].from && !cut.is_used; });
		if (!_cuts[i].is_used && opposite != _cuts.end()) {
			_cuts[i].is_used = opposite->is_used = true;
		}
	}
	for (size_t i = 1; i < _cuts.size(); ++i) {
		if (_cuts[i].number == 1 && !_cuts[i].is_used && !_cuts[i - 1].is_used) {
			_cuts[i].from = _cuts[i - 1].from;
			_cuts[i - 1].is_used = true;
		}
	}
	std::erase_if(_cuts, [](const Segment &cut) { return cut.is_used; });
}

} // namespace pcg::cga
