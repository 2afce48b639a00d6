#include "core/lang/array_index.h"

#include <cmath>

namespace pcg {

namespace {

int64_t whole(double number) {
	return std::isfinite(number) && std::fabs(number) < 1e15 ? int64_t(std::floor(number)) : -1;
}

} // namespace

bool read_array_index(const Value &value, ArrayIndex &index) {
	if (value.is_number()) {
		index.at = { whole(value.number) };
		index.columns = 1;
		index.is_single = true;
		return true;
	}
	if (!value.is_array()) {
		return false;
	}
	const ArrayData &array = *value.array;
	const bool is_mask = array.element == ValueType::Bool;
	for (uint32_t i = 0; i < array.size(); ++i) {
		if (!is_mask && !array.values[i].is_number()) {
			return false;
		}
		if (!is_mask) {
			index.at.push_back(whole(array.values[i].number));
		} else if (array.values[i].boolean) {
			index.at.push_back(i);
		}
	}
	index.rows = is_mask ? 1 : array.rows;
	index.columns = is_mask ? uint32_t(index.at.size()) : array.columns;
	return true;
}

} // namespace pcg
