#include <godot_cpp/core/class_db.hpp>

#include "godot/nodes/pcg_city.h"

using namespace godot;

namespace pcg {

void PCGCity::bind_properties() {
	ClassDB::bind_method(D_METHOD("set_layout", "layout"), &PCGCity::set_layout);
	ClassDB::bind_method(D_METHOD("get_layout"), &PCGCity::get_layout);
	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "layout", PROPERTY_HINT_RESOURCE_TYPE, "PCGLayout"), "set_layout", "get_layout");
	ClassDB::bind_method(D_METHOD("set_lot_types", "types"), &PCGCity::set_lot_types);
	ClassDB::bind_method(D_METHOD("get_lot_types"), &PCGCity::get_lot_types);
	const String array_of_lot_types = vformat("%d/%d:PCGLotType", int(Variant::OBJECT), int(PROPERTY_HINT_RESOURCE_TYPE));
	ADD_PROPERTY(PropertyInfo(Variant::ARRAY, "lot_types", PROPERTY_HINT_ARRAY_TYPE, array_of_lot_types), "set_lot_types",
			"get_lot_types");
	ClassDB::bind_method(D_METHOD("set_seed", "seed"), &PCGCity::set_seed);
	ClassDB::bind_method(D_METHOD("get_seed"), &PCGCity::get_seed);
	ADD_PROPERTY(PropertyInfo(Variant::INT, "seed"), "set_seed", "get_seed");
	ClassDB::bind_method(D_METHOD("set_generate_on_ready", "enabled"), &PCGCity::set_generate_on_ready);
	ClassDB::bind_method(D_METHOD("get_generate_on_ready"), &PCGCity::get_generate_on_ready);
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "generate_on_ready"), "set_generate_on_ready", "get_generate_on_ready");
	ClassDB::bind_method(D_METHOD("set_asset_folders", "folders"), &PCGCity::set_asset_folders);
	ClassDB::bind_method(D_METHOD("get_asset_folders"), &PCGCity::get_asset_folders);
	const String array_of_folders = vformat("%d/%d:", int(Variant::STRING), int(PROPERTY_HINT_DIR));
	ADD_PROPERTY(PropertyInfo(Variant::PACKED_STRING_ARRAY, "asset_folders", PROPERTY_HINT_TYPE_STRING, array_of_folders), "set_asset_folders",
			"get_asset_folders");
	ClassDB::bind_method(D_METHOD("set_saved_city", "bytes"), &PCGCity::set_saved_city);
	ClassDB::bind_method(D_METHOD("get_saved_city"), &PCGCity::get_saved_city);
	ADD_PROPERTY(PropertyInfo(Variant::PACKED_BYTE_ARRAY, "saved_city", PROPERTY_HINT_NONE, "", PROPERTY_USAGE_STORAGE), "set_saved_city",
			"get_saved_city");
	bind_streets();
	bind_navigation();
	bind_collision();
}

void PCGCity::bind_streets() {
	ADD_GROUP("Streets", "");
	ClassDB::bind_method(D_METHOD("set_use_street_rules", "enabled"), &PCGCity::set_use_street_rules);
	ClassDB::bind_method(D_METHOD("get_use_street_rules"), &PCGCity::get_use_street_rules);
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "use_street_rules"), "set_use_street_rules", "get_use_street_rules");
	ClassDB::bind_method(D_METHOD("set_street_rules", "rules"), &PCGCity::set_street_rules);
	ClassDB::bind_method(D_METHOD("get_street_rules"), &PCGCity::get_street_rules);
	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "street_rules", PROPERTY_HINT_RESOURCE_TYPE, "PCGRuleSet"), "set_street_rules", "get_street_rules");
	ClassDB::bind_method(D_METHOD("set_street_attributes", "attributes"), &PCGCity::set_street_attributes);
	ClassDB::bind_method(D_METHOD("get_street_attributes"), &PCGCity::get_street_attributes);
	ADD_PROPERTY(PropertyInfo(Variant::DICTIONARY, "street_attributes"), "set_street_attributes", "get_street_attributes");
}

