#include "core/base/diagnostic.h"

#include <algorithm>
#include <cctype>
#include <tuple>

#include "core/base/utf8.h"

namespace pcg {

namespace {

// Long lines (minified or binary input) are cut around the caret to this many characters.
constexpr size_t max_excerpt = 160;

std::string place_text(const Diagnostic &diagnostic) {
	std::string text = diagnostic.file;
	if (diagnostic.line > 0) {
		text += ":" + std::to_string(diagnostic.line);
		if (diagnostic.column > 0) {
			text += ":" + std::to_string(diagnostic.column);
		}
	}
	return text;
}

void append_excerpt(std::string &text, const Diagnostic &diagnostic) {
	if (diagnostic.source.empty()) {
		return;
	}
	const size_t column = diagnostic.column > 0 ? diagnostic.column - 1 : 0;
	const size_t start = column > max_excerpt / 2 ? column - max_excerpt / 2 : 0;
	std::string_view shown = diagnostic.source;
	shown.remove_prefix(byte_of_character(shown, start));
	shown = shown.substr(0, byte_of_character(shown, max_excerpt));
	std::string line, caret;
	size_t at = start;
	for (char c : shown) {
		line += c != '\t' && std::iscntrl(static_cast<unsigned char>(c)) ? '?' : c;
		if (starts_character(c) && at++ < column) {
			caret += c == '\t' ? '\t' : ' ';
		}
	}
	text += "\n    " + line;
	if (diagnostic.column > 0) {
		text += "\n    " + caret + "^";
	}
}

constexpr size_t longest_name = 64; // beyond it no nearest name is looked for

// Optimal string alignment distance in half steps: a change of case or a swap costs 1, everything else 2. Above `most` it may be anything above: there
// may be a hundred thousand names to look at.
size_t edit_distance(std::string_view a, std::string_view b, size_t most) {
	if (2 * (std::max(a.size(), b.size()) - std::min(a.size(), b.size())) > most) {
		return most + 1;
	}
	size_t rows[3][longest_name + 1]; // in turn
	for (size_t j = 0; j <= b.size(); ++j) {
		rows[0][j] = 2 * j;
	}
	size_t least_before = 0;
	for (size_t i = 1; i <= a.size(); ++i) {
		const size_t *before = rows[(i + 1) % 3], *last = rows[(i + 2) % 3];
		size_t *row = rows[i % 3];
		size_t least = row[0] = 2 * i;
		for (size_t j = 1; j <= b.size(); ++j) {
			const char x = a[i - 1], y = b[j - 1];
			const bool same_letter = std::tolower(static_cast<unsigned char>(x)) == std::tolower(static_cast<unsigned char>(y));
			const size_t change = x == y ? 0 : (same_letter ? 1 : 2);
			row[j] = std::min({ last[j] + 2, row[j - 1] + 2, last[j - 1] + change });
			if (i > 1 && j > 1 && x == b[j - 2] && a[i - 2] == y) {
				row[j] = std::min(row[j], before[j - 2] + 1);
			}
			least = std::min(least, row[j]);
		}
		if (std::min(least, least_before) > most) { // a swap reaches over one row
			return most + 1;
		}
		least_before = least;
	}
	return rows[a.size() % 3][b.size()];
}

// "GoToPark" and "VisitPark" share a word of at least three letters: such names may differ more and still be meant.
bool shares_a_word(std::string_view a, std::string_view b) {
	for (size_t start = 0; start < a.size();) {
		size_t end = start + 1;
		while (end < a.size() && !std::isupper(static_cast<unsigned char>(a[end])) && a[end] != '_' && a[end] != '.') {
			++end;
		}
		if (end - start >= 3 && b.find(a.substr(start, end - start)) != std::string_view::npos) {
			return true;
		}
		start = end;
	}
	return false;
}

} // namespace

std::string to_text(const Diagnostic &diagnostic) {
	std::string text = place_text(diagnostic);
	if (!text.empty()) {
		text += ": ";
	}
	text += diagnostic.severity == Severity::Error ? "error: " : "warning: ";
	text += diagnostic.message;
	if (!diagnostic.id.empty()) {
		text += " [" + std::string(diagnostic.id) + "]";
	}
	append_excerpt(text, diagnostic);
	if (!diagnostic.hint.empty()) {
		text += "\n    " + diagnostic.hint;
	}
	return text;
}

std::string to_text(const Diagnostics &diagnostics) {
	std::string text;
	for (const Diagnostic &diagnostic : diagnostics.list()) {
		text += to_text(diagnostic) + "\n";
	}
	const size_t left_out = diagnostics.error_count() + diagnostics.warning_count() - diagnostics.list().size();
	if (left_out > 0) {
		text += "... and " + std::to_string(left_out) + " more\n";
	}
	return text;
}

void Diagnostics::add(Diagnostic diagnostic) {
	++(diagnostic.severity == Severity::Error ? _errors : _warnings);
	if (_list.size() < _limit) {
		_list.push_back(std::move(diagnostic));
		return;
	}
	// An error is never left out for the sake of a warning.
	const auto warning = std::find_if(_list.rbegin(), _list.rend(), [](const Diagnostic &d) { return d.severity == Severity::Warning; });
	if (diagnostic.severity == Severity::Error && warning != _list.rend()) {
		_list.erase(std::next(warning).base());
		_list.push_back(std::move(diagnostic));
	}
}

bool Diagnostics::is_full(Severity severity) const {
	const auto is_warning = [](const Diagnostic &diagnostic) { return diagnostic.severity == Severity::Warning; };
	return _list.size() >= _limit && (severity == Severity::Warning || std::none_of(_list.begin(), _list.end(), is_warning));
}

void Diagnostics::append(const Diagnostics &other) {
	const size_t left_out_errors =
			other._errors - size_t(std::count_if(other._list.begin(), other._list.end(),
									[](const Diagnostic &d) { return d.severity == Severity::Error; }));
	const size_t left_out = other._errors + other._warnings - other._list.size();
	for (const Diagnostic &diagnostic : other._list) {
		add(diagnostic);
	}
	_errors += left_out_errors;
	_warnings += left_out - left_out_errors;
}

void Diagnostics::sort() {
	std::vector<std::string> files;
	for (const Diagnostic &diagnostic : _list) {
		if (std::find(files.begin(), files.end(), diagnostic.file) == files.end()) {
			files.push_back(diagnostic.file);
		}
	}
	const auto rank = [&](const Diagnostic &diagnostic) {
		return std::tuple(std::find(files.begin(), files.end(), diagnostic.file), diagnostic.line, diagnostic.column);
	};
	std::stable_sort(_list.begin(), _list.end(), [&](const Diagnostic &a, const Diagnostic &b) { return rank(a) < rank(b); });
}

void Diagnostics::error(std::string_view id, std::string message, std::string hint) {
	add({ Severity::Error, id, {}, 0, 0, std::move(message), std::move(hint), {} });
}

void Diagnostics::warning(std::string_view id, std::string message, std::string hint) {
	add({ Severity::Warning, id, {}, 0, 0, std::move(message), std::move(hint), {} });
}

std::string_view closest_name(std::string_view name, const std::vector<std::string_view> &candidates) {
	std::string_view best;
	// Half steps. A third of the letters may differ (at least one), two thirds where a whole word is shared; of a single letter only its case.
	size_t best_distance = 0xFFFF;
	for (std::string_view candidate : candidates) {
		if (candidate.size() > longest_name || name.size() > longest_name) {
			continue;
		}
		const size_t letters = shares_a_word(name, candidate) ? name.size() * 2 / 3 : name.size() / 3;
		const size_t allowed = std::min(name.size() == 1 ? 1 : 2 * (letters > 0 ? letters : 1), best_distance - 1);
		const size_t distance = edit_distance(name, candidate, allowed);
		if (distance <= allowed) {
			best_distance = distance;
			best = candidate;
		}
		if (best_distance == 0) {
			break;
		}
	}
	return best;
}

} // namespace pcg
