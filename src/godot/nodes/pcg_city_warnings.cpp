#include "godot/convert.h"
#include "godot/nodes/pcg_city.h"

using namespace godot;

namespace pcg {

PackedStringArray PCGCity::_get_configuration_warnings() const {
	PackedStringArray warnings;
	if (_layout.is_null()) {
		warnings.push_back("This city has no layout. Give it a PCGLayout, which says where streets and lots lie.");
	} else {
		Diagnostics diagnostics;
		check_parameters(_layout->parameters(), diagnostics);
		for (const Diagnostic &diagnostic : diagnostics.list()) {
			warnings.push_back(to_godot(diagnostic.message + ". " + diagnostic.hint));
		}
	}
	if (_lot_types.is_empty()) {
		warnings.push_back("This city has no lot types. Add a PCGLotType for each kind of lot, with the rules (.cga) that build it.");
	}
	for (int64_t i = 0; i < _lot_types.size(); ++i) {
		const Ref<PCGLotType> type = _lot_types[i];
		if (type.is_null() || type->get_rules().is_null()) {
			warnings.push_back("Lot type " + String::num_int64(i) + " has no rules. Give it a .cga file.");
		} else if (type->get_rules()->get_dialect() != PCGRuleSet::DIALECT_CGA) {
			warnings.push_back("The rules of lot type \"" + type->get_type() + "\" write agendas. Lots are built by a .cga file.");
		} else if (type->get_rules()->has_errors()) {
			warnings.push_back("The rules of lot type \"" + type->get_type() + "\" have errors; see their list of diagnostics.");
		}
	}
	for (const Diagnostic &diagnostic : _diagnostics.list()) {
		if (diagnostic.id == "overlap") {
			warnings.push_back(to_godot(diagnostic.message + ". " + diagnostic.hint));
		}
	}
	if (_street_rules.is_valid() && (_street_rules->get_dialect() != PCGRuleSet::DIALECT_CGA || _street_rules->has_errors())) {
		warnings.push_back("The street rules have errors or are no .cga file, so streets will be plain; see their list of diagnostics.");
	}
	return warnings;
}

} // namespace pcg
