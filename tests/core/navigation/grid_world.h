#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "core/base/random.h"
#include "core/navigation/nav_mesh.h"

// A field of walkable and blocked squares of 1 m, and the truth about it worked out the slow way: shortest walks over the visibility graph of
// all corners. Cell (x, z) covers [x, x+1] x [z, z+1].
namespace pcg::test {

class GridWorld {
public:
	GridWorld(int width, int depth, double blocked_share, uint64_t seed) : _width(width), _depth(depth), _is_free(size_t(width * depth), true) {
		Random random(seed);
		for (int i = 0; i < width * depth; ++i) {
			_is_free[size_t(i)] = !random.chance(blocked_share);
		}
		// Where two squares touch by a corner only, opinions on whether one can pass differ: there are no such places.
		for (bool has_changed = true; has_changed;) {
			has_changed = false;
			for (int z = 0; z + 1 < depth; ++z) {
				for (int x = 0; x + 1 < width; ++x) {
					const bool a = is_free(x, z), b = is_free(x + 1, z), c = is_free(x, z + 1), d = is_free(x + 1, z + 1);
					if (a == d && b == c && a != b) {
						_is_free[size_t(z * width + x + (a ? 1 : 0))] = true;
						_is_free[size_t(z * width + x + (a ? 0 : 1))] = true;
						has_changed = true;
					}
				}
			}
		}
	}

	int width() const { return _width; }
	int depth() const { return _depth; }
	bool is_free(int x, int z) const { return x >= 0 && z >= 0 && x < _width && z < _depth && _is_free[size_t(z * _width + x)]; }
	void set_free(int x, int z, bool is_free) { _is_free[size_t(z * _width + x)] = is_free; }

	// Squares of the columns [from, to) as a region with vertices of its own.
	NavRegion region(int from, int to) const {
		NavRegion region;
		for (int z = 0; z <= _depth; ++z) {
			for (int x = from; x <= to; ++x) {
				region.vertices.push_back({ float(x), 0.0f, float(z) });
			}
		}
		const auto vertex = [&](int x, int z) { return uint32_t(z * (to - from + 1) + x - from); };
		for (int z = 0; z < _depth; ++z) {
			for (int x = from; x < to; ++x) {
				if (is_free(x, z)) {
					region.polygons.push_back({ vertex(x, z), vertex(x + 1, z), vertex(x + 1, z + 1), vertex(x, z + 1) });
				}
			}
		}
		return region;
	}

	// All of it as one region.
	NavMesh mesh() const {
		const NavRegion all = region(0, _width);
		return NavMesh::build({ &all, 1 });
	}

	// A free place that is not on a line of the grid.
	glm::vec3 random_place(Random &random) const {
		for (;;) {
			const int x = int(random.index(size_t(_width))), z = int(random.index(size_t(_depth)));
			if (is_free(x, z)) {
				return { float(x + random.uniform(0.1, 0.9)), 0.0f, float(z + random.uniform(0.1, 0.9)) };
			}
		}
	}

	// Does the straight way stay on free squares? Along the border of a free square counts.
	bool is_visible(glm::vec3 a, glm::vec3 b) const {
		std::vector<double> cuts = { 0.0, 1.0 };
		for (int line = 0; line <= std::max(_width, _depth); ++line) {
			for (double t : { (line - double(a.x)) / (double(b.x) - a.x), (line - double(a.z)) / (double(b.z) - a.z) }) {
				if (t > 0.0 && t < 1.0) {
					cuts.push_back(t);
				}
			}
		}
		std::sort(cuts.begin(), cuts.end());
		for (size_t i = 1; i < cuts.size(); ++i) {
			const double t = (cuts[i - 1] + cuts[i]) / 2.0;
			if (cuts[i] - cuts[i - 1] > 1e-6 && !touches_free(a.x + (double(b.x) - a.x) * t, a.z + (double(b.z) - a.z) * t)) {
				return false;
			}
		}
		return true;
	}

	// Infinity if there is no way.
	double shortest(glm::vec3 from, glm::vec3 to) const {
		std::vector<glm::vec3> places = { from, to };
		for (int z = 0; z <= _depth; ++z) {
			for (int x = 0; x <= _width; ++x) {
				if (is_free(x, z) || is_free(x - 1, z) || is_free(x, z - 1) || is_free(x - 1, z - 1)) {
					places.push_back({ float(x), 0.0f, float(z) });
				}
			}
		}
		std::vector<double> metres(places.size(), std::numeric_limits<double>::infinity());
		std::vector<bool> is_done(places.size(), false);
		metres[0] = 0.0;
		for (;;) {
			size_t next = places.size();
			for (size_t i = 0; i < places.size(); ++i) {
				if (!is_done[i] && std::isfinite(metres[i]) && (next == places.size() || metres[i] < metres[next])) {
					next = i;
				}
			}
			if (next == places.size() || next == 1) {
				return metres[1];
			}
			is_done[next] = true;
			for (size_t i = 0; i < places.size(); ++i) {
				const double reach = metres[next] + double(glm::distance(places[next], places[i]));
				if (!is_done[i] && reach < metres[i] && is_visible(places[next], places[i])) {
					metres[i] = reach;
				}
			}
		}
	}

private:
	bool touches_free(double x, double z) const {
		const double slack = 1e-4;
		for (double dx : { -slack, slack }) {
			for (double dz : { -slack, slack }) {
				if (is_free(int(std::floor(x + dx)), int(std::floor(z + dz)))) {
					return true;
				}
			}
		}
		return false;
	}

	int _width, _depth;
	std::vector<bool> _is_free;
};

} // namespace pcg::test
