#include "core/city/lot_messages.h"

namespace pcg {

void LotMessages::add(const std::string &lot_name, const Diagnostics &diagnostics) {
	for (const Diagnostic &diagnostic : diagnostics.list()) {
		add(lot_name, diagnostic);
	}
}

void LotMessages::add(const std::string &lot_name, Diagnostic diagnostic) {
	const auto [place, is_new] = _indices.emplace(to_text(diagnostic), _entries.size());
	if (is_new) {
		_entries.push_back({ std::move(diagnostic), lot_name, 0 });
	}
	++_entries[place->second].count;
}

void LotMessages::hand_over(Diagnostics &diagnostics) const {
	for (const Entry &entry : _entries) {
		Diagnostic diagnostic = entry.diagnostic;
		diagnostic.message = entry.first_lot + ": " + diagnostic.message;
		if (entry.count > 1) {
			diagnostic.message += " (and on " + std::to_string(entry.count - 1) + " other " + _noun + (entry.count > 2 ? "s)" : ")");
		}
		diagnostics.add(std::move(diagnostic));
	}
}

} // namespace pcg
