#include <algorithm>
#include <cmath>
#include <set>

#include <godot_cpp/classes/navigation_mesh.hpp>
#include <godot_cpp/classes/navigation_region3d.hpp>
#include <godot_cpp/classes/navigation_server3d.hpp>
#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/classes/world3d.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>

#include "core/city/city_bytes.h"
#include "godot/convert.h"
#include "godot/nodes/city_link.h"
#include "godot/nodes/pcg_city.h"
#include "godot/nodes/pcg_lot.h"
#include "godot/report.h"

using namespace godot;

namespace pcg {

BakeSettings PCGCity::bake_settings() const {
	NavigationServer3D *server = NavigationServer3D::get_singleton();
	const RID map = get_world_3d()->get_navigation_map();
	BakeSettings settings;
	settings.map_cell_size = float(server->map_get_cell_size(map));
	settings.cell_size = settings.map_cell_size * std::max(1.0f, std::round(float(_cell_size) / settings.map_cell_size)); // corners lie on the map's cells
	settings.cell_height = float(server->map_get_cell_height(map));
	settings.agent_radius = float(_agent_radius);
	settings.agent_height = float(_agent_height);
	settings.agent_max_climb = float(_agent_max_climb);
	settings.agent_max_slope = float(_agent_max_slope);
	return settings;
}

void PCGCity::note_edit(const Node3D *p_node) {
	_edits.note(p_node);
	if (!_is_update_queued) {
		_is_update_queued = true;
		callable_mp(this, &PCGCity::take_in_edits).call_deferred();
	}
}

void PCGCity::take_in_edits() {
	_is_update_queued = false;
	update_model();
}

// Nodes leave the tree with their city, and come back with it: that is no edit.
void PCGCity::update_model() {
	if (!is_inside_tree() || !can_edit()) {
		return;
	}
	const CityEdits::Changes changes = _edits.take_in();
	if (_ground && changes.has_new_ground) {
		_ground->change(_edits.patches());
		forget_saved();
	}
	if (changes.has_new_ground) {
		_edits.mark_overlaps();
	}
	if (!_state) {
		return; // not finished: ways are found afterwards
	}
	if (changes.has_new_doors) {
		_state->paths->prepare();
	}
	if (changes.has_new_doors || changes.has_new_zones) {
		mark_reach();
	}
	set_process(is_generating() || !_ground->is_idle());
	if (changes.has_edits) {
		emit_signal("city_edited");
	}
}

void PCGCity::mark_reach() const {
	_edits.mark_reach(reach_of_entrances(_state->city.model, _state->ground), reach_of_zones(_state->city.model, _state->ground));
}

void PCGCity::go_on_with_ground() {
	if (_ground->go_on()) {
		forget_saved();
		CityBuilder builder(this, _state->city);
		for (const CityGround::Baked &baked : _ground->baked()) {
			builder.add_region(baked.tile, baked.mesh);
		}
		mark_reach();
		emit_signal("navigation_updated");
	}
	set_process(is_generating() || (_ground && !_ground->is_idle()));
}

bool PCGCity::has_ground_at(const Vector3 &p_point) const {
	if (!_state || !is_inside_tree()) {
		return false;
	}
	const glm::vec3 point = from_godot(get_global_transform().affine_inverse().xform(p_point));
	const Layout &layout = _state->city.layout;
	return point.x >= layout.min.x && point.x <= layout.max.x && point.z >= layout.min.z && point.z <= layout.max.z;
}

void PCGCity::adopt_lost_nodes() {
	const TypedArray<Node> lost = get_tree()->get_nodes_in_group(CityLink::lost_group);
	for (int64_t i = 0; i < lost.size(); ++i) {
		Node3D *node = Object::cast_to<Node3D>(Object::cast_to<Node>(lost[i]));
		if (CityLink *link = CityLink::of(node)) {
			link->find_city(node);
		}
	}
}

bool PCGCity::regenerate_lot(int p_lot) {
	ERR_FAIL_COND_V_MSG(!_state || is_generating(), false, "PCGCity: there is no finished city yet. Call generate() and wait for city_generated.");
	ERR_FAIL_COND_V_MSG(p_lot < 0 || size_t(p_lot) >= _state->city.lots.size(), false, "PCGCity: there is no lot of this number. Look at PCGLot.lot_id.");
	return regenerate({ LotId(p_lot) });
}

bool PCGCity::regenerate_block(int p_block) {
	ERR_FAIL_COND_V_MSG(!_state || is_generating(), false, "PCGCity: there is no finished city yet. Call generate() and wait for city_generated.");
	ERR_FAIL_COND_V_MSG(p_block < 0 || size_t(p_block) >= _state->city.layout.blocks.size(), false,
			"PCGCity: there is no block of this number. Look at PCGLot.block_id.");
	return regenerate(_state->city.layout.block(BlockId(p_block)).lots);
}

bool PCGCity::regenerate(const std::vector<LotId> &lots) {
	update_model();
	CityInput input;
	Diagnostics diagnostics;
	if (!prepare_rules(input, diagnostics)) {
		report(diagnostics);
		return false;
	}
	std::vector<std::pair<LotId, PCGLot *>> nodes; // lots that were deleted stay away
	std::vector<LotId> wanted;
	CityBuilder builder(this, _state->city, _collision);
	for (const LotId lot : lots) {
		if (PCGLot *node = _edits.lot_node(lot)) {
			nodes.emplace_back(lot, node);
			wanted.push_back(lot);
			for (const Node *child : builder.clear_lot(node, lot)) {
				_edits.release(child);
			}
			_edits.note_shown(_state->city.lots[index_of(lot)]);
		}
	}
	CityJob job(std::move(input));
	job.state = _state;
	job.do_beside([&] { job.has_succeeded = job.grow_again(wanted); });
	for (const auto &[lot, node] : nodes) {
		builder.fill_lot(node, lot);
		_ground->touch(lot);
	}
	_edits.note_new_ground();
	forget_saved();
	replace_diagnostics(wanted, job);
	report(job.diagnostics);
	update_model();
	return job.has_succeeded && !job.diagnostics.has_errors();
}

// What the rule files of these lots said before was said of other rules, or is said again.
void PCGCity::replace_diagnostics(const std::vector<LotId> &lots, const CityJob &job) {
	std::set<std::string> files;
	for (const LotId lot : lots) {
		const auto rules = job.input().rules.find(_state->city.layout.lot(lot).type);
		if (rules != job.input().rules.end()) {
			files.insert(rules->second.program->files.begin(), rules->second.program->files.end());
		}
	}
	Diagnostics kept;
	for (const Diagnostic &diagnostic : _diagnostics.list()) {
		if (!files.contains(diagnostic.file)) {
			kept.add(diagnostic);
		}
	}
	kept.append(job.diagnostics);
	_diagnostics = std::move(kept);
}

// What was saved of a city that is still on its way stays.
void PCGCity::forget_saved() {
	if (_state) {
		_saved.clear();
	}
}

PackedByteArray PCGCity::get_saved_city() const {
	if (_state && _saved.is_empty()) {
		_saved = to_bytes(city_bytes(_state->city));
	}
	return _saved;
}

void PCGCity::read_regions(CityState &state) const {
	state.regions.resize(state.city.layout.tiles.size());
	const Node *parent = get_node_or_null(NodePath("Navigation"));
	for (size_t i = 0; parent && i < state.regions.size(); ++i) {
		const NavigationRegion3D *region =
				Object::cast_to<NavigationRegion3D>(parent->get_node_or_null(NodePath("Tile" + String::num_int64(int64_t(i)))));
		if (region && region->get_navigation_mesh().is_valid()) {
			state.regions[i] = from_godot(region->get_navigation_mesh());
		}
	}
}

// The nodes came with the scene. False if they are of no use, which is told.
bool PCGCity::load_saved() {
	_diagnostics = Diagnostics();
	std::optional<City> city = city_from_bytes(view_of(_saved), _diagnostics);
	if (!city) {
		report(_diagnostics);
		return false;
	}
	_job = std::make_unique<CityJob>(CityInput());
	_job->state = std::make_shared<CityState>();
	_job->state->city = std::move(*city);
	read_regions(*_job->state);
	_is_async = true;
	_state_in_scene = _job->state;
	_edits.follow(_state_in_scene);
	_edits.restore_ids();
	update_model();
	const BakedGround baked = std::move(_job->state->city.baked);
	_ground = std::make_unique<CityGround>(_job->state, bake_settings(), _edits.patches());
	_ground->touch_changed(baked);
	start_task(Stage::Joining);
	set_process(true);
	return true;
}

} // namespace pcg
