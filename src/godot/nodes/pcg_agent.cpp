#include "godot/nodes/pcg_agent.h"

#include <utility>

#include <godot_cpp/core/class_db.hpp>

using namespace godot;

namespace pcg {

namespace {

constexpr const char *pose_names[] = { "stand", "walk", "sit" };

} // namespace

void PCGAgent::_bind_methods() {
	ClassDB::bind_method(D_METHOD("get_person"), &PCGAgent::get_person);
	ADD_PROPERTY(PropertyInfo(Variant::INT, "person", PROPERTY_HINT_NONE, "", PROPERTY_USAGE_READ_ONLY), "", "get_person");
	ClassDB::bind_method(D_METHOD("get_looks"), &PCGAgent::get_looks);
	ADD_PROPERTY(PropertyInfo(Variant::DICTIONARY, "looks", PROPERTY_HINT_NONE, "", PROPERTY_USAGE_READ_ONLY), "", "get_looks");
	ClassDB::bind_method(D_METHOD("get_pose"), &PCGAgent::get_pose);
	ADD_PROPERTY(PropertyInfo(Variant::STRING_NAME, "pose", PROPERTY_HINT_NONE, "", PROPERTY_USAGE_READ_ONLY), "", "get_pose");
	ClassDB::bind_method(D_METHOD("get_velocity"), &PCGAgent::get_velocity);
	ADD_PROPERTY(PropertyInfo(Variant::VECTOR3, "velocity", PROPERTY_HINT_NONE, "", PROPERTY_USAGE_READ_ONLY), "", "get_velocity");
	ClassDB::bind_method(D_METHOD("set_moves_itself", "enabled"), &PCGAgent::set_moves_itself);
	ClassDB::bind_method(D_METHOD("get_moves_itself"), &PCGAgent::get_moves_itself);
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "moves_itself"), "set_moves_itself", "get_moves_itself");
	ClassDB::bind_method(D_METHOD("set_shows_figure", "enabled"), &PCGAgent::set_shows_figure);
	ClassDB::bind_method(D_METHOD("get_shows_figure"), &PCGAgent::get_shows_figure);
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "shows_figure"), "set_shows_figure", "get_shows_figure");

	const PropertyInfo person(Variant::INT, "person");
	ADD_SIGNAL(MethodInfo("person_assigned", person));
	ADD_SIGNAL(MethodInfo("person_released", person));
	ADD_SIGNAL(MethodInfo("pose_changed", PropertyInfo(Variant::STRING_NAME, "pose")));
}

StringName PCGAgent::get_pose() const { return pose_names[size_t(_pose)]; }

void PCGAgent::assign(int person, const Dictionary &looks, std::function<void()> on_lost) {
	_person = person;
	_looks = looks;
	_on_lost = std::move(on_lost);
	_pose = AgentPose::Stand;
	_velocity = _safe_velocity = Vector3();
	emit_signal("person_assigned", person);
}

void PCGAgent::release() {
	_on_lost = nullptr;
	const int person = std::exchange(_person, -1);
	emit_signal("person_released", person);
}

void PCGAgent::set_pose(AgentPose pose) {
	if (pose != _pose) {
		_pose = pose;
		emit_signal("pose_changed", get_pose());
	}
}

void PCGAgent::_notification(int p_what) {
	if (p_what == NOTIFICATION_EXIT_TREE && _on_lost) {
		const std::function<void()> on_lost = std::exchange(_on_lost, nullptr);
		_person = -1;
		on_lost();
	}
}

} // namespace pcg
