#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/lang/value.h"

namespace pcg::cga {

// report(key, value): what came under one key with values of one type (CGA reference: op_report, section 7.7).
struct ModelReport {
	std::string key;
	ValueType type = ValueType::Number; // or Bool, or Text
	uint64_t count = 0;
	// Of numbers; of truth values as 0 and 1.
	double sum = 0.0;
	double min = 0.0;
	double max = 0.0;
	std::map<std::string, uint64_t, std::less<>> texts; // how often each text came

	void add(const Value &value); // of `type`
	void merge(const ModelReport &other); // of the same key and type
	std::string_view most_frequent_text() const; // of those that came equally often the first in order; "" without texts
};

// Where values of several types came under one key the others are told from the numbers: "key (bool)", "key (text)".
std::string report_name(const std::vector<ModelReport> &reports, const ModelReport &report);

} // namespace pcg::cga
