#pragma once

#include <array>
#include <functional>
#include <memory>
#include <vector>

#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/variant/callable.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/rect2.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/string_name.hpp>
#include <godot_cpp/variant/typed_array.hpp>
#include <godot_cpp/variant/vector3.hpp>

#include "core/agenda/agenda_edit.h"
#include "core/base/diagnostic.h"
#include "core/base/sim_time.h"
#include "godot/nodes/citizen_life.h"
#include "godot/resources/pcg_household_table.h"
#include "godot/resources/pcg_population.h"
#include "godot/resources/pcg_rule_set.h"

namespace pcg {

class PCGAgentView;
class PCGCity;

// Words that frames tell again and again.
struct ToldWords {
	ToldWords();
	std::array<godot::StringName, Notice::kind_count> signals;
	std::array<godot::String, task_kind_count> tasks;
};

// Fills a city with people and lives their days: households from a table, agendas from rules, a clock, and bodies for those outdoors.
class CitizenManager : public godot::Node {
	GDCLASS(CitizenManager, godot::Node)

public:
	CitizenManager();
	~CitizenManager() override;

	void set_city(PCGCity *p_city);
	PCGCity *get_city() const;
	void set_rules(const godot::Ref<PCGRuleSet> &p_rules);
	godot::Ref<PCGRuleSet> get_rules() const { return _rules; }
	void set_start_rule(const godot::String &p_rule) { _start_rule = p_rule; }
	godot::String get_start_rule() const { return _start_rule; }
	void set_attributes(const godot::Dictionary &p_attributes);
	godot::Dictionary get_attributes() const { return _attributes; }
	void set_household_table(const godot::Ref<PCGHouseholdTable> &p_table);
	godot::Ref<PCGHouseholdTable> get_household_table() const { return _table; }
	void set_population(const godot::Ref<PCGPopulation> &p_population);
	godot::Ref<PCGPopulation> get_population() const { return _people; }
	void set_person_count(int p_count);
	int get_person_count() const { return _person_count; }
	void set_home_type(const godot::String &p_type) { _home_type = p_type; }
	godot::String get_home_type() const { return _home_type; }
	void set_seed(int64_t p_seed) { _seed = p_seed; }
	int64_t get_seed() const { return _seed; }
	void set_auto_start(bool p_enabled) { _auto_start = p_enabled; }
	bool get_auto_start() const { return _auto_start; }
	void set_check_promises(bool p_enabled) { _check_promises = p_enabled; }
	bool get_check_promises() const { return _check_promises; }
	void set_record_lives(bool p_enabled);
	bool get_record_lives() const { return _record_lives; }

	// The clock. Before start() it says when life begins; afterwards it is the present, and setting it jumps.
	void set_day(int64_t p_day);
	int get_day() const;
	void set_time(double p_seconds);
	double get_time() const;
	godot::String get_clock_text() const;
	static godot::String format_clock(double p_seconds);
	void set_time_scale(double p_scale);
	double get_time_scale() const { return _time_scale; }
	void set_paused(bool p_paused) { _is_paused = p_paused; }
	bool is_paused() const { return _is_paused; }

	bool generate_population();
	void clear_population();
	bool start();
	void stop();
	bool is_running() const { return _life && _life->simulation; }
	void advance(double p_seconds);
	void jump_to(int64_t p_day, double p_seconds);

	// citizen_manager_live.cpp: changes, also while life goes on
	bool renew_agendas(bool p_at_once);
	bool insert_task(int p_person, const godot::Dictionary &p_task);
	bool take_over(int p_person);
	bool place_taken(int p_person, const godot::Vector3 &p_position);
	bool release(int p_person);
	godot::PackedInt32Array add_people(const godot::Ref<PCGPopulation> &p_people);
	bool remove_person(int p_person);

	// citizen_manager_saving.cpp
	godot::PackedByteArray save_state() const;
	bool load_state(const godot::PackedByteArray &p_bytes);
	godot::Error save_state_file(const godot::String &p_path) const;
	godot::Error load_state_file(const godot::String &p_path);
	godot::Ref<PCGPopulation> keep_population();

