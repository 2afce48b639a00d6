#include "core/geometry/inner_rectangle.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/geometry/polygon.h"

namespace pcg {

namespace {

// Between two lines that stand at `left` and `right`: heights there.
struct Trapezoid {
	double bottom_left, bottom_right, top_left, top_right;
	double bottom() const { return std::max(bottom_left, bottom_right); }
	double top() const { return std::min(top_left, top_right); }
	double height() const { return std::max(top_left, top_right) - std::min(bottom_left, bottom_right); }
};

struct Slab {
	double left, right;
	std::vector<Trapezoid> trapezoids; // from low to high
};

struct Range {
	double low, high;
};

double between(double a, double b, double share) { return a + (b - a) * share; }

// The place of the maximum of a function with one maximum, by golden section.
template <typename Function> double place_of_maximum(Range range, Function function) {
	constexpr double ratio = 0.6180339887498949;
	double low = range.low, high = range.high;
	double a = high - ratio * (high - low), b = low + ratio * (high - low);
	double at_a = function(a), at_b = function(b);
	for (int i = 0; i < 48 && high > low; ++i) {
		if (at_a < at_b) {
			low = a;
			a = b;
			at_a = at_b;
			b = low + ratio * (high - low);
			at_b = function(b);
		} else {
			high = b;
			b = a;
			at_b = at_a;
			a = high - ratio * (high - low);
			at_a = function(a);
		}
	}
	double best = 0.5 * (low + high), value = function(best);
	for (const double end : { range.low, range.high }) { // the maximum is often exactly there
		const double at_end = function(end);
		if (at_end >= value * (1.0 - 1e-12)) {
			value = at_end;
			best = end;
		}
	}
	return best;
}

class Search {
public:
	// Only rectangles of more than `least` square metres are looked for.
	Search(const Loops2 &polygon, double least) : _best(least) {
		make_slabs(polygon);
		find_middle(polygon);
	}

	Loop2 run() {
		for (const bool is_rough : { true, false }) {
			_is_rough = is_rough;
			for (size_t i = 0; i < _slabs.size(); ++i) {
				for (const Trapezoid &start : _slabs[i].trapezoids) {
					search_one(i, start);
					extend(i, start, i + 1, { start.bottom_right, start.top_right });
				}
			}
		}
		if (_high.x <= _low.x) {
			return {};
		}
		return { _low, { _high.x, _low.y }, _high, { _low.x, _high.y } };
	}

private:
	void make_slabs(const Loops2 &polygon) {
		std::vector<double> xs;
		for (const Loop2 &loop : polygon) {
			for (const glm::dvec2 &point : loop) {
				xs.push_back(point.x);
			}
		}
		std::ranges::sort(xs);
		const double margin = xs.empty() ? 0.0 : 1e-9 * (xs.back() - xs.front());
		for (size_t i = 0; i + 1 < xs.size(); ++i) {
			if (xs[i + 1] - xs[i] > margin) {
				_slabs.push_back(slab(polygon, xs[i], xs[i + 1]));
			}
		}
	}

	static Slab slab(const Loops2 &polygon, double left, double right) {
		std::vector<Range> lines; // heights at left and right
		const double middle = 0.5 * (left + right);
		for (const Loop2 &loop : polygon) {
			for (size_t i = 0; i < loop.size(); ++i) {
				const glm::dvec2 a = loop[i], b = loop[(i + 1) % loop.size()];
				if ((a.x <= middle) != (b.x <= middle)) {
					const double rise = (b.y - a.y) / (b.x - a.x);
					const auto at = [&](double x) { return a.y == b.y ? a.y : x == a.x ? a.y : x == b.x ? b.y : a.y + (x - a.x) * rise; };
					lines.push_back({ at(left), at(right) });
				}
			}
		}
		std::ranges::stable_sort(lines, {}, [](const Range &line) { return line.low + line.high; });
		Slab slab{ left, right, {} };
		for (size_t i = 0; i + 1 < lines.size(); i += 2) {
			slab.trapezoids.push_back({ lines[i].low, lines[i].high, lines[i + 1].low, lines[i + 1].high });
		}
		return slab;
	}

