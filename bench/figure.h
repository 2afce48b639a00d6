#pragma once

#include <cstdio>
#include <string_view>

// One figure, as tools/run_bench.py reads it: a JSON object on a line of its own. `peer` is what others need for the same, 0: nobody; `ratio` the
// value over it. Both are null where there is nothing to compare with.
namespace pcg::bench {

inline void print(std::string_view name, double value, std::string_view unit, double peer = 0.0) {
	std::printf("{\"name\": \"%.*s\", \"value\": %.6g, \"unit\": \"%.*s\", ", int(name.size()), name.data(), value, int(unit.size()), unit.data());
	if (peer > 0.0) {
		std::printf("\"peer\": %.6g, \"ratio\": %.4g}\n", peer, value / peer);
	} else {
		std::printf("\"peer\": null, \"ratio\": null}\n");
	}
}

} // namespace pcg::bench
