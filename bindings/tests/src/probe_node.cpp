#include "probe_node.h"

#include <godot_cpp/core/class_db.hpp>

using namespace godot;

int ProbeNode::_alive = 0;

ProbeNode::ProbeNode() {
	_alive++;
	// The engine object is there already, and knows us.
	set_name("probe");
	add_to_group("probes");
	add_child(memnew(Node), false, INTERNAL_MODE_FRONT);
}

ProbeNode::~ProbeNode() {
	_alive--;
}

void ProbeNode::set_speed(double p_speed) {
	if (_speed != p_speed) {
		_speed = p_speed;
		emit_signal("speed_changed", p_speed, this);
	}
}

void ProbeNode::set_slot(int p_index, int p_value) {
	ERR_FAIL_INDEX_MSG(p_index, 2, "[expected] no such slot");
	_slots[p_index] = p_value;
}

int ProbeNode::get_slot(int p_index) const {
	ERR_FAIL_INDEX_V_MSG(p_index, 2, -1, "[expected] no such slot");
	return _slots[p_index];
}

String ProbeNode::describe(const String &p_prefix, int p_times, bool p_loud) const {
	String text;
	for (int i = 0; i < p_times; i++) {
		text += p_prefix;
	}
	return p_loud ? text.to_upper() : text;
}

void ProbeNode::_ready() {
	_ready_count++;
}

void ProbeNode::_process(double p_delta) {
	_processed += p_delta;
}

PackedStringArray ProbeNode::_get_configuration_warnings() const {
	return {String::utf8("größer"), "b"};
}

void ProbeNode::_notification(int p_what) {
	switch (p_what) {
	case NOTIFICATION_POSTINITIALIZE:
		_heard.push_back("made");
		break;
	case NOTIFICATION_ENTER_TREE:
		_heard.push_back("entered");
		break;
	case NOTIFICATION_EXIT_TREE:
		_heard.push_back("left");
		break;
	}
}

bool ProbeNode::_set(const StringName &p_name, const Variant &p_value) {
	if (p_name == StringName("dynamic")) {
		_dynamic = p_value;
		return true;
	}
	return false;
}

bool ProbeNode::_get(const StringName &p_name, Variant &r_value) const {
	if (p_name == StringName("dynamic")) {
		r_value = _dynamic;
		return true;
	}
	return false;
}

void ProbeNode::_get_property_list(List<PropertyInfo> *p_list) const {
	p_list->push_back(PropertyInfo(Variant::STRING, "dynamic", PROPERTY_HINT_MULTILINE_TEXT, "hint"));
}

bool ProbeNode::_property_can_revert(const StringName &p_name) const {
	return p_name == StringName("dynamic");
}

bool ProbeNode::_property_get_revert(const StringName &p_name, Variant &r_value) const {
	if (p_name != StringName("dynamic")) {
		return false;
	}
	r_value = "reverted";
	return true;
}

void ProbeNode::_validate_property(PropertyInfo &p_property) const {
	if (p_property.name == StringName("speed") && _mode == MODE_BUSY) {
		p_property.usage |= PROPERTY_USAGE_READ_ONLY;
		p_property.hint_string = "0,20,0.1";
	}
}

String ProbeNode::_to_string() const {
	return vformat("<probe %d %s>", int64_t(_mode), get_name());
}

void ProbeNode::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_speed", "speed"), &ProbeNode::set_speed);
	ClassDB::bind_method(D_METHOD("get_speed"), &ProbeNode::get_speed);
	ClassDB::bind_method(D_METHOD("set_mode", "mode"), &ProbeNode::set_mode);
	ClassDB::bind_method(D_METHOD("get_mode"), &ProbeNode::get_mode);
	ClassDB::bind_method(D_METHOD("set_parts", "parts"), &ProbeNode::set_parts);
	ClassDB::bind_method(D_METHOD("get_parts"), &ProbeNode::get_parts);
	ClassDB::bind_method(D_METHOD("set_slot", "index", "value"), &ProbeNode::set_slot);
	ClassDB::bind_method(D_METHOD("get_slot", "index"), &ProbeNode::get_slot);
	ClassDB::bind_method(D_METHOD("describe", "prefix", "times", "loud"), &ProbeNode::describe, DEFVAL(2),
	                     DEFVAL(false));
	ClassDB::bind_method(D_METHOD("get_ready_count"), &ProbeNode::get_ready_count);
	ClassDB::bind_method(D_METHOD("get_heard"), &ProbeNode::get_heard);
	ClassDB::bind_method(D_METHOD("get_processed"), &ProbeNode::get_processed);
	ClassDB::bind_static_method("ProbeNode", D_METHOD("add", "a", "b"), &ProbeNode::add, DEFVAL(10));
	ClassDB::bind_static_method("ProbeNode", D_METHOD("get_alive"), &ProbeNode::get_alive);

	ADD_GROUP("Motion", "");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "speed", PROPERTY_HINT_RANGE, "0,10,0.1"), "set_speed", "get_speed");
	ADD_SUBGROUP("State", "");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "mode", PROPERTY_HINT_ENUM, "Idle,Busy"), "set_mode", "get_mode");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "parts", PROPERTY_HINT_FLAGS, "Arm,Leg"), "set_parts", "get_parts");
	ADD_PROPERTYI(PropertyInfo(Variant::INT, "first_slot"), "set_slot", "get_slot", 0);
	ADD_PROPERTYI(PropertyInfo(Variant::INT, "second_slot"), "set_slot", "get_slot", 1);
	ADD_SIGNAL(MethodInfo("speed_changed", PropertyInfo(Variant::FLOAT, "speed"),
	                      PropertyInfo(Variant::OBJECT, "node", PROPERTY_HINT_NODE_TYPE, "ProbeNode")));
	BIND_ENUM_CONSTANT(MODE_IDLE);
	BIND_ENUM_CONSTANT(MODE_BUSY);
	BIND_BITFIELD_FLAG(PART_ARM);
	BIND_BITFIELD_FLAG(PART_LEG);
	BIND_CONSTANT(LIMIT);
}

PackedStringArray ProbeChild::_get_configuration_warnings() const {
	PackedStringArray warnings = ProbeNode::_get_configuration_warnings();
	warnings.push_back("child");
	return warnings;
}

void ProbeChild::_notification(int p_what) {
	if (p_what == NOTIFICATION_ENTER_TREE) {
		_heard.push_back("child entered");
	} else if (p_what == NOTIFICATION_EXIT_TREE) {
		_heard.push_back("child left");
	}
}

void ProbeChild::_bind_methods() {}

void ProbeShape::_bind_methods() {
	ClassDB::bind_method(D_METHOD("area"), &ProbeShape::area);
}