	void find_middle(const Loops2 &polygon) {
		double area = 0.0;
		glm::dvec2 sum(0.0), origin = polygon.empty() || polygon[0].empty() ? glm::dvec2(0.0) : polygon[0][0];
		for (const Loop2 &loop : polygon) {
			for (size_t i = 0; i < loop.size(); ++i) {
				const glm::dvec2 a = loop[i] - origin, b = loop[(i + 1) % loop.size()] - origin;
				const double part = a.x * b.y - a.y * b.x;
				area += part;
				sum += (a + b) * part;
			}
		}
		_middle = origin + (area > 0.0 ? sum / (3.0 * area) : glm::dvec2(0.0));
		_size = area > 0.0 ? area : 1.0;
	}

	// Area, a trace smaller the further away from the centre of gravity; below 0 how much the lines cross.
	double value(double x0, double x1, double low, double high) const {
		const double height = high - low;
		if (height <= 0.0) {
			return height;
		}
		const glm::dvec2 way = glm::dvec2(0.5 * (x0 + x1), 0.5 * (low + high)) - _middle;
		return (x1 - x0) * height * (1.0 - 1e-7 * glm::dot(way, way) / (glm::dot(way, way) + _size));
	}

	void offer(double x0, double x1, double low, double high) {
		const double area = value(x0, x1, low, high);
		if (area > _best && x1 > x0 && high > low) {
			_best = area;
			_low = { x0, low };
			_high = { x1, high };
		}
	}

	bool is_hopeless(double width, double height) const { return width * height <= _best * (1.0 + 1e-12); }

	// Within one slab: lines at x0 and x1.
	void search_one(size_t index, const Trapezoid &t) {
		const Slab &slab = _slabs[index];
		const double width = slab.right - slab.left;
		if (_is_rough) {
			offer(slab.left, slab.right, t.bottom(), t.top());
		} else if (!is_hopeless(width, t.height())) {
			search_between(slab, t, slab, t, { -INFINITY, INFINITY });
		}
	}

	// Over the slabs from `first` to before `next`, all but the first fully covered; `core` is what is free in those and at the first's right end.
	void extend(size_t first, const Trapezoid &start, size_t next, Range core) {
		if (next >= _slabs.size() || is_hopeless(_slabs.back().right - _slabs[first].left, core.high - core.low)) {
			return;
		}
		for (const Trapezoid &end : _slabs[next].trapezoids) {
			const Range border = { std::max(core.low, end.bottom_left), std::min(core.high, end.top_left) };
			const double width = _slabs[next].right - _slabs[first].left;
			if (border.high <= border.low) {
				continue;
			}
			const Range full = { std::max(border.low, end.bottom_right), std::min(border.high, end.top_right) };
			if (_is_rough) {
				offer(_slabs[first].left, _slabs[next].right, std::max(full.low, start.bottom_left), std::min(full.high, start.top_left));
			} else if (!is_hopeless(width, border.high - border.low)) {
				search_between(_slabs[first], start, _slabs[next], end, border);
			}
			if (full.high > full.low) {
				extend(first, start, next + 1, full);
			}
		}
	}

	void search_between(const Slab &left, const Trapezoid &a, const Slab &right, const Trapezoid &b, Range core) {
		const auto free = [&](double x0, double x1) {
			const double s = (x0 - left.left) / (left.right - left.left), t = (x1 - right.left) / (right.right - right.left);
			return Range{ std::max({ core.low, between(a.bottom_left, a.bottom_right, s), between(b.bottom_left, b.bottom_right, t) }),
				std::min({ core.high, between(a.top_left, a.top_right, s), between(b.top_left, b.top_right, t) }) };
		};
		const auto area = [&](double x0, double x1) {
			const Range range = free(x0, x1);
			return value(x0, x1, range.low, range.high);
		};
		const auto best_end = [&](double x0) {
			return place_of_maximum({ std::max(x0, right.left), right.right }, [&](double x1) { return area(x0, x1); });
		};
		const double x0 = place_of_maximum({ left.left, left.right }, [&](double x) { return area(x, best_end(x)); });
		const double x1 = best_end(x0);
		const Range range = free(x0, x1);
		offer(x0, x1, range.low, range.high);
	}

