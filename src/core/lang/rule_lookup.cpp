#include "core/lang/rule_lookup.h"

// What a name means in a rule set.
namespace pcg {

uint32_t RuleSet::enter_space(uint32_t space, std::string_view &name) const {
	for (size_t dot = name.find('.'); dot != std::string_view::npos && dot + 1 < name.size(); dot = name.find('.')) {
		const auto found = spaces[space].imports.find(name.substr(0, dot));
		if (found == spaces[space].imports.end()) {
			return no_node;
		}
		space = found->second;
		name.remove_prefix(dot + 1);
	}
	return space;
}

bool RuleSet::is_excused(uint32_t space, std::string_view name) const {
	for (const auto &file : files) {
		if (std::find(file->ast.lost_names.begin(), file->ast.lost_names.end(), name) != file->ast.lost_names.end()) {
			return true;
		}
	}
	space = enter_space(space, name);
	return space != no_node && spaces[space].is_missing;
}

uint32_t RuleSet::find_rule(uint32_t space, std::string_view name, size_t param_count) const {
	space = enter_space(space, name);
	if (space == no_node) {
		return no_node;
	}
	const uint32_t found = find_overload(*this, find_list(spaces[space].rules, name), param_count);
	const uint32_t start = spaces[space].start;
	return found == no_node && name == "start" && start != no_node
			? find_overload(*this, find_list(spaces[space].rules, definitions[start].item->name), param_count) : found;
}

uint32_t RuleSet::find_value(uint32_t space, std::string_view name, size_t param_count) const {
	space = enter_space(space, name);
	return space == no_node ? no_node : find_overload(*this, find_list(spaces[space].values, name), param_count);
}

bool RuleSet::has_rule(uint32_t space, std::string_view name) const {
	space = enter_space(space, name);
	return space != no_node && find_list(spaces[space].rules, name) != nullptr;
}

bool RuleSet::has_value(uint32_t space, std::string_view name) const {
	space = enter_space(space, name);
	return space != no_node && find_list(spaces[space].values, name) != nullptr;
}

} // namespace pcg
