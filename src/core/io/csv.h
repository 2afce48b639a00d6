#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/diagnostic.h"

// Comma-separated tables (RFC 4180) with a header; semicolons and tabs are understood as well. Lines that begin with # are remarks.
namespace pcg {

struct CsvField {
	std::string text; // without quotes and outer spaces
	uint32_t offset = 0; // bytes from the beginning of the row
};

struct CsvRow {
	uint32_t line = 0;
	std::string source; // the line, for messages
	std::vector<CsvField> fields;
};

struct CsvTable {
	std::string file;
	CsvRow header;
	std::vector<CsvRow> rows; // as many fields each as the header

	// -1 if there is none; lower case and with underscores, as in "min_age".
	int find_column(std::string_view name) const;
	Diagnostic at(const CsvRow &row, size_t field, std::string_view id, std::string message, std::string hint) const;
};

// Nothing, with one error, if the text is empty or binary, or the first line cannot be read. Rows that do not fit it, or whose quotes are not in pairs,
// are errors too, and left out: whoever reads the others can tell what is wrong with those at the same time. There may be none.
std::optional<CsvTable> parse_csv(std::string_view text, std::string_view file, Diagnostics &diagnostics);
// The same for a file; it may be missing, a folder or larger than 256 MB too.
std::optional<CsvTable> read_csv(const std::string &path, Diagnostics &diagnostics);
// What `read` makes of the table, or nothing after errors. `found`: what was told of this table, and is told by `read`; it goes to `diagnostics` in order.
template <typename Read>
std::optional<std::invoke_result_t<Read, CsvTable &>> read_records(
		std::optional<CsvTable> csv, Diagnostics &found, Diagnostics &diagnostics, Read read) {
	std::optional<std::invoke_result_t<Read, CsvTable &>> records;
	if (csv) {
		records = read(*csv);
	}
	found.sort();
	diagnostics.append(found);
	return found.has_errors() ? std::nullopt : std::move(records);
}

// False if there are none: an error, unless errors tell it already.
bool has_rows(const CsvTable &table, Diagnostics &diagnostics);

constexpr size_t max_table_problems = 20; // that are told of one table; the rest is counted

// The field with quotes where it needs them.
std::string csv_quoted(std::string_view text);

} // namespace pcg
