#pragma once

#include <cstdint>
#include <vector>

#include "core/lang/value.h"

// What stands between the brackets of a[..] as numbers of elements (CGA reference: func_index). A negative number lies outside of the array.
namespace pcg {

struct ArrayIndex {
	std::vector<int64_t> at;
	uint32_t rows = 1, columns = 0; // of the result of a[i]
	bool is_single = false; // one number: the result is an element, not an array
};

// A number, an array of numbers, or an array of truth values that picks the places of its true ones. False: it is something else.
bool read_array_index(const Value &value, ArrayIndex &index);

} // namespace pcg
