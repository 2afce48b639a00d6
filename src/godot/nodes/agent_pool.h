#pragma once

#include <vector>

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/classes/packed_scene.hpp>
#include <godot_cpp/classes/ref.hpp>

#include "godot/nodes/pcg_agent.h"

namespace pcg {

// Scenes of agents that wait outside the tree for their next person, so that nobody is instantiated at each door.
class AgentPool {
public:
	AgentPool() = default;
	~AgentPool() { clear(); }
	AgentPool(const AgentPool &) = delete;
	AgentPool &operator=(const AgentPool &) = delete;

	// Frees whoever waits, if it is another scene. Null: the addon's own.
	void set_scene(const godot::Ref<godot::PackedScene> &scene);
	godot::Ref<godot::PackedScene> scene() const { return _scene; }
	// A scene outside the tree, or null, with one error for each scene that cannot be one.
	PCGAgent *take();
	void give_back(PCGAgent *agent);
	void clear();
	size_t size() const { return _waiting.size(); }

private:
	PCGAgent *make();

	godot::Ref<godot::PackedScene> _scene;
	bool _has_failed = false;
	std::vector<PCGAgent *> _waiting; // outside the tree nobody else frees them
};

} // namespace pcg
