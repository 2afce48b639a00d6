#include <godot_cpp/core/class_db.hpp>

#include "godot/nodes/citizen_manager.h"
#include "godot/nodes/pcg_agent_view.h"
#include "godot/nodes/pcg_city.h"

using namespace godot;

namespace pcg {

void CitizenManager::_bind_methods() {
	bind_properties();
	bind_queries();
	ClassDB::bind_method(D_METHOD("generate_population"), &CitizenManager::generate_population);
	ClassDB::bind_method(D_METHOD("clear_population"), &CitizenManager::clear_population);
	ClassDB::bind_method(D_METHOD("start"), &CitizenManager::start);
	ClassDB::bind_method(D_METHOD("stop"), &CitizenManager::stop);
	ClassDB::bind_method(D_METHOD("is_running"), &CitizenManager::is_running);
	ClassDB::bind_method(D_METHOD("advance", "seconds"), &CitizenManager::advance);
	ClassDB::bind_method(D_METHOD("jump_to", "day", "seconds"), &CitizenManager::jump_to);

	bind_changes();
	bind_signals();
}

void CitizenManager::bind_changes() {
	ClassDB::bind_method(D_METHOD("renew_agendas", "at_once"), &CitizenManager::renew_agendas, DEFVAL(false));
	ClassDB::bind_method(D_METHOD("insert_task", "person", "task"), &CitizenManager::insert_task);
	ClassDB::bind_method(D_METHOD("take_over", "person"), &CitizenManager::take_over);
	ClassDB::bind_method(D_METHOD("place_taken", "person", "position"), &CitizenManager::place_taken);
	ClassDB::bind_method(D_METHOD("release", "person"), &CitizenManager::release);
	ClassDB::bind_method(D_METHOD("add_people", "people"), &CitizenManager::add_people);
	ClassDB::bind_method(D_METHOD("remove_person", "person"), &CitizenManager::remove_person);
	ClassDB::bind_method(D_METHOD("save_state"), &CitizenManager::save_state);
	ClassDB::bind_method(D_METHOD("load_state", "bytes"), &CitizenManager::load_state);
	ClassDB::bind_method(D_METHOD("save_state_file", "path"), &CitizenManager::save_state_file);
	ClassDB::bind_method(D_METHOD("load_state_file", "path"), &CitizenManager::load_state_file);
	ClassDB::bind_method(D_METHOD("keep_population"), &CitizenManager::keep_population);
}

void CitizenManager::bind_signals() {
	const PropertyInfo person(Variant::INT, "person"), building(Variant::INT, "building");
	ADD_SIGNAL(MethodInfo("population_generated"));
	ADD_SIGNAL(MethodInfo("agendas_renewed"));
	ADD_SIGNAL(MethodInfo("simulation_started"));
	ADD_SIGNAL(MethodInfo("simulation_stopped"));
	ADD_SIGNAL(MethodInfo("time_jumped"));
	ADD_SIGNAL(MethodInfo("day_started", PropertyInfo(Variant::INT, "day")));
	ADD_SIGNAL(MethodInfo("person_left_building", person, building));
	ADD_SIGNAL(MethodInfo("person_entered_building", person, building));
	ADD_SIGNAL(MethodInfo("task_started", person, PropertyInfo(Variant::STRING, "kind")));
	ADD_SIGNAL(MethodInfo("agent_spawned", person));
	ADD_SIGNAL(MethodInfo("agent_freed", person));
	ADD_SIGNAL(MethodInfo("task_dropped", person, PropertyInfo(Variant::DICTIONARY, "task"), PropertyInfo(Variant::STRING, "reason"),
			PropertyInfo(Variant::STRING, "required")));
	ADD_SIGNAL(MethodInfo("promise_broken", PropertyInfo(Variant::INT, "count")));
}

// Long because a class's properties are one table.
void CitizenManager::bind_properties() {
	ClassDB::bind_method(D_METHOD("set_city", "city"), &CitizenManager::set_city);
	ClassDB::bind_method(D_METHOD("get_city"), &CitizenManager::get_city);
	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "city", PROPERTY_HINT_NODE_TYPE, "PCGCity"), "set_city", "get_city");
	ClassDB::bind_method(D_METHOD("set_rules", "rules"), &CitizenManager::set_rules);
	ClassDB::bind_method(D_METHOD("get_rules"), &CitizenManager::get_rules);
	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "rules", PROPERTY_HINT_RESOURCE_TYPE, "PCGRuleSet"), "set_rules", "get_rules");
	ClassDB::bind_method(D_METHOD("set_start_rule", "rule"), &CitizenManager::set_start_rule);
	ClassDB::bind_method(D_METHOD("get_start_rule"), &CitizenManager::get_start_rule);
	ADD_PROPERTY(PropertyInfo(Variant::STRING, "start_rule"), "set_start_rule", "get_start_rule");
	ClassDB::bind_method(D_METHOD("set_attributes", "attributes"), &CitizenManager::set_attributes);
	ClassDB::bind_method(D_METHOD("get_attributes"), &CitizenManager::get_attributes);
	ADD_PROPERTY(PropertyInfo(Variant::DICTIONARY, "attributes"), "set_attributes", "get_attributes");
	ClassDB::bind_method(D_METHOD("set_household_table", "table"), &CitizenManager::set_household_table);
	ClassDB::bind_method(D_METHOD("get_household_table"), &CitizenManager::get_household_table);
	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "household_table", PROPERTY_HINT_RESOURCE_TYPE, "PCGHouseholdTable"),
			"set_household_table", "get_household_table");
	ClassDB::bind_method(D_METHOD("set_population", "population"), &CitizenManager::set_population);
	ClassDB::bind_method(D_METHOD("get_population"), &CitizenManager::get_population);
	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "population", PROPERTY_HINT_RESOURCE_TYPE, "PCGPopulation"), "set_population", "get_population");
	ClassDB::bind_method(D_METHOD("set_person_count", "count"), &CitizenManager::set_person_count);
	ClassDB::bind_method(D_METHOD("get_person_count"), &CitizenManager::get_person_count);
	ADD_PROPERTY(PropertyInfo(Variant::INT, "person_count", PROPERTY_HINT_RANGE, "0,10000,1,or_greater"), "set_person_count",
			"get_person_count");
	ClassDB::bind_method(D_METHOD("set_home_type", "type"), &CitizenManager::set_home_type);
	ClassDB::bind_method(D_METHOD("get_home_type"), &CitizenManager::get_home_type);
	ADD_PROPERTY(PropertyInfo(Variant::STRING, "home_type"), "set_home_type", "get_home_type");
	ClassDB::bind_method(D_METHOD("set_seed", "seed"), &CitizenManager::set_seed);
	ClassDB::bind_method(D_METHOD("get_seed"), &CitizenManager::get_seed);
	ADD_PROPERTY(PropertyInfo(Variant::INT, "seed"), "set_seed", "get_seed");
	ClassDB::bind_method(D_METHOD("set_auto_start", "enabled"), &CitizenManager::set_auto_start);
	ClassDB::bind_method(D_METHOD("get_auto_start"), &CitizenManager::get_auto_start);
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "auto_start"), "set_auto_start", "get_auto_start");

	ADD_GROUP("Clock", "");
	ClassDB::bind_method(D_METHOD("set_day", "day"), &CitizenManager::set_day);
	ClassDB::bind_method(D_METHOD("get_day"), &CitizenManager::get_day);
	ADD_PROPERTY(PropertyInfo(Variant::INT, "day"), "set_day", "get_day");
	ClassDB::bind_method(D_METHOD("set_time", "seconds"), &CitizenManager::set_time);
	ClassDB::bind_method(D_METHOD("get_time"), &CitizenManager::get_time);
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "time", PROPERTY_HINT_RANGE, "0,86400,1,suffix:s"), "set_time", "get_time");
	ClassDB::bind_method(D_METHOD("set_time_scale", "scale"), &CitizenManager::set_time_scale);
	ClassDB::bind_method(D_METHOD("get_time_scale"), &CitizenManager::get_time_scale);
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "time_scale", PROPERTY_HINT_RANGE, "0,3600,1,or_greater"), "set_time_scale",
			"get_time_scale");
	ClassDB::bind_method(D_METHOD("set_paused", "paused"), &CitizenManager::set_paused);
	ClassDB::bind_method(D_METHOD("is_paused"), &CitizenManager::is_paused);
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "paused"), "set_paused", "is_paused");

	ADD_GROUP("Records", "");
	ClassDB::bind_method(D_METHOD("set_record_lives", "enabled"), &CitizenManager::set_record_lives);
	ClassDB::bind_method(D_METHOD("get_record_lives"), &CitizenManager::get_record_lives);
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "record_lives"), "set_record_lives", "get_record_lives");
	ClassDB::bind_method(D_METHOD("set_check_promises", "enabled"), &CitizenManager::set_check_promises);
	ClassDB::bind_method(D_METHOD("get_check_promises"), &CitizenManager::get_check_promises);
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "check_promises"), "set_check_promises", "get_check_promises");
}

