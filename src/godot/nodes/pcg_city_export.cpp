#include <godot_cpp/classes/project_settings.hpp>
#include <godot_cpp/core/error_macros.hpp>

#include "core/io/gltf.h"
#include "godot/convert.h"
#include "godot/nodes/pcg_city.h"
#include "godot/ports/engine_files.h"
#include "godot/report.h"

using namespace godot;

namespace pcg {

Error PCGCity::save_gltf(const String &p_path) const {
	ERR_FAIL_COND_V_MSG(!_state, ERR_UNCONFIGURED, "PCGCity: there is no city yet. Call generate() and wait for city_generated.");
	Diagnostics diagnostics;
	EngineFiles pictures;
	write_glb(_state->city, from_godot(ProjectSettings::get_singleton()->globalize_path(p_path)), diagnostics, &pictures);
	report(diagnostics);
	return diagnostics.has_errors() ? ERR_FILE_CANT_WRITE : OK;
}

} // namespace pcg
