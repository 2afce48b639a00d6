#include "godot/register_types.h"

#include <gdextension_interface.h>

#include <godot_cpp/classes/resource_loader.hpp>
#include <godot_cpp/classes/resource_saver.hpp>
#include <godot_cpp/core/defs.hpp>
#include <godot_cpp/godot.hpp>

#include "godot/convert_probe.h"
#include "godot/nodes/citizen_manager.h"
#include "godot/nodes/pcg_agent.h"
#include "godot/nodes/pcg_agent_view.h"
#include "godot/nodes/pcg_city.h"
#include "godot/nodes/pcg_entrance.h"
#include "godot/nodes/pcg_lot.h"
#include "godot/nodes/pcg_object.h"
#include "godot/nodes/pcg_zone.h"
#include "godot/resources/pcg_district.h"
#include "godot/resources/pcg_household_table.h"
#include "godot/resources/pcg_layout.h"
#include "godot/resources/pcg_lot_type.h"
#include "godot/resources/pcg_population.h"
#include "godot/resources/pcg_rule_set.h"
#include "godot/resources/pcg_rule_set_loader.h"
#include "godot/resources/pcg_rule_set_saver.h"

using namespace godot;

namespace {

// The only globals: the engine keeps references to loader and saver until it is told not to.
Ref<pcg::PCGRuleSetLoader> rule_set_loader;
Ref<pcg::PCGRuleSetSaver> rule_set_saver;

} // namespace

void initialize_pcg(ModuleInitializationLevel p_level) {
	if (p_level != MODULE_INITIALIZATION_LEVEL_SCENE) {
		return;
	}
	GDREGISTER_CLASS(pcg::PCGRuleSet);
	GDREGISTER_INTERNAL_CLASS(pcg::PCGRuleSetLoader);
	GDREGISTER_INTERNAL_CLASS(pcg::PCGRuleSetSaver);
	GDREGISTER_ABSTRACT_CLASS(pcg::PCGTextFile);
	GDREGISTER_CLASS(pcg::PCGHouseholdTable);
	GDREGISTER_CLASS(pcg::PCGPopulation);
	GDREGISTER_CLASS(pcg::PCGDistrict);
	GDREGISTER_CLASS(pcg::PCGLayout);
	GDREGISTER_CLASS(pcg::PCGLotType);
	GDREGISTER_CLASS(pcg::PCGLot);
	GDREGISTER_CLASS(pcg::PCGEntrance);
	GDREGISTER_CLASS(pcg::PCGZone);
	GDREGISTER_CLASS(pcg::PCGObject);
	GDREGISTER_CLASS(pcg::PCGCity);
	GDREGISTER_CLASS(pcg::PCGAgent);
	GDREGISTER_CLASS(pcg::PCGAgentView);
	GDREGISTER_CLASS(pcg::CitizenManager);
#ifdef DEBUG_ENABLED
	GDREGISTER_INTERNAL_CLASS(pcg::PCGConvertProbe);
#endif
	rule_set_loader.instantiate();
	ResourceLoader::get_singleton()->add_resource_format_loader(rule_set_loader);
	rule_set_saver.instantiate();
	ResourceSaver::get_singleton()->add_resource_format_saver(rule_set_saver, true); // before the one that writes any resource as .tres
}

void terminate_pcg(ModuleInitializationLevel p_level) {
	if (p_level != MODULE_INITIALIZATION_LEVEL_SCENE) {
		return;
	}
	ResourceLoader::get_singleton()->remove_resource_format_loader(rule_set_loader);
	rule_set_loader.unref();
	ResourceSaver::get_singleton()->remove_resource_format_saver(rule_set_saver);
	rule_set_saver.unref();
}

extern "C" GDExtensionBool GDE_EXPORT pcg_library_init(GDExtensionInterfaceGetProcAddress p_get_proc_address,
		GDExtensionClassLibraryPtr p_library, GDExtensionInitialization *r_initialization) {
	GDExtensionBinding::InitObject init(p_get_proc_address, p_library, r_initialization);
	init.register_initializer(initialize_pcg);
	init.register_terminator(terminate_pcg);
	init.set_minimum_library_initialization_level(MODULE_INITIALIZATION_LEVEL_SCENE);
	return init.init();
}