	std::vector<Slab> _slabs;
	glm::dvec2 _middle{ 0.0 };
	double _size = 1.0;
	bool _is_rough = true; // only between corners: a first best that rules out most of the rest
	double _best;
	glm::dvec2 _low{ 0.0 }, _high{ 0.0 };
};

Loops2 turned(const Loops2 &polygon, glm::dvec2 axis) {
	Loops2 result = polygon;
	for (Loop2 &loop : result) {
		for (glm::dvec2 &p : loop) {
			p = { p.x * axis.x - p.y * axis.y, p.x * axis.y + p.y * axis.x };
		}
	}
	return result;
}

// Directions of edges long enough to count, each once however it is turned by right angles.
std::vector<glm::dvec2> edge_directions(const Loops2 &polygon) {
	std::vector<glm::dvec2> result;
	for (const Loop2 &loop : polygon) {
		double longest = 0.0;
		for (size_t i = 0; i < loop.size(); ++i) {
			longest = std::max(longest, glm::distance(loop[i], loop[(i + 1) % loop.size()]));
		}
		for (size_t i = 0; i < loop.size(); ++i) {
			const glm::dvec2 way = loop[(i + 1) % loop.size()] - loop[i];
			if (glm::length(way) <= 0.25 * longest) {
				continue;
			}
			const glm::dvec2 direction = glm::normalize(way);
			const auto is_known = [&](glm::dvec2 d) {
				return std::abs(glm::dot(d, direction)) < 1e-9 || std::abs(d.x * direction.y - d.y * direction.x) < 1e-9;
			};
			if (std::ranges::none_of(result, is_known)) {
				result.push_back(direction);
			}
		}
	}
	return result;
}

} // namespace

Loop2 largest_rectangle(const Loops2 &polygon) {
	return Search(polygon, 0.0).run();
}

Loop2 largest_rectangle_along_edges(const Loops2 &polygon) {
	Loop2 best;
	for (const glm::dvec2 &direction : edge_directions(polygon)) {
		const double least = best.empty() ? 0.0 : 0.5 * signed_area(best) * (1.0 + 1e-9);
		const Loop2 found = Search(turned(polygon, { direction.x, -direction.y }), least).run();
		if (!found.empty()) {
			best = turned({ found }, direction)[0];
		}
	}
	return best;
}

Loop2 begun_near(const Loop2 &loop, glm::dvec2 edge_from, glm::dvec2 edge_to) {
	const glm::dvec2 middle = 0.5 * (edge_from + edge_to), along = edge_to - edge_from;
	size_t nearest = 0;
	double least = INFINITY;
	for (size_t i = 0; i < loop.size(); ++i) {
		const glm::dvec2 a = loop[i], side = loop[(i + 1) % loop.size()] - a;
		const double length = glm::dot(side, side);
		const double at = length > 0.0 ? glm::clamp(glm::dot(middle - a, side) / length, 0.0, 1.0) : 0.0;
		// Sides that run the same way come first where two are equally near.
		const double turn = length > 0.0 ? 1.0 - glm::dot(side, along) / std::sqrt(length * std::max(glm::dot(along, along), 1e-300)) : 2.0;
		const double distance = glm::distance(middle, a + at * side) + 1e-6 * turn * glm::length(along);
		if (distance < least) {
			least = distance;
			nearest = i;
		}
	}
	Loop2 result = loop;
	std::ranges::rotate(result, result.begin() + std::ptrdiff_t(nearest));
	return result;
}

} // namespace pcg
