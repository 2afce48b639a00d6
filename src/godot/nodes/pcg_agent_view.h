#pragma once

#include <memory>
#include <vector>

#include <godot_cpp/classes/camera3d.hpp>
#include <godot_cpp/classes/multi_mesh.hpp>
#include <godot_cpp/classes/navigation_agent3d.hpp>
#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/classes/packed_scene.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/variant/aabb.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/vector3.hpp>

#include "core/figure/crowd.h"
#include "godot/nodes/agent_pool.h"

namespace pcg {

// Shows everybody outdoors: near the camera a scene each, further off figures, which are one MultiMesh for each of the six kinds.
class PCGAgentView : public godot::Node3D {
	GDCLASS(PCGAgentView, godot::Node3D)

public:
	void set_agent_scene(const godot::Ref<godot::PackedScene> &p_scene);
	godot::Ref<godot::PackedScene> get_agent_scene() const { return _pool.scene(); }
	void set_agent_distance(double p_metres);
	double get_agent_distance() const { return _limits.agent_distance; }
	void set_agent_limit(int p_count);
	int get_agent_limit() const { return int(_limits.agent_limit); }
	void set_figure_distance(double p_metres);
	double get_figure_distance() const { return _limits.figure_distance; }
	void set_figure_limit(int p_count);
	int get_figure_limit() const { return int(_limits.figure_limit); }
	void set_hysteresis(double p_share);
	double get_hysteresis() const { return _limits.hysteresis; }
	void set_switch_budget(int p_count);
	int get_switch_budget() const { return int(_limits.switch_budget); }

	// Null: the current one of the viewport. Neither kept in scenes nor shown in the inspector.
	void set_camera(godot::Camera3D *p_camera) { _camera_id = p_camera ? p_camera->get_instance_id() : 0; }
	godot::Camera3D *get_camera() const;

	int get_agent_count() const { return _crowd ? int(_crowd->size()) : 0; }
	int get_scene_count() const { return int(_agents.size()); }
	int get_pool_size() const { return int(_pool.size()); }
	bool has_agent(int p_person) const;
	godot::Vector3 get_agent_position(int p_person) const;
	godot::Vector3 get_shown_position(int p_person) const;
	godot::String get_level(int p_person) const;
	godot::Node3D *get_agent_node(int p_person) const;
	int pick_person(const godot::Vector3 &p_from, const godot::Vector3 &p_direction, double p_reach) const;

	// From here on not for scripts. What the crowd refers to must stay until close() or the next open(); `bounds` holds all places where people may be.
	void open(std::shared_ptr<Crowd> crowd, const godot::AABB &bounds);
	void close();
	void show_at(SimTime time);
	// The same while the clock stands: only the camera has moved.
	void show_again(SimTime time);

protected:
	static void _bind_methods();
	void _notification(int p_what);

private:
	struct Agent {
		PersonId person = PersonId::Invalid;
		PCGAgent *link = nullptr;
		godot::Node3D *root = nullptr;
		godot::NavigationAgent3D *steering = nullptr; // null: it does not avoid others
		godot::Transform3D frame; // as it was left in the last picture
		godot::Vector3 wish; // the velocity that was last told to the steering
		float fastest = 0.0f; // and its highest speed
	};

	static void bind_limits();
	void make_figures();
	void upload(size_t kind);
	Eye eye() const;
	void show(SimTime time, double seconds);
	double wall_seconds();
	void measure_scale(double simulated, double wall);
	// agent_scenes.cpp
	void take_moves(double seconds);
	void move_scenes(double scale);
	void add_scene(uint32_t slot);
	void remove_scene(size_t index);
	void lose_scene(PCGAgent *link);
	void free_lost_scenes();
	void place_scene(Agent &agent, const Body &body);
	bool may_steer(double scale) const;

	DetailLimits _limits;
	AgentPool _pool;
	uint64_t _camera_id = 0;
	std::shared_ptr<Crowd> _crowd;
	std::vector<Agent> _agents;
	double _scale = 0.0; // seconds of simulated time for each of the pictures'
	double _simulated_seconds = 0.0, _wall_seconds = 0.0; // since it was measured
	uint64_t _last_frame = 0;
	godot::Ref<godot::MultiMesh> _meshes[figure_kind_count];
	godot::PackedFloat32Array _buffers[figure_kind_count]; // kept, so that pictures take no memory
};

} // namespace pcg
