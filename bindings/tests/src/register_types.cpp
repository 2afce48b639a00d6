#include "probe_checks.h"
#include "probe_loader.h"
#include "probe_node.h"
#include "probe_values.h"

#include <godot_cpp/classes/resource_loader.hpp>
#include <godot_cpp/classes/resource_saver.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/defs.hpp>
#include <godot_cpp/godot.hpp>

using namespace godot;

namespace {

Ref<ProbeLoader> loader;
Ref<ProbeSaver> saver;

void initialize_probe_module(ModuleInitializationLevel p_level) {
	if (p_level != MODULE_INITIALIZATION_LEVEL_SCENE) {
		return;
	}
	GDREGISTER_CLASS(ProbeNode);
	GDREGISTER_CLASS(ProbeChild);
	GDREGISTER_ABSTRACT_CLASS(ProbeShape);
	GDREGISTER_INTERNAL_CLASS(ProbeCircle);
	GDREGISTER_RUNTIME_CLASS(ProbeRuntimeNode);
	GDREGISTER_CLASS(ProbeValues);
	GDREGISTER_CLASS(ProbeResource);
	GDREGISTER_CLASS(ProbeLoader);
	GDREGISTER_CLASS(ProbeSaver);
	GDREGISTER_CLASS(ProbeChecks);
	loader.instantiate();
	saver.instantiate();
	ResourceLoader::get_singleton()->add_resource_format_loader(loader);
	ResourceSaver::get_singleton()->add_resource_format_saver(saver);
}

void uninitialize_probe_module(ModuleInitializationLevel p_level) {
	if (p_level != MODULE_INITIALIZATION_LEVEL_SCENE) {
		return;
	}
	ResourceLoader::get_singleton()->remove_resource_format_loader(loader);
	ResourceSaver::get_singleton()->remove_resource_format_saver(saver);
	loader.unref();
	saver.unref();
}

} // namespace

extern "C" GDExtensionBool GDE_EXPORT probe_library_init(GDExtensionInterfaceGetProcAddress p_get_proc_address,
                                                         GDExtensionClassLibraryPtr p_library,
                                                         GDExtensionInitialization *r_initialization) {
	GDExtensionBinding::InitObject init(p_get_proc_address, p_library, r_initialization);
	init.register_initializer(initialize_probe_module);
	init.register_terminator(uninitialize_probe_module);
	init.set_minimum_library_initialization_level(MODULE_INITIALIZATION_LEVEL_SCENE);
	return init.init();
}
