#pragma once

#include <cstdint>
#include <vector>

#include "core/base/random.h"

namespace pcg {

// Draws an index with a probability in proportion to its weight, in constant time: the alias method (Walker 1977; set up as in Vose
// 1991). Weights below or equal to 0 and those that are not finite are never drawn.
class AliasTable {
public:
	explicit AliasTable(const std::vector<double> &weights);

	bool is_empty() const { return _columns.empty(); } // no weight is above 0
	size_t draw(Random &random) const; // not of an empty table

private:
	struct Column {
		double threshold = 1.0; // below it the column's own index, else the other one
		uint32_t own = 0;
		uint32_t other = 0;
	};
	std::vector<Column> _columns;
};

} // namespace pcg