void CitizenManager::bind_queries() {
	ClassDB::bind_method(D_METHOD("get_clock_text"), &CitizenManager::get_clock_text);
	ClassDB::bind_static_method("CitizenManager", D_METHOD("format_clock", "seconds"), &CitizenManager::format_clock);
	ClassDB::bind_method(D_METHOD("count_persons"), &CitizenManager::count_persons);
	ClassDB::bind_method(D_METHOD("get_person", "person"), &CitizenManager::get_person);
	ClassDB::bind_method(D_METHOD("get_looks", "person"), &CitizenManager::get_looks);
	ClassDB::bind_method(D_METHOD("find_persons", "predicate"), &CitizenManager::find_persons);
	ClassDB::bind_method(D_METHOD("has_person", "person"), &CitizenManager::has_person);
	ClassDB::bind_method(D_METHOD("get_agenda", "person", "day"), &CitizenManager::get_agenda, DEFVAL(-1));
	ClassDB::bind_method(D_METHOD("get_monitor", "monitor"), &CitizenManager::get_monitor);
	ClassDB::bind_method(D_METHOD("get_persons_outside"), &CitizenManager::get_persons_outside);
	ClassDB::bind_method(D_METHOD("get_persons_inside", "building"), &CitizenManager::get_persons_inside);
	ClassDB::bind_method(D_METHOD("get_statistics"), &CitizenManager::get_statistics);
	ClassDB::bind_method(D_METHOD("get_broken_promises"), &CitizenManager::get_broken_promises);
	ClassDB::bind_method(D_METHOD("get_broken_promise_examples"), &CitizenManager::get_broken_promise_examples);
	ClassDB::bind_method(D_METHOD("get_diagnostics"), &CitizenManager::get_diagnostics);
	ClassDB::bind_method(D_METHOD("choose_household"), &CitizenManager::choose_household);
	ClassDB::bind_method(D_METHOD("tell_day", "household", "day"), &CitizenManager::tell_day);
	ClassDB::bind_method(D_METHOD("save_heat_map", "path", "group"), &CitizenManager::save_heat_map, DEFVAL(""));
	ClassDB::bind_static_method("CitizenManager", D_METHOD("get_age_groups"), &CitizenManager::get_age_groups);
	ClassDB::bind_method(D_METHOD("has_recorded_lives"), &CitizenManager::has_recorded_lives);
	ClassDB::bind_method(D_METHOD("get_heat_image", "group", "hour"), &CitizenManager::get_heat_image, DEFVAL(""), DEFVAL(-1));
	ClassDB::bind_method(D_METHOD("get_heat_area"), &CitizenManager::get_heat_area);
	ClassDB::bind_method(D_METHOD("save_lives", "path"), &CitizenManager::save_lives);
	ClassDB::bind_method(D_METHOD("get_agent_view"), &CitizenManager::get_agent_view);
}

} // namespace pcg
