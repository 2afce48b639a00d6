#pragma once

#include <cstdint>
#include <vector>

#include "core/base/diagnostic.h"

namespace pcg {

// Messages of rules that run for many households: each once for each place in the rules, in the words of the first household.
class RepeatedDiagnostics {
public:
	void add(Diagnostic diagnostic);
	// With how often errors came again. Warnings that are in `diagnostics` already, from loading the rules, are not told again.
	void tell(Diagnostics &diagnostics);

private:
	struct Told {
		Diagnostic first;
		uint64_t repeats = 0;
	};

	std::vector<Told> _told;
};

} // namespace pcg
