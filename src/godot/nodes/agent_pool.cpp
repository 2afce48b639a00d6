#include "godot/nodes/agent_pool.h"

#include <godot_cpp/classes/resource_loader.hpp>
#include <godot_cpp/core/error_macros.hpp>

using namespace godot;

namespace pcg {

namespace {

constexpr const char *shipped_scene = "res://addons/pcg/figure/agent.tscn";

PCGAgent *find_link(Node *root) {
	for (int i = 0; i < root->get_child_count(); ++i) {
		if (PCGAgent *link = Object::cast_to<PCGAgent>(root->get_child(i))) {
			return link;
		}
	}
	return nullptr;
}

} // namespace

void AgentPool::set_scene(const Ref<PackedScene> &scene) {
	if (scene != _scene) {
		clear();
		_scene = scene;
		_has_failed = false;
	}
}

PCGAgent *AgentPool::make() {
	const Ref<PackedScene> scene = _scene.is_valid() ? _scene : Ref<PackedScene>(ResourceLoader::get_singleton()->load(shipped_scene));
	ERR_FAIL_COND_V_MSG(scene.is_null(), nullptr,
			String("PCGAgentView: ") + shipped_scene + " is missing, so nobody gets a scene. Install the whole folder addons/pcg, or set agent_scene.");
	Node *root = scene->instantiate();
	if (Object::cast_to<Node3D>(root) == nullptr) {
		if (root) {
			memdelete(root);
		}
		ERR_FAIL_V_MSG(nullptr, "PCGAgentView: the root of agent_scene is no Node3D, so nobody gets a scene. Choose a scene that stands somewhere in 3D.");
	}
	PCGAgent *link = find_link(root);
	if (!link) {
		link = memnew(PCGAgent);
		link->set_name("PCGAgent");
		root->add_child(link);
	}
	return link;
}

PCGAgent *AgentPool::take() {
	if (!_waiting.empty()) {
		PCGAgent *agent = _waiting.back();
		_waiting.pop_back();
		return agent;
	}
	PCGAgent *agent = _has_failed ? nullptr : make();
	_has_failed = agent == nullptr;
	return agent;
}

void AgentPool::give_back(PCGAgent *agent) { _waiting.push_back(agent); }

void AgentPool::clear() {
	for (PCGAgent *agent : _waiting) {
		memdelete(agent->root());
	}
	_waiting.clear();
}

} // namespace pcg
