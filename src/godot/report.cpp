#include "godot/report.h"

#include <godot_cpp/classes/project_settings.hpp>
#include <godot_cpp/variant/utility_functions.hpp>

#include "godot/convert.h"

using namespace godot;

namespace pcg {

void report(const Diagnostics &diagnostics) {
	if (diagnostics.is_empty()) {
		return;
	}
	// The engine puts ERROR: or WARNING: before it.
	const String text = to_godot(std::string_view(to_text(diagnostics))).strip_edges().trim_prefix("error: ").trim_prefix("warning: ");
	if (diagnostics.has_errors()) {
		UtilityFunctions::push_error(text);
	} else {
		UtilityFunctions::push_warning(text);
	}
}

Error save_to(const String &path, const std::function<void(const std::string &path, Diagnostics &diagnostics)> &writer) {
	Diagnostics diagnostics;
	writer(from_godot(ProjectSettings::get_singleton()->globalize_path(path)), diagnostics);
	report(diagnostics);
	return diagnostics.has_errors() ? ERR_FILE_CANT_WRITE : OK;
}

} // namespace pcg
