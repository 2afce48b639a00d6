#include <godot_cpp/classes/resource_loader.hpp>

#include "godot/convert.h"
#include "godot/nodes/drawn_footprints.h"
#include "godot/nodes/pcg_city.h"

using namespace godot;

namespace pcg {

namespace {

// As installed, else as in the addon's own project; null if there is none.
Ref<PCGRuleSet> shipped_rules(const char *file) {
	ResourceLoader *loader = ResourceLoader::get_singleton();
	for (const char *folder : { "res://addons/pcg/rules/cga/", "res://rules/cga/" }) {
		if (loader->exists(String(folder) + file)) {
			return loader->load(String(folder) + file);
		}
	}
	return {};
}

} // namespace

bool PCGCity::prepare_job(CityInput &input, Diagnostics &diagnostics) const {
	if (_layout.is_valid()) {
		input.layout = _layout->parameters();
		const PCGLayout::Kind kind = _layout->get_kind();
		input.source = !_layout->is_drawn() ? CityInput::Source::Streets : kind == PCGLayout::KIND_BLOCKS ? CityInput::Source::Blocks : CityInput::Source::Lots;
		input.geojson = from_godot(_layout->get_geojson());
		input.footprints = _layout->is_drawn() ? drawn_footprints(this) : std::vector<Footprint>();
	} else {
		diagnostics.error("missing-layout", "PCGCity has no layout", "set its `layout` to a PCGLayout");
	}
	input.layout.seed = uint64_t(_seed);
	input.layout.land_use.clear();
	return prepare_rules(input, diagnostics);
}

bool PCGCity::prepare_rules(CityInput &input, Diagnostics &diagnostics) const {
	input.asset_folders = from_godot(_asset_folders);
	input.free_ground.step_height = float(_agent_max_climb);
	input.free_ground.head_height = float(_agent_height) + 0.25f; // people do not like to brush against it
	if (_lot_types.is_empty()) {
		diagnostics.error("missing-lot-types", "PCGCity has no lot types",
				"add a PCGLotType for each kind of lot to `lot_types`, with the rules that build it");
	}
	for (int64_t i = 0; i < _lot_types.size(); ++i) {
		const Ref<PCGLotType> type = _lot_types[i];
		const Ref<PCGRuleSet> rules = type.is_valid() ? type->get_rules() : Ref<PCGRuleSet>();
		if (rules.is_null()) {
			diagnostics.error("missing-rules", "lot type " + std::to_string(i) + " of PCGCity has no rules", "give it a .cga file");
			continue;
		}
		const std::string name = from_godot(type->get_type());
		if (rules->get_dialect() != PCGRuleSet::DIALECT_CGA) {
			diagnostics.error("wrong-dialect", "the rules of lot type \"" + name + "\" write agendas", "give it a .cga file");
			continue;
		}
		diagnostics.append(rules->diagnostics());
		input.layout.land_use.push_back({ name, type->get_weight(), type->weight_map(diagnostics) });
		input.rules[name] = { rules->program(), from_godot(type->get_start_rule()), from_godot(type->get_attributes(), diagnostics) };
	}
	return !diagnostics.has_errors();
}

// Whatever is wrong with their rules, the city is made, with plain streets.
void PCGCity::prepare_streets(CityInput &input, Diagnostics &diagnostics) const {
	if (!_use_street_rules) {
		return;
	}
	const Ref<PCGRuleSet> rules = _street_rules.is_valid() ? _street_rules : shipped_rules("street.cga");
	if (rules.is_null()) {
		diagnostics.warning("missing-street-rules", "the street rules that ship, rules/cga/street.cga, are not there, so streets are plain",
				"install the whole addon, set `street_rules`, or switch `use_street_rules` off");
		return;
	}
	if (rules->get_dialect() != PCGRuleSet::DIALECT_CGA) {
		diagnostics.error("wrong-dialect", "the street rules write agendas, so streets are plain", "give `street_rules` a .cga file");
		return;
	}
	diagnostics.append(rules->diagnostics());
	input.streets = { rules->program(), {}, from_godot(_street_attributes, diagnostics) };
}

} // namespace pcg
