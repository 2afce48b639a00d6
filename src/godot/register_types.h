#pragma once

#include <godot_cpp/core/class_db.hpp>

void initialize_pcg(godot::ModuleInitializationLevel p_level);
void terminate_pcg(godot::ModuleInitializationLevel p_level);
