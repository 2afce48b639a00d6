#include "core/agenda/repeated_diagnostics.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/agenda/context.h"
#include "core/agenda/requirement.h"

namespace pcg {

void RepeatedDiagnostics::add(Diagnostic diagnostic) {
	const auto found = std::find_if(_told.begin(), _told.end(), [&](const Told &other) { return agenda::is_repeat(other.first, diagnostic); });
	if (found != _told.end()) {
		++found->repeats;
	} else {
		_told.push_back({ std::move(diagnostic), 0 });
	}
}

void RepeatedDiagnostics::tell(Diagnostics &diagnostics) {
	const std::vector<Diagnostic> before = diagnostics.list();
	for (Told &one : _told) {
		const bool is_warning = one.first.severity == Severity::Warning;
		const bool is_known = std::any_of(before.begin(), before.end(),
				[&](const Diagnostic &other) { return other.severity == Severity::Warning && agenda::is_repeat(other, one.first); });
		if (is_warning && is_known) {
			continue;
		}
		// Of a warning an interpreter tells only the first; these are all told.
		const bool is_counted = !is_warning || is_told_of_all(one.first.id);
		if (one.repeats > 0 && is_counted) {
			one.first.message += ", and the same " + std::to_string(one.repeats) + (one.repeats == 1 ? " time more" : " times more");
		}
		diagnostics.add(std::move(one.first));
	}
	_told.clear();
}

} // namespace pcg
