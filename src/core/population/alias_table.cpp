#include "core/population/alias_table.h"

#include <cmath>

namespace pcg {

AliasTable::AliasTable(const std::vector<double> &weights) {
	double total = 0.0;
	for (size_t i = 0; i < weights.size(); ++i) {
		if (weights[i] > 0.0 && std::isfinite(weights[i])) {
			_columns.push_back({ weights[i], uint32_t(i), uint32_t(i) });
			total += weights[i];
		}
	}
	std::vector<size_t> small;
	std::vector<size_t> large;
	for (size_t i = 0; i < _columns.size(); ++i) {
		_columns[i].threshold *= double(_columns.size()) / total;
		(_columns[i].threshold < 1.0 ? small : large).push_back(i);
	}
	while (!small.empty() && !large.empty()) {
		Column &low = _columns[small.back()];
		const size_t high = large.back();
		small.pop_back();
		low.other = _columns[high].own;
		_columns[high].threshold -= 1.0 - low.threshold;
		if (_columns[high].threshold < 1.0) {
			large.pop_back();
			small.push_back(high);
		}
	}
	for (size_t rest : small) { // 1 but for rounding
		_columns[rest].threshold = 1.0;
	}
}

size_t AliasTable::draw(Random &random) const {
	const Column &column = _columns[random.index(_columns.size())];
	return random.uniform() < column.threshold ? column.own : column.other;
}

} // namespace pcg
