#include "godot/nodes/pcg_entrance.h"

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/error_macros.hpp>

using namespace godot;

namespace pcg {

void PCGEntrance::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_type", "type"), &PCGEntrance::set_type);
	ClassDB::bind_method(D_METHOD("get_type"), &PCGEntrance::get_type);
	ADD_PROPERTY(PropertyInfo(Variant::STRING, "type"), "set_type", "get_type");
	ClassDB::bind_method(D_METHOD("set_capacity", "capacity"), &PCGEntrance::set_capacity);
	ClassDB::bind_method(D_METHOD("get_capacity"), &PCGEntrance::get_capacity);
	ADD_PROPERTY(PropertyInfo(Variant::INT, "capacity", PROPERTY_HINT_RANGE, "0,1000,1,or_greater"), "set_capacity",
			"get_capacity");
	ClassDB::bind_method(D_METHOD("set_building_id", "id"), &PCGEntrance::set_building_id);
	ClassDB::bind_method(D_METHOD("get_building_id"), &PCGEntrance::get_building_id);
	ADD_PROPERTY(PropertyInfo(Variant::INT, "building_id"), "set_building_id", "get_building_id");
	ClassDB::bind_method(D_METHOD("set_entrance_id", "id"), &PCGEntrance::set_entrance_id);
	ClassDB::bind_method(D_METHOD("get_entrance_id"), &PCGEntrance::get_entrance_id);
	ADD_PROPERTY(PropertyInfo(Variant::INT, "entrance_id"), "set_entrance_id", "get_entrance_id");
	ClassDB::bind_method(D_METHOD("set_reachable", "reachable"), &PCGEntrance::set_reachable);
	ClassDB::bind_method(D_METHOD("is_reachable"), &PCGEntrance::is_reachable);
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "reachable"), "set_reachable", "is_reachable");
}

void PCGEntrance::set_type(const String &p_type) {
	_type = p_type;
	_link.note_change(this);
	update_configuration_warnings();
}

void PCGEntrance::set_capacity(int p_capacity) {
	ERR_FAIL_COND_MSG(p_capacity < 0, "PCGEntrance: a capacity is 0 (not said) or more.");
	_capacity = p_capacity;
	_link.note_change(this);
}

void PCGEntrance::set_building_id(int p_id) {
	_building_id = p_id;
	_link.note_change(this);
}

void PCGEntrance::set_reachable(bool p_reachable) {
	_is_reachable = p_reachable;
	update_configuration_warnings();
}

PackedStringArray PCGEntrance::_get_configuration_warnings() const {
	PackedStringArray warnings;
	CityLink::warn(this, warnings);
	if (_type.is_empty()) {
		warnings.push_back("This entrance has no type. Give it one that rules ask for, such as \"house\", \"school\" or \"workplace\".");
	}
	if (!_is_reachable) {
		warnings.push_back("Nobody can walk to this entrance. Leave free ground between it and the street.");
	}
	return warnings;
}

} // namespace pcg
