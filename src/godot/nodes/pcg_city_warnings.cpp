#include <cmath>

#include <godot_cpp/classes/navigation_server3d.hpp>
#include <godot_cpp/classes/world3d.hpp>

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
	if (is_inside_tree()) {
		add_bake_warnings(warnings);
	}
	return warnings;
}

// Of what the ground will be baked with, beside what the map says.
void PCGCity::add_bake_warnings(PackedStringArray &warnings) const {
	NavigationServer3D *server = NavigationServer3D::get_singleton();
	const RID map = get_world_3d()->get_navigation_map();
	const double cell = server->map_get_cell_size(map), height = server->map_get_cell_height(map);
	const BakeSettings settings = bake_settings();
	if (_cell_size > 0.0 && std::abs(double(settings.cell_size) - _cell_size) > 1e-4) {
		warnings.push_back("The cell_size of " + String::num(_cell_size) + " m is no whole multiple of the navigation map's, " + String::num(cell) +
				" m: " + String::num(settings.cell_size) + " m is taken. Change one of the two (project settings, navigation/3d/default_cell_size).");
	}
	if (_agent_max_climb > 0.0 && _agent_max_climb < height) {
		warnings.push_back("The agent_max_climb of " + String::num(_agent_max_climb) + " m is less than a cell of the navigation map is high, " +
				String::num(height) + " m: people climb no steps. Make it larger, or cells lower (navigation/3d/default_cell_height).");
	}
	if (settings.cell_size > 2.0f * std::max(0.25f, settings.agent_radius)) {
		warnings.push_back("Cells of " + String::num(settings.cell_size) + " m keep people so far from walls: narrow ways are closed. Make cell_size smaller.");
	}
}

} // namespace pcg
