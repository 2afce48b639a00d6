#include "godot/nodes/pcg_agent_view.h"

#include <cstring>

#include <godot_cpp/classes/array_mesh.hpp>
#include <godot_cpp/classes/multi_mesh_instance3d.hpp>
#include <godot_cpp/classes/resource_loader.hpp>
#include <godot_cpp/classes/shader.hpp>
#include <godot_cpp/classes/shader_material.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>

#include "godot/convert.h"

using namespace godot;

namespace pcg {

namespace {

constexpr const char *figure_shader = "res://addons/pcg/figure/figure.gdshader";
constexpr int figure_kind_total = int(figure_kind_count);

} // namespace

void PCGAgentView::_bind_methods() {
	ClassDB::bind_method(D_METHOD("get_agent_count"), &PCGAgentView::get_agent_count);
	ClassDB::bind_method(D_METHOD("has_agent", "person"), &PCGAgentView::has_agent);
	ClassDB::bind_method(D_METHOD("get_agent_position", "person"), &PCGAgentView::get_agent_position);
}

bool PCGAgentView::has_agent(int p_person) const { return _crowd && p_person >= 0 && _crowd->has(PersonId(p_person)); }

Vector3 PCGAgentView::get_agent_position(int p_person) const {
	ERR_FAIL_COND_V_MSG(!has_agent(p_person), Vector3(),
			"PCGAgentView: this person has no agent now. Ask has_agent() first: people indoors have none.");
	return to_godot(_crowd->position(PersonId(p_person)));
}

void PCGAgentView::open(const Population &population, std::function<SimTime()> now, const AABB &bounds) {
	if (_meshes[0].is_null()) {
		make_figures();
	}
	for (const Ref<MultiMesh> &mesh : _meshes) {
		mesh->set_custom_aabb(bounds);
	}
	_crowd = std::make_unique<Crowd>(population, std::move(now));
}

void PCGAgentView::close() {
	_crowd.reset();
	for (const Ref<MultiMesh> &mesh : _meshes) {
		if (mesh.is_valid()) {
			mesh->set_visible_instance_count(0);
		}
	}
}

void PCGAgentView::make_figures() {
	Ref<ShaderMaterial> material;
	material.instantiate();
	const Ref<Shader> shader = ResourceLoader::get_singleton()->load(figure_shader);
	if (shader.is_valid()) {
		material->set_shader(shader);
	} else {
		ERR_PRINT(String("PCGAgentView: ") + figure_shader + " is missing, people stay white. Install the whole folder addons/pcg.");
	}
	for (int kind = 0; kind < figure_kind_total; ++kind) {
		Ref<ArrayMesh> figure = to_godot(make_figure_of_kind(size_t(kind)));
		figure->surface_set_material(0, material);
		Ref<MultiMesh> mesh;
		mesh.instantiate();
		mesh->set_transform_format(MultiMesh::TRANSFORM_3D);
		mesh->set_use_colors(true);
		mesh->set_use_custom_data(true);
		mesh->set_mesh(figure);
		_meshes[kind] = mesh;
		MultiMeshInstance3D *instance = memnew(MultiMeshInstance3D);
		instance->set_multimesh(mesh);
		add_child(instance, false, INTERNAL_MODE_BACK);
	}
}

void PCGAgentView::show_at(SimTime time) {
	if (!_crowd) {
		return;
	}
	_crowd->update(time);
	for (size_t kind = 0; kind < figure_kind_count; ++kind) {
		upload(kind);
	}
}

// The engine wants a whole buffer each time; it grows by doubling, so that it is seldom made anew.
void PCGAgentView::upload(size_t kind) {
	const std::vector<float> &numbers = _crowd->instances(kind);
	const Ref<MultiMesh> &mesh = _meshes[kind];
	const int count = int(numbers.size() / crowd_stride);
	if (count == 0) {
		mesh->set_visible_instance_count(0);
		return;
	}
	int capacity = mesh->get_instance_count();
	if (capacity < count) {
		while (capacity < count) {
			capacity = capacity < 16 ? 16 : capacity * 2;
		}
		mesh->set_instance_count(capacity);
	}
	PackedFloat32Array buffer;
	buffer.resize(int64_t(capacity) * int64_t(crowd_stride));
	std::memcpy(buffer.ptrw(), numbers.data(), numbers.size() * sizeof(float));
	std::memset(buffer.ptrw() + numbers.size(), 0, (size_t(capacity) * crowd_stride - numbers.size()) * sizeof(float));
	mesh->set_buffer(buffer);
	mesh->set_visible_instance_count(count);
}

} // namespace pcg
