#pragma once

#include <chrono>
#include <memory>

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include "core/base/diagnostic.h"
#include "godot/nodes/city_builder.h"
#include "godot/nodes/city_edits.h"
#include "godot/nodes/city_ground.h"
#include "godot/nodes/city_job.h"
#include "godot/ports/tile_baker.h"
#include "godot/resources/pcg_layout.h"
#include "godot/resources/pcg_lot_type.h"

namespace pcg {

// A city in the scene. Generation goes through the stages below; BUILDING and BAKING need the main thread, a few milliseconds a frame.
class PCGCity : public godot::Node3D {
	GDCLASS(PCGCity, godot::Node3D)

public:
	PCGCity();
	~PCGCity() override;

	void set_layout(const godot::Ref<PCGLayout> &p_layout);
	godot::Ref<PCGLayout> get_layout() const { return _layout; }
	void set_lot_types(const godot::TypedArray<PCGLotType> &p_types);
	godot::TypedArray<PCGLotType> get_lot_types() const { return _lot_types; }
	void set_use_street_rules(bool p_enabled) { _use_street_rules = p_enabled; }
	bool get_use_street_rules() const { return _use_street_rules; }
	void set_street_rules(const godot::Ref<PCGRuleSet> &p_rules);
	godot::Ref<PCGRuleSet> get_street_rules() const { return _street_rules; }
	void set_street_attributes(const godot::Dictionary &p_attributes) { _street_attributes = p_attributes; }
	godot::Dictionary get_street_attributes() const { return _street_attributes; }
	void set_seed(int64_t p_seed) { _seed = p_seed; }
	int64_t get_seed() const { return _seed; }
	void set_generate_on_ready(bool p_enabled) { _generate_on_ready = p_enabled; }
	bool get_generate_on_ready() const { return _generate_on_ready; }
	void set_cell_size(double p_metres);
	double get_cell_size() const { return _cell_size; }
	void set_agent_radius(double p_metres);
	double get_agent_radius() const { return _agent_radius; }
	void set_agent_height(double p_metres);
	double get_agent_height() const { return _agent_height; }
	void set_agent_max_climb(double p_metres);
	double get_agent_max_climb() const { return _agent_max_climb; }
	void set_agent_max_slope(double p_degrees);
	double get_agent_max_slope() const { return _agent_max_slope; }

	void set_use_collision(bool p_enabled) { _collision.is_used = p_enabled; }
	bool get_use_collision() const { return _collision.is_used; }
	void set_collision_layer(uint32_t p_layers) { _collision.layer = p_layers; }
	uint32_t get_collision_layer() const { return _collision.layer; }
	void set_collision_mask(uint32_t p_layers) { _collision.mask = p_layers; }
	uint32_t get_collision_mask() const { return _collision.mask; }

	void set_asset_folders(const godot::PackedStringArray &p_folders) { _asset_folders = p_folders; }
	godot::PackedStringArray get_asset_folders() const { return _asset_folders; }

	// Whatever comes of it, city_generated follows once, after this call has returned. False, with one error, if nothing sensible can be made.
	bool generate();
	// The same, but the city is there when it returns.
	bool generate_now();
	void cancel();
	void clear();
	bool is_generating() const { return _stage != Stage::Idle; }
	bool is_generated() const { return _state != nullptr; }

	// pcg_city_edits.cpp: what happens to the city's nodes after it has been made.
	void note_edit(const godot::Node3D *p_node);
	void update_model();
	bool is_updating_navigation() const { return _ground && !_ground->is_idle(); }
	bool has_ground_at(const godot::Vector3 &p_point) const;
	bool regenerate_lot(int p_lot);
	bool regenerate_block(int p_block);
	void set_saved_city(const godot::PackedByteArray &p_bytes) { _saved = p_bytes; }
	godot::PackedByteArray get_saved_city() const;

	godot::TypedArray<godot::Dictionary> get_diagnostics() const;
	godot::Dictionary get_statistics() const;
	godot::PackedVector3Array find_path(const godot::Vector3 &p_from, const godot::Vector3 &p_to) const;
	double get_distance(int p_building, int p_other) const;
	int get_nearest_building(const godot::String &p_type, int p_building) const;
	int get_building_count() const;
	godot::Dictionary get_building(int p_building) const;
	godot::Error save_gltf(const godot::String &p_path) const;

