#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/diagnostic.h"
#include "core/lang/rule_set.h"

// Steps of looking up a name in one space of a rule set.
namespace pcg {

// Of the definitions of a name the one with so many parameters; no_node if there is none.
inline uint32_t find_overload(const RuleSet &set, const std::vector<uint32_t> *list, size_t param_count) {
	if (list != nullptr) {
		for (uint32_t definition : *list) {
			if (set.definitions[definition].param_count == param_count) {
				return definition;
			}
		}
	}
	return no_node;
}

// Null if there is none.
template <typename Map> const std::vector<uint32_t> *find_list(const Map &map, std::string_view name) {
	const auto found = map.find(name);
	return found == map.end() ? nullptr : &found->second;
}

// "did you mean `l.start`?", or nothing if no name of the list is close. The prefix is the space's.
template <typename Map> std::string nearest(const Map &map, std::string_view prefix, std::string_view name) {
	std::vector<std::string_view> names;
	for (const auto &[known, list] : map) {
		names.push_back(known);
	}
	std::sort(names.begin(), names.end()); // of two that are as close the choice is the same everywhere
	const std::string_view closest = closest_name(name, names);
	return closest.empty() ? std::string() : "did you mean `" + std::string(prefix) + std::string(closest) + "`?";
}

} // namespace pcg
