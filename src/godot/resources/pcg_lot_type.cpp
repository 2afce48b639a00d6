#include "godot/resources/pcg_lot_type.h"

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/error_macros.hpp>

using namespace godot;

namespace pcg {

void PCGLotType::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_type", "type"), &PCGLotType::set_type);
	ClassDB::bind_method(D_METHOD("get_type"), &PCGLotType::get_type);
	ADD_PROPERTY(PropertyInfo(Variant::STRING, "type"), "set_type", "get_type");
	ClassDB::bind_method(D_METHOD("set_weight", "weight"), &PCGLotType::set_weight);
	ClassDB::bind_method(D_METHOD("get_weight"), &PCGLotType::get_weight);
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "weight", PROPERTY_HINT_RANGE, "0,100,0.1,or_greater"), "set_weight", "get_weight");
	ClassDB::bind_method(D_METHOD("set_rules", "rules"), &PCGLotType::set_rules);
	ClassDB::bind_method(D_METHOD("get_rules"), &PCGLotType::get_rules);
	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "rules", PROPERTY_HINT_RESOURCE_TYPE, "PCGRuleSet"), "set_rules", "get_rules");
	ClassDB::bind_method(D_METHOD("set_start_rule", "rule"), &PCGLotType::set_start_rule);
	ClassDB::bind_method(D_METHOD("get_start_rule"), &PCGLotType::get_start_rule);
	ADD_PROPERTY(PropertyInfo(Variant::STRING, "start_rule"), "set_start_rule", "get_start_rule");
	ClassDB::bind_method(D_METHOD("set_attributes", "attributes"), &PCGLotType::set_attributes);
	ClassDB::bind_method(D_METHOD("get_attributes"), &PCGLotType::get_attributes);
	ADD_PROPERTY(PropertyInfo(Variant::DICTIONARY, "attributes"), "set_attributes", "get_attributes");
}

void PCGLotType::set_type(const String &p_type) {
	_type = p_type;
	emit_changed();
}

void PCGLotType::set_weight(double p_weight) {
	ERR_FAIL_COND_MSG(!(p_weight >= 0.0), "PCGLotType: a weight is 0 or more; it is relative to the weights of the other lot types.");
	_weight = p_weight;
	emit_changed();
}

void PCGLotType::set_rules(const Ref<PCGRuleSet> &p_rules) {
	_rules = p_rules;
	emit_changed();
}

void PCGLotType::set_start_rule(const String &p_rule) {
	_start_rule = p_rule;
	emit_changed();
}

void PCGLotType::set_attributes(const Dictionary &p_attributes) {
	_attributes = p_attributes;
	emit_changed();
}

} // namespace pcg
