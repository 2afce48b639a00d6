#pragma once

#include <functional>

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/string_name.hpp>
#include <godot_cpp/variant/vector3.hpp>

#include "core/ports/agent_host.h"

namespace pcg {

// What the scene of an agent knows of its person. A child of the scene's root; PCGAgentView adds one where a scene has none. Scenes come out of a
// pool: one shows many persons, one after the other.
class PCGAgent : public godot::Node {
	GDCLASS(PCGAgent, godot::Node)

public:
	int get_person() const { return _person; }
	godot::Dictionary get_looks() const { return _looks; }
	godot::StringName get_pose() const;
	godot::Vector3 get_velocity() const { return _velocity; }
	void set_moves_itself(bool p_enabled) { _moves_itself = p_enabled; }
	bool get_moves_itself() const { return _moves_itself; }
	void set_shows_figure(bool p_enabled) { _shows_figure = p_enabled; }
	bool get_shows_figure() const { return _shows_figure; }

	// From here on not for scripts.
	void assign(int person, const godot::Dictionary &looks, std::function<void()> on_lost);
	void release();
	void set_pose(AgentPose pose);
	void set_velocity(const godot::Vector3 &velocity) { _velocity = velocity; }
	// What avoidance made of the velocity that was last wished for; as of the last physics step.
	const godot::Vector3 &safe_velocity() const { return _safe_velocity; }
	void set_safe_velocity(const godot::Vector3 &p_velocity) { _safe_velocity = p_velocity; }
	godot::Node3D *root() const { return cast_to<godot::Node3D>(get_parent()); }

protected:
	static void _bind_methods();
	void _notification(int p_what);

private:
	int _person = -1; // nobody
	godot::Dictionary _looks;
	AgentPose _pose = AgentPose::Stand;
	godot::Vector3 _velocity;
	godot::Vector3 _safe_velocity;
	bool _moves_itself = false;
	bool _shows_figure = true;
	std::function<void()> _on_lost; // the scene leaves the tree, and nobody of ours took it out
};

} // namespace pcg
