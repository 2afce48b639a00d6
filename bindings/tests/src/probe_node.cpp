#include "probe_node.h"

#include <godot_cpp/core/class_db.hpp>

using namespace godot;

void ProbeNode::set_speed(double p_speed) {
	if (_speed != p_speed) {
		_speed = p_speed;
		emit_signal("speed_changed", p_speed);
	}
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

void ProbeNode::_notification(int p_what) {
	if (p_what == NOTIFICATION_ENTER_TREE || p_what == NOTIFICATION_POSTINITIALIZE) {
		_notifications++;
	}
}

void ProbeNode::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_speed", "speed"), &ProbeNode::set_speed);
	ClassDB::bind_method(D_METHOD("get_speed"), &ProbeNode::get_speed);
	ClassDB::bind_method(D_METHOD("set_mode", "mode"), &ProbeNode::set_mode);
	ClassDB::bind_method(D_METHOD("get_mode"), &ProbeNode::get_mode);
	ClassDB::bind_method(D_METHOD("describe", "prefix", "times", "loud"), &ProbeNode::describe, DEFVAL(2), DEFVAL(false));
	ClassDB::bind_method(D_METHOD("get_ready_count"), &ProbeNode::get_ready_count);
	ClassDB::bind_method(D_METHOD("get_notifications"), &ProbeNode::get_notifications);
	ClassDB::bind_static_method("ProbeNode", D_METHOD("add", "a", "b"), &ProbeNode::add);

	ADD_GROUP("Motion", "");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "speed", PROPERTY_HINT_RANGE, "0,10,0.1"), "set_speed", "get_speed");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "mode", PROPERTY_HINT_ENUM, "Idle,Busy"), "set_mode", "get_mode");
	ADD_SIGNAL(MethodInfo("speed_changed", PropertyInfo(Variant::FLOAT, "speed")));
	BIND_ENUM_CONSTANT(MODE_IDLE);
	BIND_ENUM_CONSTANT(MODE_BUSY);
}
