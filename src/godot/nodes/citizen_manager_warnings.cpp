#include <optional>

#include "godot/convert.h"
#include "godot/nodes/citizen_manager.h"
#include "godot/nodes/pcg_city.h"

using namespace godot;

// What is missing or wrong before anybody lives: as warnings in the editor, and as errors where people are to be made.
namespace pcg {

// Those that the rules take; what they do not is an error.
std::vector<AttributeOverride> CitizenManager::attributes(Diagnostics &diagnostics) const {
	std::vector<AttributeOverride> good;
	for (AttributeOverride &attribute : from_godot(_attributes, diagnostics)) {
		std::optional<Diagnostic> problem;
		if (_rules.is_valid() && _rules->program()) {
			problem = attribute_problem(*_rules->program(), attribute);
		}
		problem ? diagnostics.add(std::move(*problem)) : good.push_back(std::move(attribute));
	}
	return good;
}

PackedStringArray CitizenManager::_get_configuration_warnings() const {
	PackedStringArray warnings;
	if (!get_city()) {
		warnings.push_back("Nobody can live here: set `city` to a PCGCity of this scene.");
	}
	if (_rules.is_null()) {
		warnings.push_back("Nobody knows what to do: set `rules` to a .pcg file.");
	} else if (_rules->has_errors()) {
		warnings.push_back("The rules have errors; see their list of diagnostics.");
	} else if (_rules->get_dialect() != PCGRuleSet::DIALECT_AGENDA) {
		warnings.push_back("These rules build lots. Agendas come from a .pcg file.");
	}
	Diagnostics attribute_problems;
	attributes(attribute_problems);
	for (const Diagnostic &problem : attribute_problems.list()) {
		warnings.push_back(to_godot(std::string_view("Attributes: " + problem.message + (problem.hint.empty() ? "." : "; " + problem.hint))));
	}
	if (_table.is_null() && _people.is_null()) {
		warnings.push_back("There are no households: set `household_table`, or a `population`.");
	} else if (_people.is_valid() && _people->has_errors()) {
		warnings.push_back("The population has errors; see its list of diagnostics.");
	} else if (_people.is_null() && _table->has_errors()) {
		warnings.push_back("The household table has errors; see its list of diagnostics.");
	}
	if (_people.is_null() && _person_count == 0) {
		warnings.push_back("Nobody is to be drawn: `person_count` is 0.");
	}
	return warnings;
}

bool CitizenManager::check_place(Diagnostics &diagnostics) const {
	const PCGCity *city = get_city();
	if (!city) {
		diagnostics.error("missing-city", "CitizenManager has no city", "set its `city` to a PCGCity");
	} else if (!city->is_generated()) {
		diagnostics.error("missing-city", "the city of CitizenManager has not been generated yet",
				"call generate() on it and wait for city_generated");
	}
	if (_rules.is_null()) {
		diagnostics.error("missing-rules", "CitizenManager has no rules", "set its `rules` to a .pcg file");
	} else if (_rules->get_dialect() != PCGRuleSet::DIALECT_AGENDA) {
		diagnostics.error("wrong-dialect", "the rules of CitizenManager are shape grammar rules", "give it a .pcg file");
	} else {
		diagnostics.append(_rules->diagnostics());
	}
	return !diagnostics.has_errors();
}

bool CitizenManager::check_inputs(Diagnostics &diagnostics) const {
	check_place(diagnostics);
	if (_people.is_valid()) {
		if (_people->has_errors()) {
			diagnostics.append(_people->diagnostics());
		}
	} else if (_table.is_null()) {
		diagnostics.error("missing-households", "CitizenManager has no household table", "set its `household_table`, or a `population`");
	} else {
		diagnostics.append(_table->diagnostics());
	}
	return !diagnostics.has_errors();
}

} // namespace pcg