	// citizen_manager_queries.cpp
	bool has_person(int p_person) const;
	int count_persons() const { return _life ? int(_life->population.persons.size()) : 0; }
	godot::Dictionary get_person(int p_person) const;
	godot::Dictionary get_looks(int p_person) const;
	godot::PackedInt32Array find_persons(const godot::Callable &p_predicate) const;
	godot::TypedArray<godot::Dictionary> get_agenda(int p_person, int p_day) const;
	godot::PackedInt32Array get_persons_outside() const;
	godot::PackedInt32Array get_persons_inside(int p_building) const;
	godot::Dictionary get_statistics() const;
	godot::Dictionary get_broken_promises() const;
	godot::PackedStringArray get_broken_promise_examples() const;
	godot::TypedArray<godot::Dictionary> get_diagnostics() const;
	int choose_household() const;
	godot::PackedStringArray tell_day(int p_household, int p_day) const;
	godot::Error save_lives(const godot::String &p_path) const;
	PCGAgentView *get_agent_view() const;
	double get_monitor(const godot::String &p_monitor) const; // citizen_manager_monitors.cpp

	// citizen_heat.cpp
	static godot::PackedStringArray get_age_groups();
	bool has_recorded_lives() const { return is_running() && _life->heat; }
	godot::Error save_heat_map(const godot::String &p_path, const godot::String &p_group) const;
	godot::Ref<godot::Image> get_heat_image(const godot::String &p_group, int p_hour) const;
	godot::Rect2 get_heat_area() const;

	void _ready() override;
	void _process(double p_delta) override;
	godot::PackedStringArray _get_configuration_warnings() const override;

protected:
	static void _bind_methods();
	void _notification(int p_what);

private:
	static constexpr const char *no_person = "CitizenManager: there is no such person. Persons are numbered from 0; count_persons() tells how many there are.";
	static constexpr const char *no_lives = "CitizenManager: no lives are recorded: set record_lives, before or after start().";

	static void bind_properties();
	static void bind_queries();
	static void bind_changes();
	static void bind_signals();
	bool check_inputs(Diagnostics &diagnostics) const;
	bool check_place(Diagnostics &diagnostics) const;
	bool let_everybody_go(const char *p_method);
	std::shared_ptr<CitizenLife> new_life() const;
	void draw_people(CitizenLife &life, Diagnostics &diagnostics) const;
	AgendaOptions agenda_options(const CitizenLife &life) const;
	std::vector<AttributeOverride> attributes(Diagnostics &diagnostics) const;
	bool live(const std::function<void(Simulation &)> &begin);
	void begin_record();
	godot::Transform3D city_frame() const; // the identity without a city
	bool take_over_rules();
	bool is_alone(const char *p_method) const;
	bool is_living(int p_person, const char *p_method) const;
	bool tell_change(const AgendaChange &change);
	bool check_task(const Task &task, std::optional<int64_t> day) const;
	PCGAgentView *find_view();
	void open_view();
	void close_view();
	void show_bodies();
	void listen();
	bool move(const std::function<void(Simulation &)> &change);
	bool step_over_midnight(Duration step);
	bool tell_news();
	bool tell_notices();
	void tell_broken_promises();
	void flush_lives() const;
	std::optional<HeatMap> find_heat_map(const godot::String &p_group, int p_hour) const;
	void tell_rule_messages();
	void on_city_generated(bool);
	void on_city_cleared();
	void follow_city();
	bool leave_lost_city();
	void add_monitors();
	void remove_monitors();
	void count_load(double seconds);

	uint64_t _city_id = 0; // of the PCGCity; 0 = none
	godot::Ref<PCGRuleSet> _rules;
	godot::String _start_rule;
	godot::Dictionary _attributes; // of the rules, by name
	godot::Ref<PCGHouseholdTable> _table;
	godot::Ref<PCGPopulation> _people; // null: households are drawn from the table
	int _person_count = 600;
	godot::String _home_type = "house";
	int64_t _seed = 1;
	bool _auto_start = false;
	bool _check_promises = false;
	bool _record_lives = false;
	SimTime _begin = SimTime::at(0, Duration::hours(0));
	double _time_scale = 60.0;
	bool _is_paused = false;

	Diagnostics _diagnostics;
	std::shared_ptr<CitizenLife> _life; // from generate_population() on
	uint64_t _view_id = 0; // of the PCGAgentView, a child, from the first start() on; 0 = none
	double _owed_seconds = 0.0; // of simulated time, below the clock's millisecond
	uint64_t _told_breaks = 0;
	size_t _told_messages = 0; // of the simulation's diagnostics
	const ToldWords _words;
	std::vector<Notice> _spare_notices; // empty, but for its memory
	bool _is_generating = false;
	bool _renews_agendas = false; // at the next midnight
	CitizenLoad _load;
	godot::PackedStringArray _monitors; // that the engine knows of
};

} // namespace pcg
