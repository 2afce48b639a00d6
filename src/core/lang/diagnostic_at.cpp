#include "core/lang/diagnostic_at.h"

namespace pcg {

Diagnostic diagnostic_at(const Program &program, uint32_t address, Severity severity, std::string_view id, std::string message, std::string hint) {
	const size_t instruction = address > 0 ? address - 1 : 0;
	const SourcePlace at = instruction < program.places.size() ? program.places[instruction] : SourcePlace();
	Diagnostic diagnostic = { severity, id, {}, at.line, at.column, std::move(message), std::move(hint), {} };
	if (at.line > 0 && at.file < program.files.size()) {
		diagnostic.file = program.files[at.file];
		diagnostic.source = program.sources[at.file]->excerpt(at.line, at.column);
	} else if (!program.files.empty()) {
		diagnostic.file = program.files[0];
	}
	return diagnostic;
}

} // namespace pcg
