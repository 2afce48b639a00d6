#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace pcg::cga {

// Numbers that are joined to sets; a set is called by its least number (Tarjan 1975).
class DisjointSets {
public:
	explicit DisjointSets(size_t count) : _parents(count) { std::iota(_parents.begin(), _parents.end(), 0); }
	uint32_t find(uint32_t i) {
		while (_parents[i] != i) {
			i = _parents[i] = _parents[_parents[i]];
		}
		return i;
	}
	void join(uint32_t a, uint32_t b) {
		a = find(a);
		b = find(b);
		_parents[std::max(a, b)] = std::min(a, b);
	}

private:
	std::vector<uint32_t> _parents;
};

} // namespace pcg::cga
