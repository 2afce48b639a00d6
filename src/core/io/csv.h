#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

// Comma-separated tables (RFC 4180) with a header; semicolons and tabs are understood as well. Lines that begin with # are remarks.
namespace pcg {

struct CsvField {
	std::string text; // without quotes and outer spaces
	uint32_t column = 0; // of its first character in the line, from 1
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

// One message if the text is empty, binary, without rows, or a row does not fit the header.
Result<CsvTable> parse_csv(std::string_view text, std::string_view file);
// The same for a file; it may be missing, a folder or larger than 256 MB too.
Result<CsvTable> read_csv(const std::string &path);

// The field with quotes where it needs them.
std::string csv_quoted(std::string_view text);

} // namespace pcg
