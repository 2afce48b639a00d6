#include "godot/report.h"

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

} // namespace pcg
