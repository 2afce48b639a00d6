#pragma once

#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/diagnostic.h"

// Messages of many lots made few: a rule file that warns does so on every lot that it builds.
namespace pcg {

// Gathers diagnostics lot by lot; the same message of several lots becomes one that names the first lot and counts the others.
class LotMessages {
public:
	// What the messages are of, where those are no lots.
	explicit LotMessages(std::string noun = "lot") : _noun(std::move(noun)) {}
	void add(const std::string &lot_name, const Diagnostics &diagnostics);
	void add(const std::string &lot_name, Diagnostic diagnostic);
	// In order of first occurrence.
	void hand_over(Diagnostics &diagnostics) const;

private:
	struct Entry {
		Diagnostic diagnostic;
		std::string first_lot;
		size_t count = 0;
	};
	std::string _noun;
	std::vector<Entry> _entries;
	std::map<std::string, size_t> _indices; // by text
};

} // namespace pcg