	// From the city's own coordinates to the world's; outside of the tree to the parent's.
	godot::Transform3D frame() const { return is_inside_tree() ? get_global_transform() : get_transform(); }

	// Null before the first generation. Whoever simulates keeps a share, so that a new generation does not pull the ground from under it.
	std::shared_ptr<const CityState> state() const { return _state; }

	static constexpr const char *group = "pcg_cities"; // all cities in the tree

	void _ready() override;
	void _process(double p_delta) override;
	godot::PackedStringArray _get_configuration_warnings() const override;

protected:
	static void _bind_methods();
	void _notification(int p_what);

private:
	static void bind_properties();
	static void bind_streets();
	static void bind_navigation();
	static void bind_collision();

	enum class Stage { Idle, Growing, Building, Baking, Joining };

	bool begin(bool is_async);
	// pcg_city_input.cpp
	bool prepare_job(CityInput &input, Diagnostics &diagnostics) const;
	bool prepare_rules(CityInput &input, Diagnostics &diagnostics) const;
	void prepare_streets(CityInput &input, Diagnostics &diagnostics) const;
	bool load_saved();
	void forget_saved();
	void read_regions(CityState &state) const;
	BakeSettings bake_settings() const;
	void add_bake_warnings(godot::PackedStringArray &warnings) const;
	void adopt_lost_nodes();
	bool can_edit() const { return _stage != Stage::Joining && _state_in_scene != nullptr; }
	void take_in_edits();
	void go_on_with_ground();
	void mark_reach() const; // on the nodes of entrances and zones
	bool regenerate(const std::vector<LotId> &lots);
	void replace_diagnostics(const std::vector<LotId> &lots, const CityJob &job);
	void go_on();
	void go_on_with_stage();
	void start_task(Stage stage);
	void run_task();
	void wait_for_task();
	bool is_task_done() const;
	void begin_building();
	void build_slice();
	void begin_baking();
	void bake_slice();
	void finish();
	void fail();
	void stop();
	void end(bool is_good);
	void tell_end(bool is_good);
	void tear_down();
	void note_seconds(const char *stage);
	void tell_progress(double fraction);

	godot::Ref<PCGLayout> _layout;
	godot::TypedArray<PCGLotType> _lot_types;
	bool _use_street_rules = true;
	godot::Ref<PCGRuleSet> _street_rules; // null: those that ship
	godot::Dictionary _street_attributes;
	int64_t _seed = 1;
	bool _generate_on_ready = false;
	double _cell_size = 0.0; // metres; 0: the map's own
	double _agent_radius = 0.25;
	double _agent_height = 1.75;
	double _agent_max_climb = 0.35;
	double _agent_max_slope = 45.0;
	godot::PackedStringArray _asset_folders;
	CollisionSettings _collision; // of lots that are made from now on

	Stage _stage = Stage::Idle;
	bool _is_async = true;
	int64_t _task = -1; // of the engine's WorkerThreadPool
	std::unique_ptr<CityJob> _job;
	std::unique_ptr<CityBuilder> _builder;
	std::unique_ptr<TileBaker> _baker;
	uint32_t _next_bake = 0, _next_tile = 0; // tiles to begin with, and to wait for
	double _longest_hold = 0.0; // seconds
	double _built_seconds = 0.0, _built_work = 0.0; // of this generation, by CityBuilder::next_work()
	std::chrono::steady_clock::time_point _stage_start;
	godot::Dictionary _seconds; // by stage, of the last generation
	Diagnostics _diagnostics;
	std::shared_ptr<CityState> _state; // of a finished city
	std::shared_ptr<CityState> _state_in_scene; // what nodes are there for; before it is finished, too
	CityEdits _edits{ this };
	std::unique_ptr<CityGround> _ground; // from the first baking on
	bool _is_update_queued = false;
	mutable godot::PackedByteArray _saved; // made when it is asked for; empty: to be made
};

} // namespace pcg
