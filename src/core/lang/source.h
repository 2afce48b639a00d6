#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/diagnostic.h"
#include "core/base/result.h"

// The text of one rule file with its lines.
namespace pcg {

class Source {
public:
	struct Position {
		uint32_t line = 1; // from 1
		uint32_t column = 1; // from 1, in characters
	};

	Source(std::string name, std::string text);

	const std::string &name() const { return _name; }
	std::string_view text() const { return _text; }
	Position position(uint32_t offset) const;
	// Without its line end; empty for lines that do not exist.
	std::string_view line(uint32_t line_number) const;
	// The line for a diagnostic's caret; empty where it is so long that showing it helps nobody.
	std::string excerpt(uint32_t line_number, uint32_t column) const;
	// A diagnostic at that offset, with the source line.
	Diagnostic diagnostic(Severity severity, std::string_view id, uint32_t offset, std::string message, std::string hint = {}) const;

private:
	std::string _name;
	std::string _text;
	std::vector<uint32_t> _line_starts;
	std::vector<uint32_t> _inner_bytes; // offsets of those that go on with a character
};

// Makes text of the bytes of a file: drops a byte order mark, reads what is not UTF-8 as Latin-1 with one warning. Refuses, with one error each,
// what is empty, binary or larger than 64 MiB. False: refused.
bool decode_rule_text(const std::string &name, std::string &bytes, Diagnostics &diagnostics);

// Where the text of rule files comes from: files, an engine's packed resources, a table in a test.
class SourceProvider {
public:
	virtual ~SourceProvider() = default;
	// The bytes, or why there are none (the diagnostic's message is shown at the import that asked).
	virtual Result<std::string> read(const std::string &path) = 0;
	virtual bool has(const std::string &path) { return bool(read(path)); }
};

// The path that `import` in the file `importer` means, without "." and ".." inside; schemes like res:// are kept.
std::string resolve_import(std::string_view importer, std::string_view path);

// The file that `import` means: with / in front it counts from the workspace, which is one of the folders above the importer (or the top of the file
// system); else it lies beside the importer, or in the rules folder of its project. If there is none, where it should lie first.
std::string find_import(SourceProvider &provider, const std::string &importer, std::string_view path);

} // namespace pcg
