#pragma once

#include <functional>
#include <memory>

#include <godot_cpp/classes/multi_mesh.hpp>
#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/variant/aabb.hpp>
#include <godot_cpp/variant/vector3.hpp>

#include "core/figure/crowd.h"

namespace pcg {

// Draws everybody outdoors: one MultiMesh for each of the six figures, filled from the core's Crowd once a frame.
class PCGAgentView : public godot::Node3D {
	GDCLASS(PCGAgentView, godot::Node3D)

public:
	int get_agent_count() const { return _crowd ? int(_crowd->size()) : 0; }
	bool has_agent(int p_person) const;
	godot::Vector3 get_agent_position(int p_person) const;

	// From here on not for scripts. `population` must stay until close() or the next open(); `bounds` holds all places where people may be.
	void open(const Population &population, std::function<SimTime()> now, const godot::AABB &bounds);
	void close();
	bool is_open() const { return _crowd != nullptr; }
	Crowd &crowd() { return *_crowd; }
	void show_at(SimTime time);

protected:
	static void _bind_methods();

private:
	void make_figures();
	void upload(size_t kind);

	std::unique_ptr<Crowd> _crowd;
	godot::Ref<godot::MultiMesh> _meshes[figure_kind_count];
};

} // namespace pcg
