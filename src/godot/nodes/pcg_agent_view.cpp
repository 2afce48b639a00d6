#include "godot/nodes/pcg_agent_view.h"

#include <cstring>

#include <godot_cpp/classes/array_mesh.hpp>
#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/multi_mesh_instance3d.hpp>
#include <godot_cpp/classes/resource_loader.hpp>
#include <godot_cpp/classes/shader.hpp>
#include <godot_cpp/classes/shader_material.hpp>
#include <godot_cpp/classes/viewport.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/projection.hpp>

#include "godot/convert.h"

using namespace godot;

namespace pcg {

namespace {

constexpr const char *figure_shader = "res://addons/pcg/figure/figure.gdshader";
constexpr double scale_window = 0.05; // seconds
constexpr double leap = 0.5; // seconds of simulated time
constexpr int figure_kind_total = int(figure_kind_count);

glm::mat4 to_matrix(const Projection &projection) {
	glm::mat4 matrix;
	for (int i = 0; i < 4; ++i) {
		matrix[i] = { projection[i].x, projection[i].y, projection[i].z, projection[i].w };
	}
	return matrix;
}

glm::mat4 to_matrix(const Transform3D &frame) {
	const auto column = [&](int i) { return glm::vec4(from_godot(frame.basis.get_column(i)), 0.0f); };
	return { column(0), column(1), column(2), glm::vec4(from_godot(frame.origin), 1.0f) };
}

PackedVector3Array tones(glm::vec3 (*tone)(uint8_t)) {
	PackedVector3Array result;
	for (uint8_t i = 0; i < 8; ++i) {
		result.push_back(to_godot(tone(i)));
	}
	return result;
}

} // namespace

bool PCGAgentView::has_agent(int p_person) const { return _crowd && p_person >= 0 && _crowd->has(PersonId(p_person)); }

Vector3 PCGAgentView::get_agent_position(int p_person) const {
	ERR_FAIL_COND_V_MSG(!has_agent(p_person), Vector3(),
			"PCGAgentView: this person has no agent now. Ask has_agent() first: people indoors have none.");
	return to_godot(_crowd->position(PersonId(p_person)));
}

Vector3 PCGAgentView::get_shown_position(int p_person) const {
	ERR_FAIL_COND_V_MSG(!has_agent(p_person), Vector3(),
			"PCGAgentView: this person has no agent now. Ask has_agent() first: people indoors have none.");
	return to_godot(_crowd->body(_crowd->slot_of(PersonId(p_person))).position);
}

String PCGAgentView::get_level(int p_person) const {
	static constexpr const char *names[] = { "data", "figure", "agent" };
	return has_agent(p_person) ? names[size_t(_crowd->level(_crowd->slot_of(PersonId(p_person))))] : "";
}

Node3D *PCGAgentView::get_agent_node(int p_person) const {
	for (const Agent &agent : _agents) {
		if (int(index_of(agent.person)) == p_person) {
			return agent.root;
		}
	}
	return nullptr;
}

int PCGAgentView::pick_person(const Vector3 &p_from, const Vector3 &p_direction, double p_reach) const {
	if (!_crowd || p_direction.is_zero_approx()) {
		return -1;
	}
	const Transform3D local = get_global_transform().affine_inverse();
	const Vector3 direction = local.basis.xform(p_direction).normalized();
	const PersonId person = _crowd->pick(from_godot(local.xform(p_from)), from_godot(direction), float(p_reach));
	return person == PersonId::Invalid ? -1 : int(index_of(person));
}

void PCGAgentView::open(std::shared_ptr<Crowd> crowd, const AABB &bounds) {
	close();
	if (_meshes[0].is_null()) {
		make_figures();
	}
	for (const Ref<MultiMesh> &mesh : _meshes) {
		mesh->set_custom_aabb(bounds);
	}
	_crowd = std::move(crowd);
}

void PCGAgentView::close() {
	while (!_agents.empty()) {
		remove_scene(_agents.size() - 1);
	}
	_crowd.reset();
	for (const Ref<MultiMesh> &mesh : _meshes) {
		if (mesh.is_valid()) {
			mesh->set_visible_instance_count(0);
		}
	}
}

void PCGAgentView::_notification(int p_what) {
	if (p_what == NOTIFICATION_EXIT_TREE) {
		free_lost_scenes();
	}
}

void PCGAgentView::make_figures() {
	Ref<ShaderMaterial> material;
	material.instantiate();
	const Ref<Shader> shader = ResourceLoader::get_singleton()->load(figure_shader);
	if (shader.is_valid()) {
		material->set_shader(shader);
		material->set_shader_parameter("hair_tones", tones(hair_tone));
		material->set_shader_parameter("skin_tones", tones(skin_tone));
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

Camera3D *PCGAgentView::get_camera() const { return Object::cast_to<Camera3D>(ObjectDB::get_instance(_camera_id)); }

// In this node's own coordinates, as are the crowd's.
Eye PCGAgentView::eye() const {
	const Camera3D *camera = get_camera();
	if (!camera && is_inside_tree()) {
		camera = get_viewport()->get_camera_3d();
	}
	if (!camera || !camera->is_inside_tree() || !is_inside_tree()) {
		return {};
	}
	const glm::mat4 to_camera = glm::inverse(to_matrix(camera->get_camera_transform()));
	const Transform3D frame = get_global_transform();
	const glm::vec3 position = from_godot(frame.affine_inverse().xform(camera->get_camera_transform().origin));
	return Eye::at(position, to_matrix(camera->get_camera_projection()) * to_camera * to_matrix(frame));
}

// Since the last picture; nothing where one picture's time is advanced in several steps.
double PCGAgentView::wall_seconds() {
	const uint64_t frame = Engine::get_singleton()->get_process_frames();
	const bool is_new = frame != _last_frame;
	_last_frame = frame;
	return is_new && is_inside_tree() ? get_process_delta_time() : 0.0;
}

// How fast the clock runs. Over several pictures, for simulated time comes in whole milliseconds; a leap shows at once.
void PCGAgentView::measure_scale(double simulated, double wall) {
	_simulated_seconds += simulated;
	_wall_seconds += wall;
	if (_wall_seconds >= scale_window || _simulated_seconds > leap) {
		_scale = _wall_seconds > 0.0 ? _simulated_seconds / _wall_seconds : 0.0;
		_simulated_seconds = _wall_seconds = 0.0;
	}
}

void PCGAgentView::show_at(SimTime time) { show(time, wall_seconds()); }

// Not where a script has advanced the clock for this picture: to show that twice would cost twice, and halt everybody in between.
void PCGAgentView::show_again(SimTime time) {
	if (Engine::get_singleton()->get_process_frames() != _last_frame) {
		show(time, 0.0);
	}
}

void PCGAgentView::show(SimTime time, double seconds) {
	if (!_crowd) {
		return;
	}
	take_moves(seconds);
	_crowd->update(time, eye(), _limits);
	measure_scale(_crowd->step_seconds(), seconds);
	move_scenes(_scale);
	_crowd->write_figures();
	for (size_t kind = 0; kind < figure_kind_count; ++kind) {
		upload(kind);
	}
}

// The engine wants a whole buffer each time; it grows by doubling, so that it is seldom made anew. What lies behind the visible ones is old.
void PCGAgentView::upload(size_t kind) {
	const std::vector<float> &numbers = _crowd->figures(kind);
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
		_buffers[kind].resize(int64_t(capacity) * int64_t(crowd_stride));
		_buffers[kind].fill(0.0f);
	}
	std::memcpy(_buffers[kind].ptrw(), numbers.data(), numbers.size() * sizeof(float));
	mesh->set_buffer(_buffers[kind]);
	mesh->set_visible_instance_count(count);
}

} // namespace pcg
