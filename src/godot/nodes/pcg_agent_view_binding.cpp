#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/error_macros.hpp>

#include "godot/nodes/pcg_agent_view.h"

using namespace godot;

namespace pcg {

void PCGAgentView::_bind_methods() {
	bind_limits();
	ClassDB::bind_method(D_METHOD("set_camera", "camera"), &PCGAgentView::set_camera);
	ClassDB::bind_method(D_METHOD("get_camera"), &PCGAgentView::get_camera);
	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "camera", PROPERTY_HINT_NODE_TYPE, "Camera3D", PROPERTY_USAGE_NONE), "set_camera", "get_camera");
	ClassDB::bind_method(D_METHOD("get_agent_count"), &PCGAgentView::get_agent_count);
	ClassDB::bind_method(D_METHOD("get_scene_count"), &PCGAgentView::get_scene_count);
	ClassDB::bind_method(D_METHOD("get_pool_size"), &PCGAgentView::get_pool_size);
	ClassDB::bind_method(D_METHOD("has_agent", "person"), &PCGAgentView::has_agent);
	ClassDB::bind_method(D_METHOD("get_agent_position", "person"), &PCGAgentView::get_agent_position);
	ClassDB::bind_method(D_METHOD("get_shown_position", "person"), &PCGAgentView::get_shown_position);
	ClassDB::bind_method(D_METHOD("get_level", "person"), &PCGAgentView::get_level);
	ClassDB::bind_method(D_METHOD("get_agent_node", "person"), &PCGAgentView::get_agent_node);
	ClassDB::bind_method(D_METHOD("pick_person", "from", "direction", "reach"), &PCGAgentView::pick_person, DEFVAL(2000.0));
}

void PCGAgentView::bind_limits() {
	ClassDB::bind_method(D_METHOD("set_agent_scene", "scene"), &PCGAgentView::set_agent_scene);
	ClassDB::bind_method(D_METHOD("get_agent_scene"), &PCGAgentView::get_agent_scene);
	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "agent_scene", PROPERTY_HINT_RESOURCE_TYPE, "PackedScene"), "set_agent_scene", "get_agent_scene");
	ClassDB::bind_method(D_METHOD("set_agent_distance", "metres"), &PCGAgentView::set_agent_distance);
	ClassDB::bind_method(D_METHOD("get_agent_distance"), &PCGAgentView::get_agent_distance);
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "agent_distance", PROPERTY_HINT_RANGE, "0,200,1,or_greater,suffix:m"), "set_agent_distance", "get_agent_distance");
	ClassDB::bind_method(D_METHOD("set_agent_limit", "count"), &PCGAgentView::set_agent_limit);
	ClassDB::bind_method(D_METHOD("get_agent_limit"), &PCGAgentView::get_agent_limit);
	ADD_PROPERTY(PropertyInfo(Variant::INT, "agent_limit", PROPERTY_HINT_RANGE, "0,500,1,or_greater"), "set_agent_limit", "get_agent_limit");
	ClassDB::bind_method(D_METHOD("set_figure_distance", "metres"), &PCGAgentView::set_figure_distance);
	ClassDB::bind_method(D_METHOD("get_figure_distance"), &PCGAgentView::get_figure_distance);
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "figure_distance", PROPERTY_HINT_RANGE, "0,2000,1,or_greater,suffix:m"), "set_figure_distance", "get_figure_distance");
	ClassDB::bind_method(D_METHOD("set_figure_limit", "count"), &PCGAgentView::set_figure_limit);
	ClassDB::bind_method(D_METHOD("get_figure_limit"), &PCGAgentView::get_figure_limit);
	ADD_PROPERTY(PropertyInfo(Variant::INT, "figure_limit", PROPERTY_HINT_RANGE, "0,10000,1,or_greater"), "set_figure_limit", "get_figure_limit");
	ClassDB::bind_method(D_METHOD("set_hysteresis", "share"), &PCGAgentView::set_hysteresis);
	ClassDB::bind_method(D_METHOD("get_hysteresis"), &PCGAgentView::get_hysteresis);
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "hysteresis", PROPERTY_HINT_RANGE, "0,1,0.01"), "set_hysteresis", "get_hysteresis");
	ClassDB::bind_method(D_METHOD("set_switch_budget", "count"), &PCGAgentView::set_switch_budget);
	ClassDB::bind_method(D_METHOD("get_switch_budget"), &PCGAgentView::get_switch_budget);
	ADD_PROPERTY(PropertyInfo(Variant::INT, "switch_budget", PROPERTY_HINT_RANGE, "1,100,1,or_greater"), "set_switch_budget", "get_switch_budget");
}

// Whoever has a scene of the old kind is a figure for a moment.
void PCGAgentView::set_agent_scene(const Ref<PackedScene> &p_scene) {
	if (p_scene == _pool.scene()) {
		return;
	}
	for (size_t i = _agents.size(); i-- > 0;) {
		remove_scene(i);
	}
	_pool.set_scene(p_scene);
}

void PCGAgentView::set_agent_distance(double p_metres) {
	ERR_FAIL_COND_MSG(!(p_metres >= 0.0), "PCGAgentView: agent_distance is 0 m or more.");
	_limits.agent_distance = float(p_metres);
}

void PCGAgentView::set_agent_limit(int p_count) {
	ERR_FAIL_COND_MSG(p_count < 0, "PCGAgentView: agent_limit is 0 or more.");
	_limits.agent_limit = uint32_t(p_count);
}

void PCGAgentView::set_figure_distance(double p_metres) {
	ERR_FAIL_COND_MSG(!(p_metres >= 0.0), "PCGAgentView: figure_distance is 0 m or more.");
	_limits.figure_distance = float(p_metres);
}

void PCGAgentView::set_figure_limit(int p_count) {
	ERR_FAIL_COND_MSG(p_count < 0, "PCGAgentView: figure_limit is 0 or more.");
	_limits.figure_limit = uint32_t(p_count);
}

void PCGAgentView::set_hysteresis(double p_share) {
	ERR_FAIL_COND_MSG(!(p_share >= 0.0 && p_share <= 1.0), "PCGAgentView: hysteresis is 0 to 1.");
	_limits.hysteresis = float(p_share);
}

void PCGAgentView::set_switch_budget(int p_count) {
	ERR_FAIL_COND_MSG(p_count < 1, "PCGAgentView: switch_budget is 1 or more, else nobody could ever come nearer.");
	_limits.switch_budget = uint32_t(p_count);
}

} // namespace pcg
