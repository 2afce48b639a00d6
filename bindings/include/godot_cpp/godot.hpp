// Entry point of the extension: `GDExtensionBinding::InitObject` and the engine's function table.
#pragma once

#include <gdextension_interface.h>
#include <godot_cpp/core/interface.gen.hpp>

namespace godot {

namespace internal {

// Every function that the engine exports, by its documented name. Filled once by `InitObject::init()`.
extern EngineInterface engine;
extern GDExtensionClassLibraryPtr library;
// Identifies our wrappers among the bindings of other extensions.
extern void *token;

// Made by the source that GodotCPPDocData generates, before the library's entry point is called: help on the extension's classes, as XML
// pages one behind the other, compressed by zlib. `p_data` stays where it is. The editor gets it when it starts.
class DocDataRegistration {
public:
	DocDataRegistration(const char *p_hash, int p_uncompressed_size, int p_compressed_size, const unsigned char *p_data);
};

} // namespace internal

enum ModuleInitializationLevel {
	MODULE_INITIALIZATION_LEVEL_CORE = GDEXTENSION_INITIALIZATION_CORE,
	MODULE_INITIALIZATION_LEVEL_SERVERS = GDEXTENSION_INITIALIZATION_SERVERS,
	MODULE_INITIALIZATION_LEVEL_SCENE = GDEXTENSION_INITIALIZATION_SCENE,
	MODULE_INITIALIZATION_LEVEL_EDITOR = GDEXTENSION_INITIALIZATION_EDITOR
};

class GDExtensionBinding {
public:
	using Callback = void (*)(ModuleInitializationLevel p_level);

	class InitObject {
		GDExtensionInterfaceGetProcAddress get_proc_address;
		GDExtensionClassLibraryPtr library;
		GDExtensionInitialization *initialization;

	public:
		InitObject(GDExtensionInterfaceGetProcAddress p_get_proc_address, GDExtensionClassLibraryPtr p_library,
		           GDExtensionInitialization *r_initialization);

		void register_initializer(Callback p_init) const;
		void register_terminator(Callback p_terminate) const;
		void set_minimum_library_initialization_level(ModuleInitializationLevel p_level) const;

		GDExtensionBool init() const;
	};

private:
	static void initialize_level(void *p_userdata, GDExtensionInitializationLevel p_level);
	static void deinitialize_level(void *p_userdata, GDExtensionInitializationLevel p_level);
};

} // namespace godot
