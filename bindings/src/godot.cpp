#include <godot_cpp/godot.hpp>

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/doc_data.hpp>
#include <godot_cpp/core/wrapper_registry.hpp>
#include <godot_cpp/variant/variant.hpp>

namespace godot {

namespace internal {

EngineInterface engine;
GDExtensionClassLibraryPtr library = nullptr;
void *token = nullptr;

namespace {

GDExtensionBinding::Callback initializer = nullptr;
GDExtensionBinding::Callback terminator = nullptr;
GDExtensionInitializationLevel minimum_level = GDEXTENSION_INITIALIZATION_SCENE;

} // namespace
} // namespace internal

using namespace internal;

GDExtensionBinding::InitObject::InitObject(GDExtensionInterfaceGetProcAddress p_get_proc_address,
                                           GDExtensionClassLibraryPtr p_library,
                                           GDExtensionInitialization *r_initialization)
    : get_proc_address(p_get_proc_address), library(p_library), initialization(r_initialization) {}

void GDExtensionBinding::InitObject::register_initializer(Callback p_init) const {
	initializer = p_init;
}

void GDExtensionBinding::InitObject::register_terminator(Callback p_terminate) const {
	terminator = p_terminate;
}

void GDExtensionBinding::InitObject::set_minimum_library_initialization_level(ModuleInitializationLevel p_level) const {
	minimum_level = static_cast<GDExtensionInitializationLevel>(p_level);
}

GDExtensionBool GDExtensionBinding::InitObject::init() const {
	engine.load(get_proc_address);
	internal::library = library;
	token = library;
	initialization->minimum_initialization_level = minimum_level;
	initialization->initialize = initialize_level;
	initialization->deinitialize = deinitialize_level;
	if (!engine.classdb_register_extension_class5) {
		engine.print_error_with_message("The engine is too old for this extension.", "It needs Godot 4.5 or newer.",
		                                "init", __FILE__, __LINE__, false);
		return false;
	}
	init_variant();
	register_engine_classes();
	return true;
}

void GDExtensionBinding::initialize_level(void *, GDExtensionInitializationLevel p_level) {
	ClassDB::set_level(p_level);
	if (initializer) {
		initializer(static_cast<ModuleInitializationLevel>(p_level));
	}
	if (p_level == GDEXTENSION_INITIALIZATION_EDITOR) {
		load_doc_data();
	}
}

void GDExtensionBinding::deinitialize_level(void *, GDExtensionInitializationLevel p_level) {
	ClassDB::set_level(p_level);
	if (terminator) {
		terminator(static_cast<ModuleInitializationLevel>(p_level));
	}
	ClassDB::deinitialize(p_level);
	if (p_level == minimum_level) {
		release_singletons();
		clear_wrapper_registry();
	}
}

} // namespace godot
