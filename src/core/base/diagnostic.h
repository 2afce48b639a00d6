#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

// What went wrong, where, and what to do about it, as a value: nothing in the core prints.
namespace pcg {

enum class Severity : uint8_t { Warning, Error };

// `id` is a short kebab-case name that stays the same when the wording changes ("unknown-name"); tests and filters use it.
// Line and column count from 1, 0 = unknown; the column counts characters. `source` is the text of that line, for the caret.
struct Diagnostic {
	Severity severity = Severity::Error;
	std::string_view id; // a string literal
	std::string file;
	uint32_t line = 0;
	uint32_t column = 0;
	std::string message;
	std::string hint; // what to do; may be empty
	std::string source;
};

// "file:12:5: error: ... [unknown-name]", then the source line with a caret and the hint, each on a line of its own.
std::string to_text(const Diagnostic &diagnostic);

// Many diagnostics of one run. Keeps the first `limit` (errors rather than warnings), counts all.
class Diagnostics {
public:
	explicit Diagnostics(size_t limit = 200) : _limit(limit) {}

	void add(Diagnostic diagnostic);
	void append(const Diagnostics &other);
	// By line and column within each file; files stay in the order in which they came first.
	void sort();
	// For messages that have no place in a file.
	void error(std::string_view id, std::string message, std::string hint = {});
	void warning(std::string_view id, std::string message, std::string hint = {});

	const std::vector<Diagnostic> &list() const { return _list; }
	size_t error_count() const { return _errors; }
	size_t warning_count() const { return _warnings; }
	bool has_errors() const { return _errors > 0; }
	bool is_empty() const { return _errors + _warnings == 0; }
	// Whether one more would only be counted: its words need no work.
	bool is_full(Severity severity) const;

private:
	size_t _limit;
	size_t _errors = 0;
	size_t _warnings = 0;
	std::vector<Diagnostic> _list;
};

// All of them, and a last line that counts what was left out, if anything was.
std::string to_text(const Diagnostics &diagnostics);

// The candidate closest to `name` by edit distance (case changes and swaps cost little), or empty when none is close enough to suggest.
std::string_view closest_name(std::string_view name, const std::vector<std::string_view> &candidates);

} // namespace pcg