void PCGCity::bind_navigation() {
	ADD_GROUP("Navigation", "");
	ClassDB::bind_method(D_METHOD("set_cell_size", "metres"), &PCGCity::set_cell_size);
	ClassDB::bind_method(D_METHOD("get_cell_size"), &PCGCity::get_cell_size);
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "cell_size", PROPERTY_HINT_RANGE, "0,1,0.05,suffix:m"), "set_cell_size", "get_cell_size");
	ClassDB::bind_method(D_METHOD("set_agent_radius", "metres"), &PCGCity::set_agent_radius);
	ClassDB::bind_method(D_METHOD("get_agent_radius"), &PCGCity::get_agent_radius);
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "agent_radius", PROPERTY_HINT_RANGE, "0,1,0.05,suffix:m"), "set_agent_radius",
			"get_agent_radius");
	ClassDB::bind_method(D_METHOD("set_agent_height", "metres"), &PCGCity::set_agent_height);
	ClassDB::bind_method(D_METHOD("get_agent_height"), &PCGCity::get_agent_height);
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "agent_height", PROPERTY_HINT_RANGE, "0.5,5,0.05,suffix:m"), "set_agent_height", "get_agent_height");
	ClassDB::bind_method(D_METHOD("set_agent_max_climb", "metres"), &PCGCity::set_agent_max_climb);
	ClassDB::bind_method(D_METHOD("get_agent_max_climb"), &PCGCity::get_agent_max_climb);
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "agent_max_climb", PROPERTY_HINT_RANGE, "0,1,0.05,suffix:m"), "set_agent_max_climb",
			"get_agent_max_climb");
	ClassDB::bind_method(D_METHOD("set_agent_max_slope", "degrees"), &PCGCity::set_agent_max_slope);
	ClassDB::bind_method(D_METHOD("get_agent_max_slope"), &PCGCity::get_agent_max_slope);
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "agent_max_slope", PROPERTY_HINT_RANGE, String::utf8("0,90,0.5,suffix:°")), "set_agent_max_slope",
			"get_agent_max_slope");
}

void PCGCity::bind_collision() {
	ADD_GROUP("Collision", "");
	ClassDB::bind_method(D_METHOD("set_use_collision", "enabled"), &PCGCity::set_use_collision);
	ClassDB::bind_method(D_METHOD("get_use_collision"), &PCGCity::get_use_collision);
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "use_collision"), "set_use_collision", "get_use_collision");
	ClassDB::bind_method(D_METHOD("set_collision_layer", "layers"), &PCGCity::set_collision_layer);
	ClassDB::bind_method(D_METHOD("get_collision_layer"), &PCGCity::get_collision_layer);
	ADD_PROPERTY(PropertyInfo(Variant::INT, "collision_layer", PROPERTY_HINT_LAYERS_3D_PHYSICS), "set_collision_layer", "get_collision_layer");
	ClassDB::bind_method(D_METHOD("set_collision_mask", "layers"), &PCGCity::set_collision_mask);
	ClassDB::bind_method(D_METHOD("get_collision_mask"), &PCGCity::get_collision_mask);
	ADD_PROPERTY(PropertyInfo(Variant::INT, "collision_mask", PROPERTY_HINT_LAYERS_3D_PHYSICS), "set_collision_mask", "get_collision_mask");
}

void PCGCity::_bind_methods() {
	bind_properties();
	ClassDB::bind_method(D_METHOD("generate"), &PCGCity::generate);
	ClassDB::bind_method(D_METHOD("generate_now"), &PCGCity::generate_now);
	ClassDB::bind_method(D_METHOD("cancel"), &PCGCity::cancel);
	ClassDB::bind_method(D_METHOD("clear"), &PCGCity::clear);
	ClassDB::bind_method(D_METHOD("is_generating"), &PCGCity::is_generating);
	ClassDB::bind_method(D_METHOD("is_generated"), &PCGCity::is_generated);
	ClassDB::bind_method(D_METHOD("get_diagnostics"), &PCGCity::get_diagnostics);
	ClassDB::bind_method(D_METHOD("get_statistics"), &PCGCity::get_statistics);
	ClassDB::bind_method(D_METHOD("get_building_count"), &PCGCity::get_building_count);
	ClassDB::bind_method(D_METHOD("get_building", "building"), &PCGCity::get_building);
	ClassDB::bind_method(D_METHOD("find_path", "from", "to"), &PCGCity::find_path);
	ClassDB::bind_method(D_METHOD("get_distance", "building", "other"), &PCGCity::get_distance);
	ClassDB::bind_method(D_METHOD("get_nearest_building", "type", "building"), &PCGCity::get_nearest_building);
	ClassDB::bind_method(D_METHOD("update_model"), &PCGCity::update_model);
	ClassDB::bind_method(D_METHOD("is_updating_navigation"), &PCGCity::is_updating_navigation);
	ClassDB::bind_method(D_METHOD("regenerate_lot", "lot"), &PCGCity::regenerate_lot);
	ClassDB::bind_method(D_METHOD("regenerate_block", "block"), &PCGCity::regenerate_block);
	ClassDB::bind_method(D_METHOD("save_gltf", "path"), &PCGCity::save_gltf);

	ADD_SIGNAL(MethodInfo("generation_started"));
	ADD_SIGNAL(MethodInfo("generation_progressed", PropertyInfo(Variant::STRING, "stage"), PropertyInfo(Variant::FLOAT, "fraction")));
	ADD_SIGNAL(MethodInfo("city_generated", PropertyInfo(Variant::BOOL, "success")));
	ADD_SIGNAL(MethodInfo("city_cleared"));
	ADD_SIGNAL(MethodInfo("city_edited"));
	ADD_SIGNAL(MethodInfo("navigation_updated"));
}

} // namespace pcg
